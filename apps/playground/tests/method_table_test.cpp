#include "debugger/method_table.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <surefoot/sweep.hpp>

#include "debugger/gap_curve.hpp"
#include "debugger/plane_table.hpp"
#include "numeric_reference.hpp"

namespace surefoot::debugger {
namespace {

struct Asked {
    Volume volume;
    Motion motion;
    Triangle triangle;
};

Asked some_question(tests::Random& random, int shape) {
    Asked asked;
    asked.volume = Volume(tests::some_shape(random, shape), random.orientation());
    asked.triangle = {random.point(3), random.point(3), random.point(3)};
    asked.motion.from = random.point(6);
    // Most of them towards the triangle, so that every feature is met often.
    const dvec3 towards = (asked.triangle.a + asked.triangle.b + asked.triangle.c) / 3.0 + random.point(2);
    asked.motion.to = asked.motion.from + (towards - asked.motion.from) * random.in(0.2, 2.2);
    return asked;
}

dvec3 at(const Motion& motion, double t) {
    return motion.from + (motion.to - motion.from) * t;
}

/// How far a table is from the library: along the normal, since time itself is ill-conditioned where a motion grazes.
double disagreement(const Asked& asked, const std::optional<double>& t, const std::optional<Hit>& hit) {
    const auto gap = [&](double time) { return gap_at(asked.volume, at(asked.motion, time), asked.triangle); };
    if (!t && !hit) return 0;
    if (t && hit) return std::abs(gap(*t) - gap(hit->t)) + (std::abs(*t - hit->t) > 0.01 ? 1 : 0);
    // One of them sees a touch: how deep does the motion get, at the most?
    double deepest = 0;
    for (int i = 0; i <= 2000; ++i) deepest = std::min(deepest, gap(i / 2000.0));
    return -deepest;
}

struct Counts {
    int asked = 0;
    int hits = 0;
    int features[3] = {0, 0, 0};
    int wrong = 0;
};

Counts compare(Root root) {
    Counts counts;
    tests::Random random(20261);
    while (counts.asked < 6000) {
        const Asked asked = some_question(random, random.below(2));
        const double gap = gap_at(asked.volume, asked.motion.from, asked.triangle);
        if (std::abs(gap) < 1e-6) continue;  // a start in touch is decided exactly by the library, and here in doubles
        ++counts.asked;
        const MethodTable table = method_table(asked.volume, asked.motion, asked.triangle, {.root = root});
        const auto hit = sweep(asked.volume, asked.motion, asked.triangle);
        if (hit) ++counts.hits;
        if (table.answer) ++counts.features[static_cast<int>(table.candidates[*table.answer].feature)];
        if (disagreement(asked, table.t, hit) > 1e-9) ++counts.wrong;
    }
    return counts;
}

TEST(MethodTable, agrees_with_the_library_within_the_hair) {
    const Counts counts = compare(Root::lower);
    EXPECT_EQ(counts.wrong, 0);
    EXPECT_GT(counts.hits, 1500);
    for (const int met : counts.features) EXPECT_GT(met, 200);
}

TEST(MethodTable, that_takes_the_larger_root_is_caught) {
    EXPECT_GT(compare(Root::upper).wrong, 500);
}

TEST(MethodTable, has_contacts_on_the_ball_and_on_their_features) {
    tests::Random random(7);
    for (int i = 0; i < 2000; ++i) {
        const Asked asked = some_question(random, random.below(2));
        const MethodTable table = method_table(asked.volume, asked.motion, asked.triangle);
        for (const Candidate& candidate : table.candidates) {
            EXPECT_FALSE(candidate.why.empty());
            if (!candidate.squashed_contact) continue;
            const dvec3 centre = table.squashed_motion * *candidate.t;
            EXPECT_NEAR(glm::length(centre - *candidate.squashed_contact), 1, 1e-7) << candidate.name;
            EXPECT_NEAR(candidate.equation(*candidate.t), 0, 1e-6 * (1 + std::abs(candidate.equation.c)));
            const dvec3 weights = candidate.weights.value_or(dvec3(1, 0, 0));
            EXPECT_NEAR(weights.x + weights.y + weights.z, 1, 1e-9);
        }
        if (!table.answer) continue;
        const auto hit = sweep(asked.volume, asked.motion, asked.triangle);
        ASSERT_TRUE(hit);
        EXPECT_LT(glm::length(*table.candidates[*table.answer].contact - hit->point), 1e-3);
    }
}

const Triangle floor_triangle{{0, 0, 0}, {0, 0, 10}, {10, 0, 10}};

TEST(MethodTable, writes_the_plane_s_equation_as_one_would_by_hand) {
    // A ball of radius 2 falls 8 m from 6 m above the floor. In units of the radius: 3 - 4 t = 1.
    const MethodTable table = method_table(Sphere{2}, {{3, 6, 7}, {3, -2, 7}}, floor_triangle);
    const Candidate& interior = table.candidates[0];
    EXPECT_EQ(interior.equation.a, 0);
    EXPECT_EQ(interior.equation.b, -4);
    EXPECT_EQ(interior.equation.c, 2);
    EXPECT_EQ(interior.equation.text(), "-4 t + 2 = 0");
    EXPECT_EQ(table.t, 0.5);
    EXPECT_EQ(interior.reason, Reason::first_touch);
    EXPECT_EQ(*interior.contact, dvec3(3, 0, 7));
    EXPECT_EQ(table.conclusion, "The interior is touched first, at t = 0.5.");
}

TEST(MethodTable, writes_the_edge_s_quadratic_as_one_would_by_hand) {
    // Beside edge ab, the z axis, at x = -1 and 4 m above it: (x, y) = (-1, 4 - 8 t), so 64 t^2 - 64 t + 16 + 1 - 4 = 0
    // for a ball of radius 2, divided by 2^2.
    const MethodTable table = method_table(Sphere{2}, {{-1, 4, 5}, {-1, -4, 5}}, floor_triangle);
    const Candidate& edge = table.candidates[1];
    EXPECT_EQ(edge.name, "edge ab");
    EXPECT_EQ(edge.equation.text(), "16 t^2 - 16 t + 3.25 = 0");
    EXPECT_NEAR(*table.t, 0.5 - std::sqrt(3) / 8, 1e-15);
    EXPECT_EQ(table.answer, 1U);
    EXPECT_NEAR(*edge.along, 0.5, 1e-15);
    EXPECT_EQ(edge.roots.count, 2);
    EXPECT_NEAR(edge.roots.upper, 0.5 + std::sqrt(3) / 8, 1e-15);
    EXPECT_EQ(table.candidates[0].why, "the contact lies outside the triangle");
    EXPECT_LT(table.candidates[0].weights->z, 0);
}

TEST(MethodTable, says_in_words_why_a_candidate_is_out) {
    // Passes edge ab, 2.12 m away from it.
    const MethodTable passing = method_table(Sphere{2}, {{-2.12, 4, 5}, {-2.12, -4, 5}}, floor_triangle);
    EXPECT_EQ(passing.candidates[1].why, "no real root: passes by 0.12 m");
    EXPECT_EQ(passing.conclusion, "No candidate is left: no hit, the whole way is free.");
    const MethodTable away = method_table(Sphere{2}, {{3, 3, 7}, {3, 6, 7}}, floor_triangle);
    EXPECT_EQ(away.candidates[0].reason, Reason::moving_away);
    const MethodTable late = method_table(Sphere{2}, {{3, 6, 7}, {3, 5, 7}}, floor_triangle);
    EXPECT_EQ(late.candidates[0].why, "comes only after END, at t = 4");
    const MethodTable along = method_table(Sphere{2}, {{3, 6, 7}, {4, 6, 7}}, floor_triangle);
    EXPECT_EQ(along.candidates[0].reason, Reason::parallel);
    // From the side, low enough to cut the plane already: only the edge can be met.
    const MethodTable side = method_table(Sphere{2}, {{-5, 1, 5}, {9, 0.9, 5}}, floor_triangle);
    EXPECT_EQ(side.candidates[0].reason, Reason::before_start);
    EXPECT_EQ(side.answer, 1U);
    EXPECT_EQ(side.candidates[3].reason, Reason::later);
    EXPECT_EQ(side.candidates[3].why.rfind("later than the edge ab's t = ", 0), 0U);
    const MethodTable flat = method_table(Sphere{2}, {{-5, 1, 5}, {2, 1, 5}}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 9}});
    EXPECT_EQ(flat.candidates[0].reason, Reason::degenerate);
    EXPECT_EQ(flat.candidates[1].reason, Reason::degenerate);
    EXPECT_TRUE(flat.t);
    const MethodTable behind = method_table(Sphere{2}, {{3, -6, 7}, {3, 2, 7}}, floor_triangle, {.one_sided = true});
    EXPECT_EQ(behind.candidates[0].reason, Reason::from_behind);
    EXPECT_FALSE(behind.t);
}

TEST(MethodTable, decides_a_start_in_touch_by_whether_it_goes_deeper) {
    const MethodTable down = method_table(Sphere{2}, {{3, 1.5, 7}, {3, 0, 7}}, floor_triangle);
    EXPECT_EQ(down.t, 0);
    EXPECT_FALSE(down.answer);
    const MethodTable up = method_table(Sphere{2}, {{3, 1.5, 7}, {3, 4, 7}}, floor_triangle);
    EXPECT_FALSE(up.t);
    EXPECT_EQ(up.candidates[0].reason, Reason::in_touch_at_start);
}

TEST(Equation, keeps_its_small_root_when_b_is_large) {
    const Roots roots = roots_of({1, -1e9, 1});
    EXPECT_DOUBLE_EQ(roots.lower, 1e-9);
    EXPECT_DOUBLE_EQ(roots.upper, 1e9);
    EXPECT_EQ(roots_of({1, 0, 1}).count, 0);
    EXPECT_EQ(roots_of({0, 0, 1}).count, 0);
    EXPECT_EQ((Equation{2, -3, 0}).text(), "2 t^2 - 3 t = 0");
    EXPECT_EQ((Equation{0, 0, 0.5}).text(), "0 t + 0.5 = 0");
}

TEST(PlaneTable, marks_the_plane_that_the_answer_is) {
    tests::Random random(99);
    int hits = 0;
    int misses = 0;
    for (int i = 0; i < 3000; ++i) {
        const Asked asked = some_question(random, i % 6);
        const PlaneTable table = plane_table(asked.volume, asked.motion, asked.triangle);
        EXPECT_FALSE(table.conclusion.empty());
        const PlaneRow* answer = nullptr;
        double latest = 0;
        for (const PlaneRow& row : table.rows) {
            EXPECT_NEAR(glm::length(row.normal), 1, 1e-12);
            if (row.answer) answer = &row;
            if (row.verdict == Verdict::enters) latest = std::max(latest, *row.t);
        }
        if (!table.hit) {
            ++misses;
            EXPECT_EQ(answer, nullptr);
        } else if (table.hit->t > 0) {
            ++hits;
            ASSERT_NE(answer, nullptr);
            EXPECT_EQ(*answer->t, latest);
            EXPECT_NEAR(*answer->t, table.hit->t, 1e-9);
            // Its gap is linear, and closes then.
            EXPECT_NEAR(answer->gap_from + (answer->gap_to - answer->gap_from) * table.hit->t, 0, 1e-8);
        }
    }
    EXPECT_GT(hits, 800);
    EXPECT_GT(misses, 400);
}

}  // namespace
}  // namespace surefoot::debugger
