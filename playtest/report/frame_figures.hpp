/// What stands in a level and is no ground, as small meshes for frames: the hero, enemies, coins, flags, the goal.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>

#include <surefoot/mesh.hpp>
#include <surefoot/world.hpp>

#include "game/game.hpp"

namespace surefoot::playtest {

/// What a triangle of a figure looks like: as displayed [0 to 1 each], and how much of it shines by itself.
struct Paint {
    dvec3 colour{0, 0, 0};
    double glow = 0;
};

/// The paint of a surface number of a figure.
[[nodiscard]] const Paint& paint_of(std::uint32_t surface);

/// The figures of one level, to be placed anew for each frame.
class Figures {
public:
    explicit Figures(const game::Level& level);

    /// Everything as it is in the game now, with the level's decor as the body `decor`, and the hero as the body
    /// `hero`. `trail`: places where the hero has been, as dots.
    [[nodiscard]] World stage(const game::Game& game, std::span<const dvec3> trail) const;

    static constexpr std::uint32_t hero = 0;
    static constexpr std::uint64_t solid = 1;
    static constexpr std::uint64_t marks = 2;

private:
    std::array<Mesh, 2> hero_;  // upright and crouched
    std::array<Mesh, 4> enemies_;
    std::array<Mesh, 3> pickups_;
    std::map<std::string, Mesh> keys_;  // by door
    std::array<Mesh, 2> flags_;         // not reached, and reached
    Mesh goal_;
    Mesh bullet_;
    Mesh dot_;
};

}  // namespace surefoot::playtest
