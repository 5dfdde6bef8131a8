/// The drawn hero, as plain data: what it looks like follows from what its volume does, and from nothing else.
#pragma once

#include <array>
#include <cstddef>

#include <surefoot/character.hpp>

#include "platformer/hero/feet.hpp"
#include "platformer/hero/frame.hpp"
#include "platformer/hero/scarf.hpp"
#include "platformer/hero/stance.hpp"

namespace surefoot::platformer {

/// What the state of a character does not say.
struct HeroFlags {
    bool under_water = false;
    bool hurt = false;         ///< something hurt it in this tick
    bool untouchable = false;  ///< it was hurt a moment ago and blinks
    bool dead = false;
    bool won = false;
    bool reduced_motion = false;  ///< no squash, no after-images
    double turned_by = 0;         ///< by what carries it, in this tick [rad]
};

/// What a dash leaves behind.
struct AfterImage {
    Frame body{};
    Stance stance{};
    double age = 1e9;  ///< [s]
};
inline constexpr std::size_t after_image_count = 4;
inline constexpr double after_image_time = 0.28;  ///< until one is gone [s]

struct HeroPose {
    dvec3 soles{0, 0, 0};     ///< the lowest point of the volume, in the world [m]
    double facing = 0;        ///< about up: 0 looks along Z, a quarter turn along X [rad]
    dvec3 velocity{0, 0, 0};  ///< as it was in the last tick, relative to what carries it [m/s]
    double lean_forward = 0;  ///< [rad]
    double lean_left = 0;
    double squash = 0;  ///< how much taller than usual: below 0 is flatter [-0.4 to 0.35]
    double squash_speed = 0;
    double flip = 0;       ///< what is left of a somersault [rad]
    double look_left = 0;  ///< of the head, to where it is going [rad]
    double look_up = 0;
    HeroAct act = HeroAct::idle;
    double act_time = 0;  ///< since that began [s]
    double clock = 0;     ///< since there is a pose [s]
    double stride = 0;    ///< how many pairs of steps, of strokes or of rungs
    double shimmy = 0;    ///< the same along a ledge, to the left [pairs of grips]
    double wall_side = 1;
    double since_hurt = 1e9;  ///< [s]
    bool untouchable = false;
    bool reduced_motion = false;
    Stance stance{};
    Feet feet{};
    Scarf scarf{};
    std::array<AfterImage, after_image_count> images{};
    double since_image = 1e9;
};

/// Stands there at once.
[[nodiscard]] HeroPose hero_at(const CharacterState& state, const CharacterSettings& settings, double facing = 0);

/// On by one tick of `dt` seconds, in which the character went from `before` to `after`. After a jump of more than
/// `teleport_distance` it stands there at once.
[[nodiscard]] HeroPose advance(const HeroPose& pose, const CharacterState& before, const CharacterState& after,
                               const CharacterEvents& events, const CharacterSettings& settings, const HeroFlags& flags,
                               double dt);
inline constexpr double teleport_distance = 3;  ///< [m]

/// Between two ticks, for drawing.
[[nodiscard]] HeroPose between(const HeroPose& a, const HeroPose& b, double share);

/// The figure's axes about its soles, without lean and squash.
[[nodiscard]] Frame standing_frame(const HeroPose& pose);

/// How far the lowest point of the volume is under its reference point [m].
[[nodiscard]] double half_height_of(const CharacterSettings& settings, CharacterForm form);

}  // namespace surefoot::platformer
