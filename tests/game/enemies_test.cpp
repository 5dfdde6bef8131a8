// Enemies of the platformer: what they notice, where they go, how they are got rid of.
#include <gtest/gtest.h>

#include "level_maker.hpp"

namespace surefoot::game {
namespace {

using test::LevelMaker;
using test::play;
using test::run_to;
using test::Seen;

EnemyPlan enemy(EnemyKind kind, const dvec3& feet) {
    return {.kind = kind, .feet = feet, .route = {feet}};
}

TEST(GameEnemies, AChaserComesRoundAWallAndHurts) {
    LevelMaker maker;
    maker.box({3.8, 0, -3}, {4.2, 0.7, 3});  // it sees over this, and has to walk round it
    maker.level->enemies.push_back(enemy(EnemyKind::chaser, {7, 0, 0}));
    const auto game = maker.start();
    const Seen seen = play(*game, 8);
    EXPECT_GE(seen.count(Happening::enemy_noticed), 1);
    EXPECT_GE(seen.count(Happening::hurt), 1);
    EXPECT_EQ(game->cause(), Cause::chaser);
}

TEST(GameEnemies, NobodyIsNoticedThroughAWall) {
    LevelMaker maker;
    maker.box({3.8, 0, -20}, {4.2, 3, 20});
    maker.level->enemies.push_back(enemy(EnemyKind::chaser, {7, 0, 0}));
    const auto game = maker.start();
    EXPECT_EQ(play(*game, 8).count(Happening::enemy_noticed), 0);
}

TEST(GameEnemies, BeyondItsLeashItGoesHome) {
    LevelMaker maker;
    EnemyPlan plan = enemy(EnemyKind::chaser, {6, 0, 0});
    plan.leash = 5;
    maker.level->enemies.push_back(plan);
    const auto game = maker.start();
    run_to(*game, {-18, 0, 0}, 5);
    play(*game, 10);
    const dvec3 place = game->enemies().begin()->body.position;
    EXPECT_NEAR(place.x, 6, 1);
    EXPECT_NEAR(place.z, 0, 1);
}

TEST(GameEnemies, APatrollerWalksItsRoundUntilItNotices) {
    LevelMaker maker;
    EnemyPlan plan = enemy(EnemyKind::patroller, {12, 0, -8});
    plan.route = {{12, 0, -8}, {12, 0, 8}};
    plan.sight = 3;
    maker.level->enemies.push_back(plan);
    const auto game = maker.start();
    double low = 100;
    double high = -100;
    for (int tick = 0; tick < 60 * 20; ++tick) {
        game->tick({});
        low = std::min(low, game->enemies().begin()->body.position.z);
        high = std::max(high, game->enemies().begin()->body.position.z);
    }
    EXPECT_LT(low, -7);
    EXPECT_GT(high, 7);
}

TEST(GameEnemies, AStompEndsThemAndThrowsTheHeroUp) {
    LevelMaker maker;
    maker.box({-2, 2, -2}, {2, 3, 2});
    maker.level->checkpoints[0].feet = {0, 3, 0};
    maker.level->enemies.push_back(enemy(EnemyKind::patroller, {3.2, 0, 0}));
    maker.level->enemies[0].sight = 0;
    const auto game = maker.start();
    play(*game, 2);
    Seen seen;
    for (int tick = 0; tick < 120 && seen.count(Happening::stomped) == 0; ++tick) {
        const bool over = game->feet().x > 3.1;
        const Seen more = play(*game, 1.0 / 60, {.move_x = over ? 0.0F : 0.5F});
        seen.events.insert(seen.events.end(), more.events.begin(), more.events.end());
    }
    EXPECT_EQ(seen.count(Happening::stomped), 1);
    EXPECT_EQ(game->enemies().size(), 0U);
    EXPECT_EQ(game->hero().health, most_health);
    play(*game, 0.1);
    EXPECT_GT(game->hero().body.velocity.y, 3);
}

TEST(GameEnemies, AShooterHitsWhoStandsAndMissesWhoHidesBehindAWall) {
    LevelMaker maker;
    maker.level->enemies.push_back(enemy(EnemyKind::shooter, {6, 0, 0}));
    const auto game = maker.start();
    const Seen seen = play(*game, 5);
    EXPECT_GE(seen.count(Happening::shot), 1);
    EXPECT_GE(seen.count(Happening::hurt), 1);
    EXPECT_EQ(game->cause(), Cause::shot);

    LevelMaker walled;
    walled.box({2.8, 0, -20}, {3.2, 3, 20});
    walled.level->enemies.push_back(enemy(EnemyKind::shooter, {6, 0, 0}));
    EXPECT_EQ(play(*walled.start(), 5).count(Happening::shot), 0);
}

TEST(GameEnemies, AJumperLeapsAtWhoIsNear) {
    LevelMaker maker;
    maker.level->enemies.push_back(enemy(EnemyKind::jumper, {6, 0, 0}));
    const auto game = maker.start();
    double highest = 0;
    Seen seen;
    for (int tick = 0; tick < 60 * 6; ++tick) {
        game->tick({});
        seen.events.insert(seen.events.end(), game->events().begin(), game->events().end());
        if (!game->enemies().empty()) highest = std::max(highest, game->enemies().begin()->body.position.y);
    }
    EXPECT_GE(seen.count(Happening::enemy_jumped), 1);
    EXPECT_GT(highest, 1.5);
    EXPECT_GE(seen.count(Happening::hurt), 1);
}

}  // namespace
}  // namespace surefoot::game
