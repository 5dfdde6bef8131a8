// Enemies, and what is raised and scattered.
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "hero_ground.hpp"
#include "platformer/hero/enemy.hpp"
#include "platformer/hero/particles.hpp"

namespace surefoot::platformer::tests {
namespace {

constexpr EnemyKind kinds[] = {EnemyKind::chaser, EnemyKind::patroller, EnemyKind::jumper, EnemyKind::shooter};

double height_of(const EnemyPose& pose) {
    std::vector<view::Piece> pieces;
    add_pieces(pieces, pose);
    double high = 0;
    for (const view::Piece& p : pieces)
        high = std::max(high, p.place[3].y + std::hypot(p.place[0].y, p.place[1].y, p.place[2].y));
    return high;
}

TEST(Enemy, is_flat_when_it_was_stomped_and_then_gone) {
    for (const EnemyKind kind : kinds) {
        EnemyPose pose = enemy_at(kind, {0, 0, 0}, 0);
        const double before = height_of(pose);
        for (int i = 0; i < 12; ++i) pose = advance(pose, {.mood = EnemyMood::stomped}, false, tick);
        EXPECT_LT(height_of(pose), 0.5 * before);
        EXPECT_GT(height_of(pose), 0);
        for (int i = 0; i < 40; ++i) pose = advance(pose, {.mood = EnemyMood::stomped}, false, tick);
        EXPECT_EQ(height_of(pose), 0);
    }
}

TEST(Enemy, looks_at_the_hero_whom_it_has_noticed_and_else_where_it_walks) {
    for (const EnemyKind kind : kinds) {
        EnemyPose pose = enemy_at(kind, {0, 0, 0}, 0);
        for (int i = 0; i < 60; ++i) pose = advance(pose, {.velocity = {0, 0, -2}}, false, tick);
        EXPECT_NEAR(std::abs(pose.facing), 3.1416, 0.02);
        for (int i = 0; i < 60; ++i)
            pose = advance(pose, {.looks_at = {5, 0.8, 0}, .mood = EnemyMood::notice}, false, tick);
        EXPECT_NEAR(pose.facing, 1.5708, 0.02);
    }
}

TEST(Enemy, says_with_a_mark_that_it_has_noticed_somebody) {
    for (const EnemyKind kind : kinds) {
        EnemyPose pose = enemy_at(kind, {0, 0, 0}, 0);
        const double before = height_of(pose);
        for (int i = 0; i < 20; ++i)
            pose = advance(pose, {.looks_at = {0, 0.8, 5}, .mood = EnemyMood::notice}, true, tick);
        EXPECT_GT(height_of(pose), before + 0.2);
    }
}

TEST(Enemy, that_is_a_shooter_aims_up_and_down) {
    EnemyPose pose = enemy_at(EnemyKind::shooter, {0, 0, 0}, 0);
    for (int i = 0; i < 60; ++i)
        pose = advance(pose, {.looks_at = {0, 4.8, 5}, .mood = EnemyMood::attack}, false, tick);
    EXPECT_GT(pose.pitch, 0.5);
    EXPECT_GT(pose.alarm, 0.9);
}

void scatter(Particles& puffs) {
    puffs.land({0, 0, 0}, 8);
    puffs.sparkle({1, 1, 0}, view::rgb(0xFFD84A));
    puffs.splash({2, 0, 0}, 5);
    puffs.burst({3, 1, 0}, view::rgb(0xC92F45));
}

TEST(Particles, fly_the_same_way_from_the_same_seed) {
    Particles a(7);
    Particles b(7);
    Particles other(8);
    for (Particles* puffs : {&a, &b, &other}) {
        scatter(*puffs);
        for (int i = 0; i < 10; ++i) puffs->advance(tick);
    }
    ASSERT_EQ(a.size(), b.size());
    auto in_b = b.puffs().begin();
    auto in_other = other.puffs().begin();
    bool differs = false;
    for (const Puff& puff : a.puffs()) {
        EXPECT_EQ(puff.place, in_b->place);
        differs = differs || puff.place != in_other->place;
        ++in_b;
        ++in_other;
    }
    EXPECT_TRUE(differs);
}

TEST(Particles, are_gone_after_a_second_and_never_more_than_there_is_room_for) {
    Particles puffs;
    for (int i = 0; i < 100; ++i) scatter(puffs);
    EXPECT_EQ(puffs.size(), Particles::most);
    for (int i = 0; i < 60; ++i) puffs.advance(tick);
    EXPECT_EQ(puffs.size(), 0U);
}

TEST(Particles, are_a_third_as_many_with_reduced_motion) {
    Particles all;
    Particles few;
    few.reduced_motion = true;
    scatter(all);
    scatter(few);
    EXPECT_LT(few.size(), all.size() / 2);
    EXPECT_GT(few.size(), 0U);
}

}  // namespace
}  // namespace surefoot::platformer::tests
