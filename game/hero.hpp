/// The hero: what a player may press, what body the hero has, and how it fares.
#pragma once

#include <cstdint>
#include <span>
#include <type_traits>

#include <surefoot/character.hpp>

namespace surefoot::game {

inline constexpr double tick_seconds = 1.0 / 60;
inline constexpr double run_speed = 6.5;  ///< [m/s]
inline constexpr double swim_speed = 4;   ///< [m/s]
inline constexpr int most_health = 3;     ///< in hearts

/// What is held in a tick. All that a run is made of: a recording is a list of these.
struct HeroInput {
    /// Where to, in the level's axes: x and z [-1 to 1; longer than 1 counts as 1]. Whoever has a camera turns the
    /// stick by it first.
    float move_x = 0;
    float move_z = 0;
    /// Where the player looks: the rules do not ask, telemetry does [degrees; yaw 0 looks along -Z, 90 along -X].
    float look_yaw_deg = 0;
    float look_pitch_deg = 0;
    std::uint8_t buttons = 0;  ///< of `Button`
    std::uint8_t reserved[3] = {};

    friend bool operator==(const HeroInput&, const HeroInput&) = default;
};
static_assert(std::is_trivially_copyable_v<HeroInput> && sizeof(HeroInput) == 20);

enum class Button : std::uint8_t { jump = 1, crouch = 2, dash = 4 };

[[nodiscard]] constexpr bool holds(const HeroInput& input, Button button) {
    return (input.buttons & static_cast<std::uint8_t>(button)) != 0;
}
constexpr void press(HeroInput& input, Button button) {
    input.buttons = static_cast<std::uint8_t>(input.buttons | static_cast<std::uint8_t>(button));
}

/// The body and everything it can do. `rules` has to outlive the settings.
[[nodiscard]] CharacterSettings hero_settings(std::span<const SurfaceRule> rules);

struct Hero {
    CharacterState body{};
    CharacterEvents events{};  ///< of the last tick
    int health = most_health;
    double safe_for = 0;     ///< nothing hurts it for so long [s]
    double bounce = 0;       ///< upwards, in the next tick [m/s]
    dvec3 knock{0, 0, 0};    ///< added to its velocity in the next tick [m/s]
    double leaps_for = 0;    ///< out of the water: it counts as in the air for so long [s]
    double stuck_for = 0;    ///< inside of something without a way out [s]
    dvec3 facing{0, 0, -1};  ///< level, unit: where it turns its face
    std::uint8_t held = 0;   ///< the buttons of the last tick
    bool in_water = false;
    bool slides = false;  ///< crouched and fast
};

/// What a level needs of the rules: how the hero's wish becomes what `step` is told, given where it is.
/// `under_water`: the middle of the body is; `near_surface`: and the air is within reach of a leap.
struct HeroPlace {
    bool under_water = false;
    bool near_surface = false;
};
[[nodiscard]] CharacterInput told(Hero& hero, const HeroInput& input, const HeroPlace& place,
                                  const CharacterSettings& settings);

/// The settings of this tick: those of a hero that slides hold it less.
[[nodiscard]] CharacterSettings settings_now(const CharacterSettings& settings, const Hero& hero);

/// From the reference point to the feet of a body that stands or crouches [m].
[[nodiscard]] double feet_below(const CharacterSettings& settings, CharacterForm form);

}  // namespace surefoot::game
