/// How a hero holds itself: places of its parts about the soles of its feet, and one stance for each thing that it
/// does.
#pragma once

#include <cstdint>

#include <surefoot/math.hpp>

namespace surefoot::platformer {

/// What a hero does, as far as one sees it.
enum class HeroAct : std::uint8_t {
    idle,
    run,
    jump,
    fall,
    crouch,
    slide,
    hang,
    climb,
    wall_slide,
    swim,
    ladder,
    dash,
    hurt,
    dead,
    win,
};
inline constexpr int hero_act_count = 15;

/// Left and right.
inline constexpr int on_left = 0;
inline constexpr int on_right = 1;

/// In metres and radians; X to the left, Y up from the soles, Z where it faces. Nothing but doubles, so that stances
/// can be mixed.
struct Stance {
    dvec3 body{0, 0.60, 0};  ///< of its middle
    double pitch = 0;        ///< of the body, forward
    double roll = 0;         ///< to the left
    double twist = 0;        ///< to the left
    dvec3 head{0, 0, 0};     ///< off its place on the neck
    double head_pitch = 0;
    double head_yaw = 0;
    double head_roll = 0;
    dvec3 hands[2] = {{0.31, 0.52, 0.05}, {-0.31, 0.52, 0.05}};
    dvec3 feet[2] = {{0.13, 0, 0}, {-0.13, 0, 0}};
    double toes[2] = {0, 0};  ///< how far the toes point down
    double ears = 0;          ///< laid back [0 to 1]
    double eyes = 1;          ///< open [0 to 1]
    double tail = 0;          ///< raised [rad]
    dvec3 stretch{1, 1, 1};   ///< of all but the feet
};

[[nodiscard]] Stance mixed(const Stance& a, const Stance& b, double share);

/// What a stance depends on.
struct StanceMoment {
    double time = 0;       ///< since the act began [s]
    double clock = 0;      ///< since the figure is there [s]
    double stride = 0;     ///< how many pairs of steps were made so far
    double speed = 0;      ///< over the ground, or through the water [m/s]
    double rise = 0;       ///< upwards [m/s]
    double wall_side = 1;  ///< 1: the wall is to the left, -1: to the right
    bool reduced_motion = false;
};

[[nodiscard]] Stance stance_of(HeroAct act, const StanceMoment& moment);

/// How far one pair of steps reaches at this speed [m].
[[nodiscard]] double stride_length(double speed);

/// For which share of a stride a foot is on the ground.
[[nodiscard]] double ground_share(double speed);

}  // namespace surefoot::platformer
