// What moves: a ferry, a lift, and a player for tests who knows how to ride them.
#pragma once

#include <cstdint>
#include <vector>

#include "level.hpp"

namespace day {

// [mover]
struct Mover {
    surefoot::BodyHandle body;
    std::uint32_t id;  // what a character's `ground_body` says when it stands on it
    dvec3 from, to;
};

constexpr std::uint64_t travel_ticks = 180;
constexpr std::uint64_t wait_ticks = 90;

/// Where it is at the end of a tick: waits, goes, waits, comes back. A function of the tick and of nothing else.
inline dvec3 place_of(const Mover& mover, std::uint64_t tick) {
    const std::uint64_t half = wait_ticks + travel_ticks;
    const std::uint64_t in_half = tick % half;
    const double way = in_half < wait_ticks ? 0 : double(in_half - wait_ticks) / double(travel_ticks);
    const bool goes_back = tick / half % 2 == 1;
    return glm::mix(mover.from, mover.to, goes_back ? 1 - way : way);
}
// [/mover]

// [add]
inline std::vector<Mover> add_movers(surefoot::World& world, const Level& level) {
    std::vector<Mover> movers;
    for (const Platform& platform : level.platforms)
        if (const auto body = world.add(platform.mesh, {.pose = {.position = platform.from}}))
            movers.push_back({*body, world.poses(*body).body, platform.from, platform.to});
    return movers;
}

/// Begins a tick of the world: each goes from where it is to where it is to be.
inline void move_all(surefoot::World& world, const std::vector<Mover>& movers, std::uint64_t tick) {
    world.begin_tick();
    for (const Mover& mover : movers) (void)world.move(mover.body, {.position = place_of(mover, tick)});
}
// [/add]

}  // namespace day
