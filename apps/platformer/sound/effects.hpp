/// Every sound that the game makes, but its music.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "platformer/sound/samples.hpp"

namespace surefoot::sound {

enum class Effect : std::uint8_t {
    step_stone,
    step_grass,
    step_wood,
    step_metal,
    step_water,
    step_ice,
    jump,
    double_jump,
    wall_jump,
    land_soft,
    land_hard,
    dash,
    grab,
    climb,
    slide,  ///< half a second of it, without a beginning or an end: play it again every 0.3 s
    splash,
    coin,
    star,
    key,
    door,
    checkpoint,
    heart,
    bounce,
    crumble,
    hurt,
    death,
    stomp,
    enemy_notice,
    shot,
    win,
    lose,
    menu_move,
    menu_choose,
    pause,
};

inline constexpr int effect_count = static_cast<int>(Effect::pause) + 1;

/// What is underfoot, as steps sound.
enum class Ground : std::uint8_t { stone, grass, wood, metal, water, ice };

[[nodiscard]] constexpr Effect step_on(Ground ground) {
    return static_cast<Effect>(static_cast<int>(Effect::step_stone) + static_cast<int>(ground));
}

/// As it is written above.
[[nodiscard]] std::string_view name_of(Effect effect);
[[nodiscard]] std::optional<Effect> effect_named(std::string_view name);

/// How many different ones of it are worth having: what is heard often must not sound like a machine.
[[nodiscard]] int variations_of(Effect effect);

/// The sound itself. Any number is a variation, and the same number the same samples. Guarantees: it begins and ends at
/// zero and no sample passes 0.9.
[[nodiscard]] Samples make(Effect effect, int variation = 0);

}  // namespace surefoot::sound
