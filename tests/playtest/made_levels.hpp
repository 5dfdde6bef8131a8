/// Levels in code for bots: each with what its name says.
#pragma once

#include "level_maker.hpp"
#include "playtest/bots/atlas.hpp"
#include "playtest/bots/navigator.hpp"
#include "playtest/run.hpp"

namespace surefoot::test {

/// A gap for one jump, a gap for two, a lift that goes up five metres, a key aside, its door, the goal.
inline std::shared_ptr<const game::Level> gaps_lift_key_and_door() {
    LevelMaker maker;
    maker.clear();
    maker.box({-3, -1, -4}, {3, 0, 4});
    maker.box({-3, -1, -14}, {3, 0, -6.5});  // over 2.5 m
    maker.box({-3, -1, -26}, {3, 0, -19});   // over 5 m
    maker.body(game::BodyKind::platform, {0, -0.25, -28}, {1.8, 0.25, 1.8}).route = {
        .stops = {{0, 0, 0}, {0, 5, 0}}, .speed = 2.5, .pause = 1};
    maker.level->bodies.back().name = "lift";
    maker.box({-3, 4, -48}, {3, 5, -30});
    maker.box({4.5, 4, -40}, {10, 5, -34});       // aside, over 1.5 m: the key
    maker.box({-12, 4, -42.5}, {-1.2, 12, -42});  // a wall that nobody gets around
    maker.box({1.2, 4, -42.5}, {20, 12, -42});
    maker.box({-1.2, 9, -42.5}, {1.2, 12, -42});
    maker.body(game::BodyKind::door, {0, 7, -42.25}, {1.2, 2, 0.2}).door = "red";
    maker.level->pickups.push_back({game::PickupKind::key, {8, 6, -37}, "red"});
    maker.level->pickups.push_back({game::PickupKind::coin, {0, 0.9, -10}, {}});
    maker.level->checkpoints.push_back({.feet = {0, 0, -23}, .section = "the lift", .order = 1});
    maker.level->checkpoints.push_back({.feet = {0, 5, -33}, .section = "the door", .order = 2});
    maker.level->goal = {0, 5, -46};
    return maker.finish();
}

/// The goal stands in a room without a door, with walls higher than anybody jumps.
inline std::shared_ptr<const game::Level> walled_off() {
    LevelMaker maker;
    maker.box({10, 0, 10}, {19, 7, 10.5});
    maker.box({10, 0, 18.5}, {19, 7, 19});
    maker.box({10, 0, 10}, {10.5, 7, 19});
    maker.box({18.5, 0, 10}, {19, 7, 19});
    maker.box({10, 7, 10}, {19, 7.5, 19});
    maker.level->goal = {14.5, 0, 14.5};
    return maker.finish();
}

/// Who falls into the pit in the middle does not get out, and does not die either.
inline std::shared_ptr<const game::Level> pit() {
    LevelMaker maker;
    maker.clear();
    maker.box({-12, -9, -12}, {12, -8, 12});
    maker.box({-12, -9, -12}, {12, 0, -0.45});
    maker.box({-12, -9, 0.45}, {12, 0, 12});
    maker.box({-12, -9, -0.45}, {-0.45, 0, 0.45});
    maker.box({0.45, -9, -0.45}, {12, 0, 0.45});
    maker.level->kill_y = -20;
    maker.level->checkpoints.front().feet = {0, -8, 0};
    maker.level->goal = {8, 0, 8};
    return maker.finish();
}

inline std::shared_ptr<const playtest::Atlas> atlas_of(const std::shared_ptr<const game::Level>& level) {
    auto atlas = playtest::Atlas::make(level, {.use_cache = false});
    EXPECT_TRUE(atlas) << atlas.error().text;
    return *atlas;
}

inline std::unique_ptr<playtest::Navigator> navigator(const std::shared_ptr<const playtest::Atlas>& atlas,
                                                      std::uint64_t seed = 1) {
    auto made = playtest::Navigator::make(atlas, {.seed = seed});
    EXPECT_TRUE(made) << made.error().text;
    return std::move(*made);
}

}  // namespace surefoot::test
