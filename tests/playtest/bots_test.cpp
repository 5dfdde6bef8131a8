#include <algorithm>
#include <gtest/gtest.h>

#include "made_levels.hpp"
#include "playtest/bots/explorer.hpp"

namespace surefoot::playtest {
namespace {

using test::atlas_of;
using test::navigator;

TEST(Navigator, finishes_a_level_in_code_with_gaps_a_lift_a_key_and_a_door) {
    const auto level = test::gaps_lift_key_and_door();
    const auto atlas = atlas_of(level);
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const auto bot = navigator(atlas, seed);
        const auto run = play(level, *bot, {.most_seconds = 240});
        ASSERT_TRUE(run);
        EXPECT_TRUE(run->telemetry.won) << "seed " << seed << ": " << bot->gave_up() << "; " << bot->doing();
        EXPECT_TRUE(run->telemetry.section_reached[2]);
        EXPECT_NE(std::ranges::find(run->telemetry.taken, 0U), run->telemetry.taken.end()) << "the key comes first";
    }
}

TEST(Navigator, climbs_a_ladder) {
    test::LevelMaker maker;
    maker.level->rules[1].ladder = true;
    maker.level->materials[1].deadly = false;
    maker.box({-2, 0, -10}, {2, 6, -6});
    maker.box({-0.6, 0, -6.05}, {0.6, 6, -5.9}, 1);
    maker.level->ways.push_back({.how = game::Manoeuvre::climb, .from = {0, 0, -5.4}, .to = {0, 6, -7}});
    maker.level->goal = {0, 6, -9};
    const auto level = maker.finish();
    const auto bot = navigator(atlas_of(level));
    const auto run = play(level, *bot, {.most_seconds = 60});
    ASSERT_TRUE(run);
    EXPECT_TRUE(run->telemetry.won) << bot->gave_up() << "; " << bot->doing();
}

TEST(Navigator, says_at_once_that_a_goal_that_is_walled_off_is_out_of_reach) {
    const auto bot = navigator(atlas_of(test::walled_off()));
    EXPECT_EQ(bot->gave_up().substr(0, 16), "goal unreachable") << bot->gave_up();
}

TEST(Navigator, says_so_too_of_a_goal_behind_a_door_whose_key_lies_behind_it) {
    test::LevelMaker maker;
    maker.clear();
    maker.box({-3, -1, -4}, {3, 0, 4});
    maker.box({-1.2, -1, -30}, {1.2, 0, -4});
    maker.box({-6, -1, -10.2}, {-1.1, 9, -9.8});
    maker.box({1.1, -1, -10.2}, {6, 9, -9.8});
    maker.box({-6, 4, -10.2}, {6, 9, -9.8});
    maker.body(game::BodyKind::door, {0, 2, -10}, {1.3, 2, 0.25}).door = "red";
    maker.level->pickups.push_back({game::PickupKind::key, {0, 1, -20}, "red"});
    maker.level->goal = {0, 0, -28};
    const auto bot = navigator(atlas_of(maker.finish()));
    EXPECT_EQ(bot->gave_up().substr(0, 16), "goal unreachable") << bot->gave_up();
}

TEST(Navigator, lets_go_of_an_edge_that_it_cannot_climb_over) {
    test::LevelMaker maker;
    maker.box({-3, 0, -8}, {3, 2.4, -4});
    maker.box({-3, 2.8, -8}, {3, 4, -4.0});  // no room to stand above the edge
    const auto level = maker.finish();
    const auto game = *game::Game::start(level);
    while (game->hero().body.footing != Footing::ledge && game->seconds() < 5) {
        game::HeroInput input{.move_z = -1};
        if (game->feet().z < -2.5) press(input, game::Button::jump);
        game->tick(input);
    }
    ASSERT_EQ(game->hero().body.footing, Footing::ledge);
    const auto bot = navigator(atlas_of(level));
    while (game->outcome() == game::Outcome::playing && game->seconds() < 30) game->tick(bot->decide(*game));
    EXPECT_EQ(game->outcome(), game::Outcome::won) << bot->doing();
}

TEST(Navigator, finishes_by_its_recording_alone) {
    const auto level = test::gaps_lift_key_and_door();
    const auto bot = navigator(atlas_of(level), 5);
    const auto run = play(level, *bot, {.most_seconds = 240});
    ASSERT_TRUE(run);
    ASSERT_TRUE(run->telemetry.won) << bot->gave_up();
    std::uint64_t diverged = 1;
    const auto again = replay(level, run->recording, &diverged);
    ASSERT_TRUE(again) << again.error().text;
    EXPECT_TRUE(again->won);
    EXPECT_EQ(diverged, 0U);
    EXPECT_EQ(again->seconds, run->telemetry.seconds);
    EXPECT_EQ(to_json(*again), to_json(run->telemetry));
}

// Two islands over the deep, three metres apart, and coins in the air.
std::shared_ptr<const game::Level> coins_in_the_air(const std::vector<dvec3>& coins) {
    test::LevelMaker maker;
    maker.clear();
    maker.box({-4, -1, -6}, {4, 0, 4});
    maker.box({-4, -1, -20}, {4, 0, -9});
    for (const dvec3& coin : coins) maker.level->pickups.push_back({game::PickupKind::coin, coin, {}});
    maker.level->goal = {0, 0, -18};
    return maker.finish();
}

std::vector<std::uint32_t> taken_by_a_collector(const std::shared_ptr<const game::Level>& level) {
    const auto bot = Navigator::make(test::atlas_of(level), {.seed = 3, .collects = true});
    EXPECT_TRUE(bot);
    auto run = play(level, **bot, {.most_seconds = 240});
    EXPECT_TRUE(run);
    EXPECT_TRUE(run->telemetry.won) << (*bot)->doing();
    std::ranges::sort(run->telemetry.taken);
    return run->telemetry.taken;
}

TEST(Collector, takes_coins_that_hang_between_islands_beside_them_and_high_above) {
    const auto level = coins_in_the_air({{0, 2.0, -7.5}, {3, 1.2, -7.5}, {5.8, 1.5, -14}, {-1, 3.2, -12}});
    EXPECT_EQ(taken_by_a_collector(level), (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(Collector, lets_be_what_hangs_out_of_reach_and_goes_on_to_the_goal) {
    const auto level = coins_in_the_air({{0, 6.5, -2}, {14, 1, -14}, {0, 0.9, -12}});
    EXPECT_EQ(taken_by_a_collector(level), std::vector<std::uint32_t>{2});
}

TEST(Collector, takes_what_hangs_over_the_way_of_a_lift) {
    test::LevelMaker maker;
    maker.clear();
    maker.box({-4, -1, -6}, {4, 0, 4});
    maker.body(game::BodyKind::platform, {0, -0.25, -8.5}, {1.8, 0.25, 1.8}).route = {
        .stops = {{0, 0, 0}, {8, 0, 0}}, .speed = 2, .pause = 1};
    maker.box({8, -1, -20}, {14, 0, -11});
    maker.level->pickups.push_back({game::PickupKind::coin, {4, 3.0, -8.5}, {}});
    maker.level->goal = {11, 0, -17};
    EXPECT_EQ(taken_by_a_collector(maker.finish()), std::vector<std::uint32_t>{0});
}

TEST(Bots, do_the_same_again_with_the_same_seed) {
    const auto level = test::gaps_lift_key_and_door();
    const auto atlas = atlas_of(level);
    const auto inputs = [&](std::uint64_t seed) {
        const auto bot = navigator(atlas, seed);
        return play(level, *bot, {.most_seconds = 20})->recording.inputs;
    };
    EXPECT_EQ(inputs(3), inputs(3));
    EXPECT_NE(inputs(3), inputs(4));
    Explorer one(9);
    Explorer two(9);
    EXPECT_EQ(play(level, one, {.most_seconds = 20})->recording.inputs,
              play(level, two, {.most_seconds = 20})->recording.inputs);
}

TEST(Explorer, gets_about_and_presses_everything) {
    const auto level = test::LevelMaker().finish();
    Explorer bot(4);
    const auto run = play(level, bot, {.most_seconds = 120});
    ASSERT_TRUE(run);
    EXPECT_GT(run->telemetry.stood.size(), 300U) << "cells of half a metre";
    std::uint8_t pressed = 0;
    for (const game::HeroInput& input : run->recording.inputs) pressed |= input.buttons;
    EXPECT_EQ(pressed, 7);
}

}  // namespace
}  // namespace surefoot::playtest
