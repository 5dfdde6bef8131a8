/// What happened in a tick, for whoever shows it, sounds it or counts it. The rules never read it.
#pragma once

#include <cstdint>
#include <string_view>

#include <surefoot/math.hpp>

namespace surefoot::game {

enum class Happening : std::uint8_t {
    jumped,
    air_jumped,
    wall_jumped,
    dashed,
    landed,  ///< `strength`: how fast it came down [m/s]
    grabbed_ledge,
    climbed,  ///< over an edge
    splashed_in,
    splashed_out,
    bounced,
    took_coin,  ///< `number`: how many it has now
    took_star,
    took_heart,
    took_key,
    door_opened,
    checkpoint,  ///< `number`: its order
    crumbling,
    crumbled,
    crumble_back,
    hurt,  ///< `number`: hearts; `cause`
    fell,  ///< below the level, or out of it: a heart, and back to the checkpoint
    respawned,
    stomped,
    enemy_noticed,
    enemy_jumped,
    shot,
    shot_gone,
    won,
    lost,
};

enum class Cause : std::uint8_t { none, fall, deadly, hazard, crushed, chaser, patroller, jumper, shot, time, gave_up };

struct GameEvent {
    Happening what = Happening::jumped;
    Cause cause = Cause::none;
    dvec3 place{0, 0, 0};
    double strength = 0;
    std::uint32_t number = 0;
    std::uint32_t surface = 0;  ///< of the ground, where there is one
};

[[nodiscard]] std::string_view name_of(Happening what);

/// "fell out of the level", "was caught by a chaser": what the lose screen and the report say.
[[nodiscard]] std::string_view sentence(Cause cause);

}  // namespace surefoot::game
