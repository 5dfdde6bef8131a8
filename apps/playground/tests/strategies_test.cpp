#include "debugger/strategies.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "debugger/worlds.hpp"
#include "numeric_reference.hpp"

namespace surefoot::debugger {
namespace {

/// A wall across x at `x`, without thickness.
std::vector<Triangle> wall(double x) {
    return {{{x, -9, -9}, {x, 9, -9}, {x, 9, 9}}, {{x, -9, -9}, {x, 9, 9}, {x, -9, 9}}};
}

TEST(Strategies, that_look_only_at_the_end_see_only_the_end) {
    const Arena arena(wall(5));
    const Finding through = look_at_end(arena, Sphere{0.5}, {{0, 0, 0}, {10, 0, 0}});
    EXPECT_FALSE(through.hit);
    EXPECT_TRUE(through.missed);
    const Finding within = look_at_end(arena, Sphere{0.5}, {{0, 0, 0}, {5.25, 0, 0}});
    EXPECT_TRUE(within.hit);
    EXPECT_NEAR(*within.late, 0.75, 1e-9);
    const Finding before = look_at_end(arena, Sphere{0.5}, {{0, 0, 0}, {4, 0, 0}});
    EXPECT_FALSE(before.hit || before.missed);
}

TEST(Strategies, that_solve_stop_at_the_touch) {
    const Finding found = solve(Arena(wall(5)), Sphere{0.5}, {{0, 0, 0}, {10, 0, 0}});
    EXPECT_TRUE(found.hit);
    EXPECT_NEAR(found.position.x, 4.5, 1e-9);
    EXPECT_EQ(found.looks, 1U);
    EXPECT_EQ(found.late, 0);
}

TEST(Strategies, that_look_at_samples_are_late_by_less_than_a_step) {
    const Arena arena(wall(5));
    for (const double step : {0.1, 0.3, 0.5, 0.7}) {
        const Finding found = look_at_samples(arena, Sphere{0.5}, {{0, 0, 0}, {10, 0, 0}}, step);
        ASSERT_TRUE(found.hit) << step;
        EXPECT_LT(*found.late, step);
        EXPECT_GE(*found.late, -1e-9);
        EXPECT_EQ(found.looks, static_cast<std::uint64_t>(std::ceil(4.5 / step)));
    }
}

TEST(Strategies, look_at_the_end_whatever_the_step) {
    const Arena arena(wall(5));
    const Finding found = look_at_samples(arena, Sphere{0.5}, {{0, 0, 0}, {5.2, 0, 0}}, 100);
    EXPECT_TRUE(found.hit);
    EXPECT_EQ(found.looks, 1U);
}

TEST(Strategies, give_up_on_steps_that_are_too_small) {
    const Finding found = look_at_samples(Arena(wall(5)), Sphere{0.5}, {{0, 0, 0}, {10, 0, 0}}, 1e-9);
    EXPECT_FALSE(found.hit || found.missed);
    EXPECT_EQ(found.looks, most_looks);
    EXPECT_EQ(found.text.rfind("Gave up", 0), 0U);
}

TEST(Tunnelling, of_a_thin_wall_begins_where_geometry_says) {
    // The ball touches the wall from 4.5 m to 5.5 m. Samples at 5.5 / m miss it when the one before, (m - 1) / m times
    // that, comes before 4.5 m: for m up to 5, and 5.5 / 5 is the least.
    const Arena arena(wall(5));
    const Motion motion{{0, 0, 0}, {10, 0, 0}};
    const auto parts = touching_parts(arena, Sphere{0.5}, motion);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_NEAR(parts[0].begin, 4.5, 1e-9);
    EXPECT_NEAR(parts[0].end, 5.5, 1e-9);
    const Tunnelling found = tunnelling(parts, 10, 12);
    ASSERT_TRUE(found.begins_above);
    EXPECT_NEAR(*found.begins_above, 1.1, 1e-9);
    EXPECT_NEAR(*found.always_above, 5.5, 1e-9);
    EXPECT_EQ(found.text, "Tunnelling begins at 1.1 m, below 10.91 frames a second at 12 m/s.");
}

TEST(Tunnelling, begins_and_ends_there_for_the_strategy_itself) {
    tests::Random random(8);
    int walls = 0;
    while (walls < 60) {
        const double x = random.in(2, 8);
        const double radius = random.in(0.05, 0.9);
        if (x + radius > 9.9) continue;
        ++walls;
        const Arena arena(wall(x));
        const Motion motion{{0, 0, 0}, {10, 0, 0}};
        const Tunnelling found = tunnelling(touching_parts(arena, Sphere{radius}, motion), 10, 5);
        ASSERT_TRUE(found.begins_above);
        const auto misses = [&](double step) { return look_at_samples(arena, Sphere{radius}, motion, step).missed; };
        EXPECT_TRUE(misses(*found.begins_above * (1 + 1e-7)));
        EXPECT_FALSE(misses(*found.begins_above * (1 - 1e-7)));
        for (int i = 0; i < 40; ++i) EXPECT_FALSE(misses(*found.begins_above * random.in(0.02, 1)));
        EXPECT_FALSE(misses(*found.always_above * (1 - 1e-7))) << "there the first sample still touches";
        for (int i = 0; i < 20; ++i) EXPECT_TRUE(misses(*found.always_above * random.in(1.0001, 3)));
        // What is longer than a stretch is what makes it possible at all.
        EXPECT_GT(*found.begins_above, 2 * radius - 1e-9);
    }
}

TEST(Tunnelling, of_two_walls_has_to_miss_both) {
    auto both = wall(3);
    for (const Triangle& triangle : wall(7)) both.push_back(triangle);
    const Motion motion{{0, 0, 0}, {10, 0, 0}};
    const Arena arena(both);
    const auto parts = touching_parts(arena, Sphere{0.3}, motion);
    ASSERT_EQ(parts.size(), 2U);
    const Tunnelling found = tunnelling(parts, 10, 5);
    ASSERT_TRUE(found.begins_above);
    const auto misses = [&](double step) { return look_at_samples(arena, Sphere{0.3}, motion, step).missed; };
    EXPECT_TRUE(misses(*found.begins_above * (1 + 1e-7)));
    // The first step that misses both, found by trying.
    double tried = 0.05;
    while (!misses(tried)) tried += 0.001;
    EXPECT_NEAR(*found.begins_above, tried, 0.0011);
}

TEST(Tunnelling, cannot_be_where_the_end_is_in_touch_or_nothing_is_in_the_way) {
    const Motion into{{0, 0, 0}, {5.2, 0, 0}};
    EXPECT_FALSE(tunnelling(touching_parts(Arena(wall(5)), Sphere{0.5}, into), 5.2, 5).begins_above);
    const Motion before{{0, 0, 0}, {3, 0, 0}};
    EXPECT_TRUE(touching_parts(Arena(wall(5)), Sphere{0.5}, before).empty());
}

TEST(Tunnelling, knows_that_one_sided_walls_end_at_the_reference_point) {
    // Overlap from the front ends when the centre is through.
    const Motion motion{{0, 0, 0}, {10, 0, 0}};
    const auto towards_front = touching_parts(Arena(wall(5)), Sphere{0.5}, motion, true);
    const auto towards_back = touching_parts(Arena(wall(5)), Sphere{0.5}, {{10, 0, 0}, {0, 0, 0}}, true);
    ASSERT_EQ(towards_front.size(), 1U);
    ASSERT_EQ(towards_back.size(), 1U);
    EXPECT_NEAR(towards_front[0].end - towards_front[0].begin, 0.5, 1e-9);
    EXPECT_NEAR(towards_back[0].end - towards_back[0].begin, 0.5, 1e-9);
    const Arena arena(wall(5));
    const Tunnelling found = tunnelling(towards_front, 10, 5);
    const auto misses = [&](double step) { return !look_at_samples(arena, Sphere{0.5}, motion, step, true).hit; };
    EXPECT_TRUE(misses(*found.begins_above * (1 + 1e-7)));
    EXPECT_FALSE(misses(*found.begins_above * (1 - 1e-7)));
}

TEST(Tunnelling, is_found_in_every_world_of_the_room) {
    for (const WorldKind world : {WorldKind::triangle, WorldKind::fold, WorldKind::wedge}) {
        const Question question = default_question(world);
        const Arena arena(question.triangles);
        const double length = glm::length(question.motion.to - question.motion.from);
        const Tunnelling found = tunnelling(touching_parts(arena, question.volume(), question.motion), length, 12);
        if (!found.begins_above) continue;
        EXPECT_TRUE(
            look_at_samples(arena, question.volume(), question.motion, *found.begins_above * (1 + 1e-7)).missed);
        EXPECT_TRUE(look_at_samples(arena, question.volume(), question.motion, *found.begins_above * (1 - 1e-7)).hit);
    }
}

}  // namespace
}  // namespace surefoot::debugger
