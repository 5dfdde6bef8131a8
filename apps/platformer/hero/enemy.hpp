/// The drawn enemies: four kinds, each told apart by its outline and its colour, each with what it is about to do in
/// its bearing.
#pragma once

#include <cstdint>
#include <vector>

#include <surefoot/math.hpp>

#include "view/renderer.hpp"

namespace surefoot::platformer {

enum class EnemyKind : std::uint8_t {
    chaser,     ///< a round beetle, crimson
    patroller,  ///< a lantern on legs, violet, whose light says what it sees
    jumper,     ///< a frog on a spring, lime
    shooter,    ///< a flower in a pot, blue, whose bud opens before it fires
};

enum class EnemyMood : std::uint8_t {
    idle,
    notice,   ///< has just seen the hero
    attack,   ///< after it, or about to fire
    stomped,  ///< gone, flat
};

/// What is known about an enemy in one tick.
struct EnemySight {
    dvec3 soles{0, 0, 0};     ///< the lowest point of its volume, in the world [m]
    dvec3 velocity{0, 0, 0};  ///< [m/s]
    dvec3 looks_at{0, 0, 0};  ///< of use while it notices or attacks [m]
    bool on_ground = true;
    EnemyMood mood = EnemyMood::idle;
    bool fires = false;  ///< in this tick
};

struct EnemyPose {
    EnemyKind kind = EnemyKind::chaser;
    dvec3 soles{0, 0, 0};
    double facing = 0;  ///< [rad]
    EnemyMood mood = EnemyMood::idle;
    double mood_time = 0;  ///< since it came into this mood [s]
    double clock = 0;      ///< [s]
    double stride = 0;     ///< how far it walked [m]
    double squash = 0;     ///< how much taller than usual
    double squash_speed = 0;
    double alarm = 0;         ///< how much its bearing says that it attacks [0 to 1]
    double since_fire = 1e9;  ///< [s]
    double pitch = 0;         ///< how high it aims [rad]
    bool on_ground = true;
    bool reduced_motion = false;
};

/// How long a stomped one is still seen [s].
inline constexpr double stomped_time = 0.7;

[[nodiscard]] EnemyPose enemy_at(EnemyKind kind, const dvec3& soles, double facing, double clock = 0);

/// On by `dt` seconds.
[[nodiscard]] EnemyPose advance(const EnemyPose& pose, const EnemySight& sight, bool reduced_motion, double dt);

/// Between two ticks, for drawing.
[[nodiscard]] EnemyPose between(const EnemyPose& a, const EnemyPose& b, double share);

void add_pieces(std::vector<view::Piece>& pieces, const EnemyPose& pose);

void draw(view::Renderer& renderer, const EnemyPose& before, const EnemyPose& after, double blend);

}  // namespace surefoot::platformer
