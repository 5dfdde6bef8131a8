#include <array>
#include <gtest/gtest.h>
#include <limits>

#include <surefoot/march.hpp>
#include <surefoot/mesh.hpp>
#include <surefoot/sweep.hpp>

#include "numeric_reference.hpp"

using namespace surefoot;

namespace {

// A wall without thickness across the X axis at x = 0.
const Triangle wall{{0, -100, -100}, {0, 200, -100}, {0, 0, 200}};
const Sphere ball{0.25};

// From -1 to 1 along X, past the wall, so that no sample lies on x = 0 for an odd number of steps.
const auto along_x = [](double t) { return dvec3(-1 + 2 * t, 0, 0); };

Mesh mesh_of_wall() {
    const std::array<vec3, 3> vertices{vec3(0, -100, -100), vec3(0, 200, -100), vec3(0, 0, 200)};
    const std::array<std::uint32_t, 3> indices{0, 1, 2};
    const std::array<std::uint32_t, 1> surfaces{7};
    return *Mesh::build({.vertices = vertices, .indices = indices, .surfaces = surfaces});
}

}  // namespace

TEST(March, an_unguarded_march_tunnels_exactly_when_a_step_is_longer_than_the_shape_and_the_wall) {
    // The ball touches the wall while its centre is within 0.25 of it: a stretch of 0.5. A step of up to 0.5 cannot
    // jump it; three steps of 2/3 from -1 look at -1, -1/3, 1/3 and 1.
    EXPECT_FALSE(march(ball, along_x, wall, {.steps = 3, .guarded = false}));
    for (const std::uint32_t steps : {4U, 5U, 7U, 20U, 60U}) {
        EXPECT_TRUE(march(ball, along_x, wall, {.steps = steps, .guarded = false})) << steps;
    }
    // Steps a little over and just at 0.5, shifted so that the gap straddles the wall evenly.
    const auto straddling = [](double step) { return [step](double t) { return dvec3(step * (t * 3 - 1.5), 0, 0); }; };
    EXPECT_TRUE(march(ball, straddling(0.5), wall, {.steps = 3, .guarded = false}));
    EXPECT_FALSE(march(ball, straddling(0.5 + 1e-9), wall, {.steps = 3, .guarded = false}));
}

TEST(March, a_guarded_march_never_tunnels_however_large_the_step) {
    for (const std::uint32_t steps : {1U, 2U, 3U, 4U, 7U, 60U, 1000U}) {
        const auto met = march(ball, along_x, wall, {.steps = steps});
        ASSERT_TRUE(met) << steps;
        EXPECT_NEAR(met->hit.t, 0.375, 1e-9);
        EXPECT_NEAR(met->position.x, -0.25, 1e-9);
        EXPECT_LE(met->position.x, -0.25 + 1e-15);
        EXPECT_EQ(met->step, static_cast<std::uint32_t>(0.375 * steps - 1e-6));
        EXPECT_NEAR(met->hit.normal.x, -1, 1e-12);
    }
}

TEST(March, no_random_polyline_gets_through_a_wall_under_guard) {
    tests::Random random(1);
    for (int kind = 0; kind < 6; ++kind) {
        for (int i = 0; i < 300; ++i) {
            const Volume volume(tests::some_shape(random, kind), random.orientation());
            const double wiggle = random.in(0, 5);
            const dvec3 swing = random.point(3);
            const auto path = [&](double t) { return dvec3(-20 + 40 * t, 0, 0) + swing * std::sin(wiggle * t); };
            const auto steps = static_cast<std::uint32_t>(1 + random.below(30));
            const auto met = march(volume, path, wall, {.steps = steps});
            ASSERT_TRUE(met);
            EXPECT_LT(met->position.x, 5);
            // Before the touch no sample overlaps.
            for (std::uint32_t k = 0; k <= met->step; ++k) {
                EXPECT_FALSE(overlap(volume, path(static_cast<double>(k) / steps), wall));
            }
        }
    }
}

TEST(March, a_straight_guarded_march_of_one_step_is_the_sweep) {
    const auto met = march(ball, along_x, wall, {.steps = 1});
    const auto hit = sweep(ball, {.from = {-1, 0, 0}, .to = {1, 0, 0}}, wall);
    ASSERT_TRUE(met && hit);
    EXPECT_EQ(met->hit.t, hit->t);
    EXPECT_EQ(met->hit.point, hit->point);
}

TEST(March, an_unguarded_march_reports_the_first_sample_that_overlaps) {
    const auto met = march(ball, along_x, wall, {.steps = 20, .guarded = false});
    ASSERT_TRUE(met);
    EXPECT_EQ(met->hit.t, 0.4);  // x = -0.2; the sample before, -0.3, is free
    EXPECT_EQ(met->step, 7U);
    EXPECT_EQ(met->position, along_x(0.4));
    EXPECT_FALSE(met->hit.started_inside);
    const auto inside = march(ball, [](double) { return dvec3(0, 0, 0); }, wall, {.guarded = false});
    ASSERT_TRUE(inside);
    EXPECT_EQ(inside->hit.t, 0);
    EXPECT_TRUE(inside->hit.started_inside);
}

TEST(March, a_jump_arc_is_the_parabola_of_its_velocity_and_gravity) {
    const JumpArc jump{.from = {1, 2, 3}, .velocity = {2, 8, -1}, .gravity = {0, -8, 0}, .duration = 2};
    EXPECT_EQ(jump(0), dvec3(1, 2, 3));
    EXPECT_EQ(jump(0.5), dvec3(3, 6, 2));  // the top: 8 m/s up for a second under -8 m/s^2
    EXPECT_EQ(jump(1), dvec3(5, 2, 1));    // back at its height
    EXPECT_EQ(jump(0.25), dvec3(2, 5, 2.5));
}

TEST(March, a_jump_lands_where_the_parabola_comes_back_down) {
    const Triangle ground{{-100, 0, 100}, {100, 0, 100}, {0, 0, -100}};
    const JumpArc jump{.from = {0, 2, 0}, .velocity = {3, 8, 0}, .gravity = {0, -8, 0}, .duration = 3};
    // The ball's centre is down to 0.25 at 2 + 8 s - 4 s^2 = 0.25.
    const double s = 1 + std::sqrt(1 + 1.75 / 4);
    const auto met = march(ball, jump, ground, {.steps = 100000});
    ASSERT_TRUE(met);
    EXPECT_NEAR(met->hit.t, s / 3, 1e-9);
    EXPECT_NEAR(met->position.x, 3 * s, 1e-8);
    EXPECT_NEAR(met->hit.normal.y, 1, 1e-12);
    // With six steps it lands on a chord of the parabola, which is below it: a little earlier.
    const auto coarse = march(ball, jump, ground, {.steps = 6});
    ASSERT_TRUE(coarse);
    EXPECT_LT(coarse->hit.t, met->hit.t);
    EXPECT_NEAR(coarse->hit.t, met->hit.t, 0.05);
}

TEST(March, a_path_that_breaks_blocks_where_it_breaks) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const bool guarded : {false, true}) {
        for (const double bad : {nan, 2e9, -std::numeric_limits<double>::infinity()}) {
            const auto breaking = [bad](double t) { return dvec3(-5, t < 0.5 ? t : bad, 0); };
            const auto met = march(ball, breaking, wall, {.steps = 4, .guarded = guarded});
            ASSERT_TRUE(met);
            EXPECT_EQ(met->hit.status, HitStatus::invalid);
            EXPECT_EQ(met->hit.t, 0.25);
            EXPECT_EQ(met->position, dvec3(-5, 0.25, 0));
            EXPECT_EQ(met->step, 1U);
        }
        const auto volume = march(Sphere{nan}, along_x, wall, {.guarded = guarded});
        ASSERT_TRUE(volume);
        EXPECT_EQ(volume->hit.status, HitStatus::invalid);
        for (const std::uint32_t steps : {0U, (1U << 24) + 1}) {
            const auto met = march(ball, along_x, wall, {.steps = steps, .guarded = guarded});
            ASSERT_TRUE(met);
            EXPECT_EQ(met->hit.status, HitStatus::invalid);
        }
    }
}

TEST(March, one_sided_walls_let_the_back_through) {
    // The wall's front is +X; along_x comes from behind.
    const auto back = [](double t) { return along_x(1 - t); };
    EXPECT_FALSE(march(ball, along_x, wall, {.one_sided = true}));
    EXPECT_TRUE(march(ball, back, wall, {.one_sided = true}));
    EXPECT_TRUE(march(ball, back, wall, {.guarded = false, .one_sided = true}));
}

TEST(March, a_mesh_is_marched_as_its_triangle_is) {
    const Mesh mesh = mesh_of_wall();
    for (const bool guarded : {false, true}) {
        for (const std::uint32_t steps : {3U, 4U, 60U}) {
            const MarchOptions options{.steps = steps, .guarded = guarded};
            const auto one = march(ball, along_x, wall, options);
            const auto all = march(ball, along_x, mesh, options);
            ASSERT_EQ(one.has_value(), all.has_value());
            if (!one) continue;
            EXPECT_EQ(one->hit.t, all->hit.t);
            EXPECT_EQ(one->position, all->position);
            EXPECT_EQ(all->hit.surface, 7U);
        }
    }
}
