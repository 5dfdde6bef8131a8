#include <gtest/gtest.h>
#include <limits>

#include <surefoot/pair.hpp>

#include "numeric_reference.hpp"

using namespace surefoot;
using tests::Point;
using tests::Random;
using tests::Real;

namespace {

const dquat eighth_about_z(0.92387953251128675613, 0, 0, 0.38268343236508977173);

// The gap that a plane of unit normal `n` proves between a at x and b at the origin.
Real gap_along(const Volume& a, const Point& x, const Volume& b, const Point& n) {
    return dot(n, x) - tests::reach(b, n) - tests::reach(a, -n);
}

// The distance of two shapes, or less; when they overlap, minus the depth of the shortest way out or less.
Real largest_gap(const Volume& a, const Point& x, const Volume& b, std::vector<Point> hints = {}) {
    hints.push_back(x);
    const Point axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Point& i : axes) {
        hints.push_back(turn(a.orientation, i));
        hints.push_back(turn(b.orientation, i));
        for (const Point& k : axes) hints.push_back(cross(turn(a.orientation, i), turn(b.orientation, k)));
    }
    return -tests::least_over_directions([&](const Point& n) { return -gap_along(a, x, b, n); }, hints, 300);
}

Point difference(const dvec3& a, const dvec3& b) {
    return tests::point(a) - tests::point(b);
}

struct Question {
    Volume a;
    Volume b;
    Motion motion_a;
    Motion motion_b;
};

Question random_question(Random& random, int kind_a, int kind_b) {
    Question q;
    q.a = Volume(tests::some_shape(random, kind_a), random.orientation());
    q.b = Volume(tests::some_shape(random, kind_b), random.orientation());
    const dvec3 place = random.point(1) * (random.below(4) == 0 ? 1000.0 : 1.0);
    q.motion_b = {place, place + random.point(1)};
    q.motion_a = {place + random.point(4), place + random.point(2)};
    return q;
}

dvec3 at(const Motion& motion, double t) {
    return motion.from + (motion.to - motion.from) * t;
}

template <typename Check>
void for_all_pairs(std::uint64_t seed, int count, const Check& check) {
    for (int kind_a = 0; kind_a < 6; ++kind_a) {
        for (int kind_b = kind_a; kind_b < 6; ++kind_b) {
            Random random(seed + static_cast<std::uint64_t>(6 * kind_a + kind_b));
            for (int i = 0; i < count; ++i) {
                const Question q = random_question(random, kind_a, kind_b);
                SCOPED_TRACE(testing::Message()
                             << tests::shape_name(kind_a) << " " << tests::shape_name(kind_b) << " " << i);
                check(q, random);
                if (testing::Test::HasFatalFailure()) return;
            }
        }
    }
}

}  // namespace

TEST(Pair, two_spheres_meet_when_their_centres_are_two_radii_apart) {
    // 3-4-5: passing at a distance of 3 with radii that sum to 5, they touch 4 before the closest approach.
    const auto hit = pair_sweep(Sphere{2}, {.from = {-10, 3, 0}, .to = {10, 3, 0}}, Sphere{3}, dvec3(0, 0, 0));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 0.3, 1e-8);
    EXPECT_LE(hit->t, 0.3);
    EXPECT_NEAR(hit->normal.x, -0.8, 1e-7);
    EXPECT_NEAR(hit->normal.y, 0.6, 1e-7);
    EXPECT_NEAR(hit->point.x, -2.4, 1e-6);
    EXPECT_FALSE(hit->started_inside);
}

TEST(Pair, a_bullet_that_passes_just_beside_a_head_misses_it) {
    const Sphere bullet{0.01};
    const Sphere head{0.15};
    const auto past = [&](double height) {
        return pair_sweep(bullet, {.from = {-50, height, 0}, .to = {50, height, 0}}, head, dvec3(0, 0, 0)).has_value();
    };
    EXPECT_TRUE(past(0.16 - 1e-6));
    EXPECT_FALSE(past(0.16 + 1e-6));
}

TEST(Pair, a_stomp_lands_on_top) {
    const Capsule player{0.4, 0.5};
    const Box foe{{0.5, 0.5, 0.5}};
    const auto hit = pair_sweep(player, {.from = {0.2, 3, 0}, .to = {0.2, 0, 0}}, foe, dvec3(0, 0.5, 0));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->normal.y, 1, 1e-12);
    EXPECT_NEAR(hit->t, (3 - 1.9) / 3, 1e-8);
    EXPECT_NEAR(hit->point.x, 0.2, 1e-9);
    EXPECT_NEAR(hit->point.y, 1, 1e-7);
}

TEST(Pair, upright_cylinders_side_by_side_are_circles) {
    const Cylinder c{1, 2};
    EXPECT_NEAR(pair_overlap(c, {1.5, 3, 0}, c, {0, 0, 0})->depth, 0.5, 1e-15);
    EXPECT_NEAR(pair_overlap(c, {0, 3.75, 0}, c, {0, 0, 0})->depth, 0.25, 1e-15);
    EXPECT_FALSE(pair_overlap(c, {1.5, 0, 1.5}, c, {0, 0, 0}));
    // Spinning about its own axis changes nothing.
    const auto spun = pair_overlap(Volume(c, dquat(1, 0, 0.3, 0)), {1.5, 3, 0}, c, {0, 0, 0});
    ASSERT_TRUE(spun);
    EXPECT_NEAR(spun->depth, 0.5, 1e-15);
}

TEST(Pair, a_sphere_rolls_over_the_rim_of_a_cylinder_as_over_a_ring) {
    // The centre comes down at level distance 1 + 0.3 from the axis: it meets the rim with the ball 3-4-5.
    const auto hit = pair_sweep(Sphere{0.5}, {.from = {1.3, 5, 0}, .to = {1.3, 0, 0}}, Cylinder{1, 1}, dvec3(0, 0, 0));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, (5 - 1.4) / 5, 1e-8);
    EXPECT_NEAR(hit->normal.x, 0.6, 1e-7);
    EXPECT_NEAR(hit->normal.y, 0.8, 1e-7);
}

TEST(Pair, a_box_on_its_edge_is_root_two_tall) {
    const Box box{{1, 1, 1}};
    const Volume on_edge(box, eighth_about_z);
    const double root_two = std::sqrt(2.0);
    EXPECT_NEAR(pair_overlap(on_edge, {0, root_two + 0.75, 0}, box, {0, 0, 0})->depth, 0.25, 1e-14);
    const auto hit = pair_sweep(on_edge, {.from = {0, 5, 0}, .to = {0, 1, 0}}, box, dvec3(0, 0, 0));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, (5 - 1 - root_two) / 4, 1e-8);
    EXPECT_NEAR(hit->normal.y, 1, 1e-12);
}

TEST(Pair, crossed_capsules_touch_at_the_sum_of_their_radii) {
    const Volume level(Capsule{0.25, 2}, dquat(1, 0, 0, 1));  // a quarter turn about Z: along X
    const Volume deep(Capsule{0.5, 2}, dquat(1, 1, 0, 0));    // a quarter turn about X: along Z
    EXPECT_NEAR(pair_overlap(level, {0, 0.5, 0}, deep, {0, 0, 0})->depth, 0.25, 1e-15);
    const auto hit = pair_sweep(level, {.from = {0.3, 4, 0}, .to = {0.3, 0, 0}}, deep, dvec3(0, 0, 0));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, (4 - 0.75) / 4, 1e-8);
    EXPECT_NEAR(hit->point.y, 0.5, 1e-7);
}

TEST(Pair, an_ellipsoid_over_a_cone_touches_its_disc) {
    const auto hit =
        pair_sweep(Ellipsoid{{0.4, 0.9, 0.4}}, {.from = {0.1, 6, 0}, .to = {0.1, 0, 0}}, Cone{1, 2}, dvec3(0, 0, 0));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, (6 - 2.9) / 6, 1e-6);
    EXPECT_NEAR(hit->normal.y, 1, 1e-4);
    EXPECT_NEAR(hit->point.x, 0.1, 1e-3);
    EXPECT_NEAR(hit->point.y, 2, 1e-6);
}

TEST(Pair, both_may_move_and_only_the_difference_counts) {
    const auto one =
        pair_sweep(Sphere{1}, {.from = {-5, 0, 0}, .to = {5, 0, 0}}, Sphere{1}, {.from = {5, 0, 0}, .to = {-5, 0, 0}});
    ASSERT_TRUE(one);
    EXPECT_NEAR(one->t, 0.4, 1e-8);
    EXPECT_NEAR(one->point.x, 0, 1e-7);
    EXPECT_FALSE(
        pair_sweep(Sphere{1}, {.from = {0, 0, 0}, .to = {9, 9, 9}}, Sphere{1}, {.from = {3, 0, 0}, .to = {12, 9, 9}}));
}

TEST(Pair, touching_shapes_may_leave_and_slide_but_not_press_on) {
    int slipped = 0;
    int held = 0;
    for_all_pairs(50, 40, [&](const Question& q, Random& random) {
        // Bring them to the touch first, or out to it.
        const auto overlap = pair_overlap(q.a, q.motion_a.to, q.b, q.motion_b.to);
        dvec3 place = q.motion_a.to;
        if (overlap) {
            place += overlap->normal * overlap->depth;
        } else {
            const auto hit = pair_sweep(q.a, {q.motion_a.to, q.motion_b.to}, q.b, q.motion_b.to);
            ASSERT_TRUE(hit);
            place = at({q.motion_a.to, q.motion_b.to}, hit->t);
        }
        const auto touch = pair_overlap(q.a, place, q.b, q.motion_b.to);
        ASSERT_TRUE(touch);
        EXPECT_LT(touch->depth, 1e-6);
        const dvec3 normal = touch->normal;
        const auto moves = [&](const dvec3& way) { return pair_sweep(q.a, {place, place + way}, q.b, q.motion_b.to); };
        EXPECT_FALSE(moves(normal));
        EXPECT_FALSE(moves(normal * 1e-3));
        const dvec3 other = random.point(1);
        const double along = other.x * normal.x + other.y * normal.y + other.z * normal.z;
        EXPECT_FALSE(moves(other - normal * (along - 1e-6)));
        const auto pressed = moves(normal * -0.05);
        if (!pressed) {
            // A point against an edge has many normals: against one of them it may still slip off another.
            EXPECT_GT(largest_gap(q.a, difference(place - normal * 0.05, q.motion_b.to), q.b), -1e-6L);
            ++slipped;
            return;
        }
        ++held;
        EXPECT_NEAR(pressed->t, 0, 1e-4);
    });
    EXPECT_LT(50 * slipped, held);
}

TEST(Pair, what_starts_inside_may_leave_by_the_way_out_and_not_go_deeper) {
    for_all_pairs(60, 60, [](const Question& q, Random&) {
        const auto overlap = pair_overlap(q.a, q.motion_a.to, q.b, q.motion_b.to);
        if (!overlap || overlap->depth < 1e-3) return;
        const dvec3 place = q.motion_a.to;
        EXPECT_FALSE(pair_sweep(q.a, {place, place + overlap->normal * 3.0}, q.b, q.motion_b.to));
        const auto deeper =
            pair_sweep(q.a, {place, place - overlap->normal * (overlap->depth * 0.01)}, q.b, q.motion_b.to);
        ASSERT_TRUE(deeper);
        EXPECT_EQ(deeper->t, 0);
        EXPECT_TRUE(deeper->started_inside);
    });
}

TEST(Pair, a_hit_is_never_late_and_its_gap_is_within_the_tolerance) {
    int hits = 0;
    for_all_pairs(70, 60, [&](const Question& q, Random&) {
        const auto hit = pair_sweep(q.a, q.motion_a, q.b, q.motion_b);
        if (!hit || hit->started_inside) return;
        ASSERT_EQ(hit->status, HitStatus::ok);
        ++hits;
        const Real t = hit->t;
        const Point from = difference(q.motion_a.from, q.motion_b.from);
        const Point to = difference(q.motion_a.to, q.motion_b.to);
        const Point x = from + (to - from) * t;
        const Point n = tests::point(hit->normal);
        EXPECT_NEAR(static_cast<double>(length(n)), 1, 1e-14);
        // A plane that has a gap at t, and had a larger one before: the proof that it is not late.
        EXPECT_LT(dot(n, to - from), 0);
        EXPECT_GT(gap_along(q.a, x, q.b, n), -1e-13L);
        EXPECT_LT(largest_gap(q.a, x, q.b, {n}), 1e-6L);
        const Point at_a = tests::point(at(q.motion_a, hit->t));
        const Point at_b = tests::point(at(q.motion_b, hit->t));
        EXPECT_TRUE(tests::is_within(q.a, tests::point(hit->point) - at_a, -1e-5L));
        EXPECT_TRUE(tests::is_within(q.b, tests::point(hit->point) - at_b, -1e-5L));
    });
    EXPECT_GT(hits, 300);
}

TEST(Pair, a_common_point_at_any_time_means_a_hit_no_later) {
    int met = 0;
    for_all_pairs(80, 5000, [&](const Question& q, Random& random) {
        const double t = random.in(0, 1);
        const Point inside = tests::point(random.point(1));
        if (!tests::is_within(q.a, inside, 1e-6L)) return;
        const Point p = tests::point(at(q.motion_a, t)) + inside;
        if (!tests::is_within(q.b, p - tests::point(at(q.motion_b, t)), 1e-6L)) return;
        ++met;
        EXPECT_TRUE(pair_overlap(q.a, at(q.motion_a, t), q.b, at(q.motion_b, t)));
        if (pair_overlap(q.a, q.motion_a.from, q.b, q.motion_b.from)) return;
        const auto hit = pair_sweep(q.a, q.motion_a, q.b, q.motion_b);
        ASSERT_TRUE(hit);
        EXPECT_LE(hit->t, t);
    });
    EXPECT_GT(met, 500);
}

TEST(Pair, the_way_out_is_enough_just_touching_and_short) {
    Real worst = 0;
    int overlaps = 0;
    for_all_pairs(90, 110, [&](const Question& q, Random&) {
        const auto overlap = pair_overlap(q.a, q.motion_a.to, q.b, q.motion_b.to);
        const Point x = difference(q.motion_a.to, q.motion_b.to);
        if (!overlap) {
            EXPECT_GT(largest_gap(q.a, x, q.b), 0);
            return;
        }
        ASSERT_EQ(overlap->status, HitStatus::ok);
        ++overlaps;
        const Real depth = overlap->depth;
        const Point n = tests::point(overlap->normal);
        const Real least = -largest_gap(q.a, x, q.b, {n});
        EXPECT_GT(least, -1e-6L);
        if (least > 1e-3L) worst = std::max(worst, depth / least - 1);
        // Parted: no dense search finds them more than the tolerance apart, and no point is inside both.
        EXPECT_LT(largest_gap(q.a, x + n * depth, q.b, {n}), 1e-6L);
        EXPECT_TRUE(tests::is_within(q.b, difference(overlap->point, q.motion_b.to), -1e-5L));
        EXPECT_TRUE(tests::is_within(q.a, difference(overlap->point, q.motion_a.to) - n * depth, -1e-5L));
    });
    EXPECT_GT(overlaps, 300);
    EXPECT_LT(worst, 0.05);
}

TEST(Pair, swapping_the_two_changes_no_bit_but_the_sign_of_the_normal) {
    for_all_pairs(95, 200, [](const Question& q, Random&) {
        const auto ab = pair_sweep(q.a, q.motion_a, q.b, q.motion_b);
        const auto ba = pair_sweep(q.b, q.motion_b, q.a, q.motion_a);
        ASSERT_EQ(ab.has_value(), ba.has_value());
        if (ab) {
            ASSERT_EQ(ab->t, ba->t);
            ASSERT_EQ(ab->normal, -ba->normal);
        }
        const auto inside = pair_overlap(q.a, q.motion_a.to, q.b, q.motion_b.to);
        const auto swapped = pair_overlap(q.b, q.motion_b.to, q.a, q.motion_a.to);
        ASSERT_EQ(inside.has_value(), swapped.has_value());
        if (inside) {
            ASSERT_EQ(inside->depth, swapped->depth);
            ASSERT_EQ(inside->normal, -swapped->normal);
        }
    });
}

TEST(Pair, equal_shapes_swap_as_well) {
    Random random(3);
    for (int kind = 0; kind < 6; ++kind) {
        for (int i = 0; i < 100; ++i) {
            Question q = random_question(random, kind, kind);
            q.b = q.a;
            const auto ab = pair_sweep(q.a, q.motion_a, q.b, q.motion_b);
            const auto ba = pair_sweep(q.b, q.motion_b, q.a, q.motion_a);
            ASSERT_EQ(ab.has_value(), ba.has_value());
            if (!ab) continue;
            ASSERT_EQ(ab->t, ba->t);
            ASSERT_EQ(ab->normal, -ba->normal);
        }
    }
}

TEST(Pair, scaling_everything_by_two_scales_the_answer_bit_for_bit) {
    for_all_pairs(97, 100, [](const Question& q, Random&) {
        const auto twice = [](const Volume& volume) { return Volume(tests::twice(volume.shape), volume.orientation); };
        const auto twice_motion = [](const Motion& motion) { return Motion{motion.from * 2.0, motion.to * 2.0}; };
        const auto small = pair_sweep(q.a, q.motion_a, q.b, q.motion_b);
        const auto large = pair_sweep(twice(q.a), twice_motion(q.motion_a), twice(q.b), twice_motion(q.motion_b));
        ASSERT_EQ(small.has_value(), large.has_value());
        if (small) {
            ASSERT_EQ(small->t, large->t);
            ASSERT_EQ(small->normal, large->normal);
            ASSERT_EQ(small->point * 2.0, large->point);
        }
        const auto inside = pair_overlap(q.a, q.motion_a.to, q.b, q.motion_b.to);
        const auto larger = pair_overlap(twice(q.a), q.motion_a.to * 2.0, twice(q.b), q.motion_b.to * 2.0);
        ASSERT_EQ(inside.has_value(), larger.has_value());
        if (inside) {
            ASSERT_EQ(inside->depth * 2, larger->depth);
            ASSERT_EQ(inside->normal, larger->normal);
        }
    });
}

TEST(Pair, two_of_a_kind_meet_as_the_ellipsoid_of_their_sum) {
    // Squashed by (0.8, 1.8, 0.8) they pass at 0.6 of the unit ball: 3-4-5 again, 0.8 before the closest approach.
    const Ellipsoid body{{0.4, 0.9, 0.4}};
    const Motion past{.from = {-8, 1.08, 0}, .to = {8, 1.08, 0}};
    const auto hit = pair_sweep(body, past, body, dvec3(0, 0, 0));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, (8 - 0.64) / 16, 1e-9);
    EXPECT_NEAR(hit->point.x, -0.32, 1e-6);
    EXPECT_NEAR(hit->point.y, 0.54, 1e-6);
    Random random(9);
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        Question q = random_question(random, 1, 1);
        const double scale = random.octaves(0.5, 2);
        q.b = Volume(Ellipsoid{std::get<Ellipsoid>(q.a.shape).radii * scale}, q.a.orientation);
        const auto met = pair_sweep(q.a, q.motion_a, q.b, q.motion_b);
        if (!met || met->started_inside) continue;
        ++hits;
        const Point x = difference(at(q.motion_a, met->t), at(q.motion_b, met->t));
        EXPECT_GT(gap_along(q.a, x, q.b, tests::point(met->normal)), -1e-12L);
        EXPECT_LT(largest_gap(q.a, x, q.b, {tests::point(met->normal)}), 1e-8L);
        const Point place_a = tests::point(at(q.motion_a, met->t));
        EXPECT_TRUE(tests::is_within(q.a, tests::point(met->point) - place_a, -1e-5L));
    }
    EXPECT_GT(hits, 300);
}

TEST(Pair, coinciding_shapes_have_a_way_out) {
    Random random(4);
    for (int kind_a = 0; kind_a < 6; ++kind_a) {
        for (int kind_b = 0; kind_b < 6; ++kind_b) {
            const auto overlap = pair_overlap(tests::some_shape(random, kind_a), {1, 2, 3},
                                              tests::some_shape(random, kind_b), {1, 2, 3});
            ASSERT_TRUE(overlap);
            EXPECT_EQ(overlap->status, HitStatus::ok);
            EXPECT_NEAR(static_cast<double>(length(tests::point(overlap->normal))), 1, 1e-14);
        }
    }
}

TEST(Pair, input_outside_the_limits_is_invalid_and_yields_no_nan) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {nan, std::numeric_limits<double>::infinity(), 2e9}) {
        const auto overlap = pair_overlap(Sphere{1}, {bad, 0, 0}, Sphere{1}, {0, 0, 0});
        ASSERT_TRUE(overlap);
        EXPECT_EQ(overlap->status, HitStatus::invalid);
        EXPECT_EQ(overlap->normal, dvec3(0, 0, 0));
        const auto hit = pair_sweep(Sphere{1}, {.from = {0, 0, 0}, .to = {bad, 0, 0}}, Sphere{1}, dvec3(9, 9, 9));
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->status, HitStatus::invalid);
        EXPECT_EQ(hit->t, 0);
    }
    EXPECT_EQ(pair_overlap(Sphere{nan}, {9, 0, 0}, Sphere{1}, {0, 0, 0})->status, HitStatus::invalid);
    EXPECT_EQ(pair_overlap(Sphere{1}, {9, 0, 0}, Cone{1, 0}, {0, 0, 0})->status, HitStatus::invalid);
}
