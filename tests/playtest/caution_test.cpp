// Past what moves and harms, as somebody careful gets past it.
#include <algorithm>
#include <gtest/gtest.h>

#include "made_levels.hpp"

namespace surefoot::playtest {
namespace {

// A lane 40 m long and 6 m wide with walls, from the spawn to the goal.
test::LevelMaker lane() {
    test::LevelMaker maker;
    maker.clear();
    maker.box({-3, -1, -40}, {3, 0, 4});
    maker.box({-4, -1, -40}, {-3, 8, 4});
    maker.box({3, -1, -40}, {4, 8, 4});
    maker.level->goal = {0, 0, -38};
    return maker;
}

struct Outcome {
    bool won = false;
    int hurts = 0;
    int stomps = 0;
    double seconds = 0;
};

Outcome run(const std::shared_ptr<const game::Level>& level, std::uint64_t seed) {
    const auto bot = test::navigator(test::atlas_of(level), seed);
    auto game = *game::Game::start(level);
    Outcome outcome;
    while (game->outcome() == game::Outcome::playing && game->seconds() < 60) {
        game->tick(bot->decide(*game));
        for (const game::GameEvent& event : game->events()) {
            if (event.what == game::Happening::hurt) ++outcome.hurts;
            if (event.what == game::Happening::stomped) ++outcome.stomps;
        }
    }
    outcome.won = game->outcome() == game::Outcome::won;
    outcome.seconds = game->seconds();
    return outcome;
}

TEST(Caution, waits_before_a_press_that_fills_the_lane_and_runs_under_it) {
    for (const double phase : {0.0, 0.8, 1.6, 2.4, 3.2, 4.0}) {
        test::LevelMaker maker = lane();
        maker.body(game::BodyKind::hazard, {0, 1.5, -15}, {3, 1.5, 0.5}).route = {
            .stops = {{0, 0, 0}, {0, 4, 0}}, .speed = 3, .pause = 1.2, .phase = phase};
        const Outcome outcome = run(maker.finish(), 1);
        EXPECT_TRUE(outcome.won);
        EXPECT_EQ(outcome.hurts, 0) << "from " << phase << " s of its route on";
    }
}

TEST(Caution, gets_by_a_sweeper_whose_arm_turns_over_the_whole_lane) {
    test::LevelMaker maker = lane();
    maker.body(game::BodyKind::hazard, {0, 0.5, -15}, {2.9, 0.25, 0.2}).route = {.deg_per_s = 60};
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        const Outcome outcome = run(maker.finish(), seed);
        EXPECT_TRUE(outcome.won);
        EXPECT_EQ(outcome.hurts, 0);
    }
}

TEST(Caution, stomps_or_leaves_behind_a_chaser_in_a_lane) {
    test::LevelMaker maker = lane();
    maker.level->enemies.push_back({.kind = game::EnemyKind::chaser, .feet = {0, 0, -18}, .route = {{0, 0, -18}}});
    int hurts = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Outcome outcome = run(maker.finish(), seed);
        EXPECT_TRUE(outcome.won);
        hurts += outcome.hurts;
    }
    EXPECT_LE(hurts, 2) << "whoever just walks is caught each time";
}

TEST(Caution, runs_between_shots) {
    test::LevelMaker maker = lane();
    maker.level->enemies.push_back(
        {.kind = game::EnemyKind::shooter, .feet = {2, 0, -30}, .route = {{2, 0, -30}}, .sight = 25});
    int hurts = 0;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Outcome outcome = run(maker.finish(), seed);
        EXPECT_TRUE(outcome.won);
        EXPECT_LT(outcome.seconds, 40) << "and does not stand before them for ever";
        hurts += outcome.hurts;
    }
    EXPECT_LE(hurts, 2);
}

TEST(Threats, foresee_that_a_shot_hits_who_stands_and_not_who_stepped_aside) {
    test::LevelMaker maker;
    maker.level->enemies.push_back(
        {.kind = game::EnemyKind::shooter, .feet = {0, 0, -12}, .route = {{0, 0, -12}}, .sight = 20});
    const auto level = maker.finish();
    const auto game = *game::Game::start(level);
    while (game->bullets().size() == 0 || (*game->bullets().begin()).age < 0.15) game->tick({});
    const auto foresight = *Foresight::make(level);
    const auto is_harmed = [&](const game::HeroInput& input) {
        foresight->look(*game);
        for (int i = 0; i < 80; ++i)
            if (!foresight->tick(input)) return true;
        return false;
    };
    EXPECT_TRUE(is_harmed({}));
    EXPECT_FALSE(is_harmed({.move_x = 1}));
}

TEST(Threats, foresee_that_a_chaser_comes_and_that_it_can_be_stomped) {
    test::LevelMaker maker;
    maker.level->enemies.push_back({.kind = game::EnemyKind::chaser, .feet = {0, 0, -6}, .route = {{0, 0, -6}}});
    const auto level = maker.finish();
    const auto game = *game::Game::start(level);
    while (game->enemies().begin()->mood != game::Enemy::Mood::hunts) game->tick({});
    const auto foresight = *Foresight::make(level);
    foresight->look(*game);
    bool harmed = false;
    for (int i = 0; i < 120 && !harmed; ++i) harmed = !foresight->tick({});
    EXPECT_TRUE(harmed) << "who stands is caught";
    bool stomped = false;
    for (int wait = 0; wait < 90 && !stomped; wait += 2) {
        foresight->look(*game);
        for (int i = 0; i < 150 && !stomped; ++i) {
            game::HeroInput input;
            if (i >= wait && i < wait + 20) press(input, game::Button::jump);
            if (!foresight->tick(input)) break;
            stomped = !foresight->threats().foes().front().is_there;
        }
    }
    EXPECT_TRUE(stomped) << "who jumps in time comes down on it";
}

}  // namespace
}  // namespace surefoot::playtest
