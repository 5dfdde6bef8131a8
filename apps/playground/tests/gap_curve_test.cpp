#include "debugger/gap_curve.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include <surefoot/sweep.hpp>

#include "debugger/distance.hpp"
#include "numeric_reference.hpp"

namespace surefoot::debugger {
namespace {

struct Asked {
    Volume volume;
    Motion motion;
    Triangle triangle;
};

Asked some_question(tests::Random& random, int shape) {
    const Triangle triangle{random.point(3), random.point(3), random.point(3)};
    const dvec3 from = random.point(6);
    const dvec3 towards = (triangle.a + triangle.b + triangle.c) / 3.0 + random.point(1);
    return {Volume(tests::some_shape(random, shape), random.orientation()),
            {from, from + (towards - from) * random.in(0.2, 2.2)},
            triangle};
}

class GapCurves : public testing::TestWithParam<int> {};

TEST_P(GapCurves, are_convex) {
    tests::Random random(500 + static_cast<std::uint64_t>(GetParam()));
    for (int i = 0; i < 60; ++i) {
        const Asked asked = some_question(random, GetParam());
        const GapCurve curve = gap_curve(asked.volume, asked.motion, asked.triangle, 60);
        for (std::size_t k = 1; k + 1 < curve.samples.size(); ++k) {
            const double bend = curve.samples[k - 1].g - 2 * curve.samples[k].g + curve.samples[k + 1].g;
            ASSERT_GT(bend, -1e-8) << "question " << i << " at t = " << curve.samples[k].t;
        }
    }
}

TEST_P(GapCurves, change_their_sign_at_the_library_s_t) {
    tests::Random random(900 + static_cast<std::uint64_t>(GetParam()));
    int hits = 0;
    for (int i = 0; i < 150; ++i) {
        const Asked asked = some_question(random, GetParam());
        const GapCurve curve = gap_curve(asked.volume, asked.motion, asked.triangle, 2);
        const auto g = [&](double t) {
            return gap_at(asked.volume, asked.motion.from + (asked.motion.to - asked.motion.from) * t, asked.triangle);
        };
        if (!curve.t_star) {
            for (int k = 0; k <= 40 && curve.samples.front().g > 1e-8; ++k) EXPECT_GT(g(k / 40.0), -1e-8);
            continue;
        }
        if (*curve.t_star == 0) {
            EXPECT_LT(curve.samples.front().g, 1e-8);
            continue;
        }
        ++hits;
        EXPECT_NEAR(curve.g_at_t_star, 0, 1e-7) << "question " << i;
        EXPECT_GT(curve.samples.front().g, 0);
        for (int k = 0; k < 20; ++k) EXPECT_GT(g(*curve.t_star * k / 20.0), 0) << "question " << i;
        // Shortly after, unless it only grazes.
        double after = 0;
        for (int k = 1; k <= 200; ++k) after = std::min(after, g(*curve.t_star + (1 - *curve.t_star) * k / 200.0));
        EXPECT_TRUE(after < 0 || *curve.t_star > 1 - 1e-6) << "question " << i;
    }
    EXPECT_GT(hits, 40);
}

INSTANTIATE_TEST_SUITE_P(AllShapes, GapCurves, testing::Range(0, 6),
                         [](const auto& which) { return std::string(tests::shape_name(which.param)); });

TEST(GapCurve, says_in_which_space_it_is) {
    const Motion motion{{1, 5, 3}, {1, -5, 3}};
    const Triangle triangle{{0, 0, 0}, {0, 0, 10}, {10, 0, 10}};
    const GapCurve ellipsoid = gap_curve(Ellipsoid{{1, 2, 1}}, motion, triangle, 3);
    EXPECT_EQ(ellipsoid.space, GapSpace::squashed);
    EXPECT_DOUBLE_EQ(ellipsoid.samples[0].g, 1.5);  // 5 m over the ground are 2.5 radii
    EXPECT_DOUBLE_EQ(ellipsoid.samples[1].g, -1);
    const GapCurve box = gap_curve(Box{{1, 2, 1}}, motion, triangle, 3);
    EXPECT_EQ(box.space, GapSpace::world);
    EXPECT_NEAR(box.samples[0].g, 3, 1e-12);
    EXPECT_NEAR(*box.t_star, 0.3, 1e-9);
}

TEST(Distance, is_that_of_slow_searches_over_all_directions) {
    tests::Random random(31);
    for (int i = 0; i < 120; ++i) {
        const Asked asked = some_question(random, 2 + i % 4);
        const double found = distance(asked.volume, asked.motion.from, asked.triangle);
        if (found < 0.05) continue;
        // The largest gap over directions is the distance; the search makes things small.
        const tests::Point at = tests::point(asked.motion.from);
        const auto minus_gap = [&](const tests::Point& n) {
            tests::Real most = -1e300L;
            for (const dvec3& corner : {asked.triangle.a, asked.triangle.b, asked.triangle.c})
                most = std::max(most, dot(n, tests::point(corner)));
            return most + tests::reach(asked.volume, -n) - dot(n, at);
        };
        // Both are gaps of some plane, so the larger one is the better; the slow search stops a little before the top.
        const auto searched = static_cast<double>(-tests::least_over_directions(minus_gap));
        EXPECT_GT(found, searched - 1e-9) << "question " << i;
        EXPECT_LT(found, searched + 0.02) << "question " << i;
    }
}

TEST(Distance, of_a_ball_is_that_of_its_centre_less_the_radius) {
    tests::Random random(32);
    for (int i = 0; i < 500; ++i) {
        const Asked asked = some_question(random, 0);
        const double exact = gap_at(asked.volume, asked.motion.from, asked.triangle);
        EXPECT_NEAR(distance(asked.volume, asked.motion.from, asked.triangle), std::max(0.0, exact), 1e-9);
    }
}

}  // namespace
}  // namespace surefoot::debugger
