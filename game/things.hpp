/// What lives in a game, in its pools.
#pragma once

#include <cstdint>

#include <surefoot/character.hpp>
#include <surefoot/pose.hpp>
#include <surefoot/world.hpp>

#include "game/level.hpp"

namespace surefoot::game {

/// A part of the level that moves, crumbles, opens or throws.
struct MovingBody {
    std::uint32_t plan = 0;  ///< of `Level::bodies`
    BodyHandle handle{};
    std::uint32_t body = 0;  ///< its number in the world
    Pose before{};           ///< where it was when the tick began
    Pose now{};
    double clock = 0;      ///< of its route [s]
    bool runs = false;     ///< its route: at once, or since somebody stood on it
    bool is_there = true;  ///< solid, and to be drawn
    double since = 0;      ///< crumbling: since the first foot; gone: since then; a door: since it opens [s]
    enum class Phase : std::uint8_t { rest, shakes, gone, opens, open } phase = Phase::rest;
};

struct Pickup {
    std::uint32_t plan = 0;  ///< of `Level::pickups`
};

struct Enemy {
    enum class Mood : std::uint8_t { calm, notices, hunts, returns, stunned };

    std::uint32_t plan = 0;  ///< of `Level::enemies`
    CharacterState before{};
    CharacterState body{};
    CharacterEvents events{};
    dvec3 facing{0, 0, -1};
    Mood mood = Mood::calm;
    double since = 0;        ///< in this mood [s]
    std::uint32_t stop = 0;  ///< of its route: where it goes
    double reload = 0;       ///< until it may shoot or jump again [s]
    std::uint32_t mind = 0;  ///< its place among the game's followers
};

struct Bullet {
    dvec3 before{0, 0, 0};
    dvec3 place{0, 0, 0};
    dvec3 velocity{0, 0, 0};
    double age = 0;  ///< [s]
};

}  // namespace surefoot::game
