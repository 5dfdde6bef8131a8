#include <cstring>
#include <gtest/gtest.h>
#include <limits>

#include <surefoot/overlap.hpp>
#include <surefoot/sweep.hpp>

#include "numeric_reference.hpp"

using namespace surefoot;
using tests::Point;
using tests::Random;
using tests::Real;

namespace {

const Triangle floor_triangle{{-10, 0, 10}, {10, 0, 10}, {0, 0, -10}};  // its front is +Y

Real depth_along(const Volume& volume, const dvec3& position, const Triangle& triangle, const Point& n) {
    Real far = -1e300L;
    for (const dvec3& corner : {triangle.a, triangle.b, triangle.c}) {
        far = std::max(far, dot(n, tests::point(corner) - tests::point(position)));
    }
    return far + tests::reach(volume, -n);
}

Real least_depth(const Volume& volume, const dvec3& position, const Triangle& triangle, int count = 400) {
    const Point a = tests::point(triangle.a);
    const Point b = tests::point(triangle.b);
    const Point c = tests::point(triangle.c);
    std::vector<Point> hints{cross(b - a, c - a)};
    const Point axes[3] = {turn(volume.orientation, Point{1, 0, 0}), turn(volume.orientation, Point{0, 1, 0}),
                           turn(volume.orientation, Point{0, 0, 1})};
    for (const Point& axis : axes) {
        hints.push_back(axis);
        for (const Point& e : {b - a, c - b, a - c}) hints.push_back(cross(e, axis));
    }
    return tests::least_over_directions([&](const Point& n) { return depth_along(volume, position, triangle, n); },
                                        hints, count);
}

struct Question {
    Volume volume;
    dvec3 position;
    Triangle triangle;
};

Question random_question(Random& random, int kind) {
    Question q;
    q.volume = Volume(std::visit([](const auto& s) { return Volume(s); }, tests::some_shape(random, kind)).shape,
                      random.orientation());
    const double size = random.octaves(0.05, 20);
    q.position = random.point(1) * (random.below(4) == 0 ? 1000.0 : 1.0);
    const dvec3 middle = q.position + random.point(0.7);
    q.triangle = {middle + random.point(size), middle + random.point(size), middle + random.point(size)};
    const int special = random.below(8);
    if (special == 0) q.triangle.c = q.triangle.a + (q.triangle.b - q.triangle.a) * random.in(0, 1);  // sliver
    if (special == 1) q.triangle.c = q.triangle.b;                                                    // segment
    if (special == 2) q.triangle.c = q.triangle.b + random.point(1e-7);                               // needle
    if (special == 3) q.triangle.b.y = q.triangle.c.y = q.triangle.a.y;                               // level
    return q;
}

// Looks at points all over the triangle.
bool some_point_is_within(const Question& q) {
    const int steps = 60;
    for (int i = 0; i <= steps; ++i) {
        for (int k = 0; i + k <= steps; ++k) {
            const Point a = tests::point(q.triangle.a);
            const Point p = a + (tests::point(q.triangle.b) - a) * (static_cast<Real>(i) / steps) +
                            (tests::point(q.triangle.c) - a) * (static_cast<Real>(k) / steps);
            if (tests::is_within(q.volume, p - tests::point(q.position), 1e-9L)) return true;
        }
    }
    return false;
}

bool same_bits(double a, double b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

}  // namespace

TEST(Overlap, a_sphere_resting_on_a_face_touches_with_zero_depth) {
    const auto touch = overlap(Sphere{0.5}, {0, 0.5, 0}, floor_triangle);
    ASSERT_TRUE(touch);
    EXPECT_EQ(touch->depth, 0);
    EXPECT_EQ(touch->normal, dvec3(0, 1, 0));
    EXPECT_EQ(touch->point, dvec3(0, 0, 0));
    EXPECT_EQ(touch->feature, Feature::face);
    EXPECT_EQ(touch->status, HitStatus::ok);
}

TEST(Overlap, a_sphere_off_a_corner_is_as_deep_as_radius_less_distance) {
    const Triangle triangle{{0, 0, 0}, {-1, 0, 0}, {0, 0, -1}};
    const auto touch = overlap(Sphere{6}, {3, 4, 0}, triangle);
    ASSERT_TRUE(touch);
    EXPECT_DOUBLE_EQ(touch->depth, 1);
    EXPECT_DOUBLE_EQ(touch->normal.x, 0.6);
    EXPECT_DOUBLE_EQ(touch->normal.y, 0.8);
    EXPECT_EQ(touch->point, triangle.a);
    EXPECT_EQ(touch->feature, Feature::vertex);
}

TEST(Overlap, a_sphere_off_an_edge_leaves_across_the_edge) {
    const Triangle triangle{{0, 0, -5}, {0, 0, 5}, {-5, 0, 0}};
    const auto touch = overlap(Sphere{5.5}, {3, -4, 1}, triangle);
    ASSERT_TRUE(touch);
    EXPECT_DOUBLE_EQ(touch->depth, 0.5);
    EXPECT_DOUBLE_EQ(touch->normal.x, 0.6);
    EXPECT_DOUBLE_EQ(touch->normal.y, -0.8);
    EXPECT_EQ(touch->feature, Feature::edge);
    EXPECT_DOUBLE_EQ(touch->point.z, 1);
}

TEST(Overlap, a_centre_exactly_on_the_plane_leaves_by_the_front) {
    for (int kind = 0; kind < 5; ++kind) {
        Random random(static_cast<std::uint64_t>(kind));
        const Volume volume(tests::some_shape(random, kind));
        const Triangle turned{floor_triangle.a, floor_triangle.c, floor_triangle.b};
        const auto up = overlap(volume, {0, 0, 0}, floor_triangle);
        const auto down = overlap(volume, {0, 0, 0}, turned);
        ASSERT_TRUE(up && down);
        EXPECT_EQ(up->normal, dvec3(0, 1, 0)) << tests::shape_name(kind);
        EXPECT_EQ(down->normal, dvec3(0, -1, 0)) << tests::shape_name(kind);
        EXPECT_EQ(up->depth, down->depth);
    }
}

TEST(Overlap, an_upright_ellipsoid_sunk_into_the_floor_leaves_straight_up) {
    const auto touch = overlap(Ellipsoid{{0.4, 0.9, 0.4}}, {0, 0.6, 0}, floor_triangle);
    ASSERT_TRUE(touch);
    EXPECT_NEAR(touch->depth, 0.3, 1e-15);
    EXPECT_DOUBLE_EQ(touch->normal.y, 1);
}

TEST(Overlap, a_capsule_standing_or_lying_is_as_deep_as_it_is_sunk) {
    const auto standing = overlap(Capsule{0.5, 1}, {0, 1.25, 0}, floor_triangle);
    ASSERT_TRUE(standing);
    EXPECT_DOUBLE_EQ(standing->depth, 0.25);
    EXPECT_DOUBLE_EQ(standing->normal.y, 1);
    const dquat on_its_side(1, 0, 0, 1);  // a quarter turn about Z, not of unit length
    const auto lying = overlap(Volume(Capsule{0.5, 1}, on_its_side), {0, 0.25, 0}, floor_triangle);
    ASSERT_TRUE(lying);
    EXPECT_NEAR(lying->depth, 0.25, 1e-15);
    EXPECT_NEAR(lying->point.x, 0, 1e-12);
}

TEST(Overlap, a_pierced_capsule_leaves_through_the_nearest_face_of_its_prism) {
    // The core stands through the floor, one metre from its edge x = 0: half of it is 3 below. Sideways is nearer.
    const Triangle triangle{{0, 0, -50}, {0, 0, 50}, {-50, 0, 0}};
    const auto touch = overlap(Capsule{0.5, 3}, {-1, 0, 0}, triangle);
    ASSERT_TRUE(touch);
    EXPECT_DOUBLE_EQ(touch->depth, 1.5);
    EXPECT_DOUBLE_EQ(touch->normal.x, 1);
    EXPECT_EQ(touch->feature, Feature::edge);
}

TEST(Overlap, a_box_on_a_floor_is_touched_in_the_middle_of_its_footprint) {
    const auto touch = overlap(Box{{1, 2, 1}}, {0.5, 1.75, 0.25}, floor_triangle);
    ASSERT_TRUE(touch);
    EXPECT_DOUBLE_EQ(touch->depth, 0.25);
    EXPECT_DOUBLE_EQ(touch->normal.y, 1);
    EXPECT_NEAR(touch->point.x, 0.5, 1e-12);
    EXPECT_NEAR(touch->point.z, 0.25, 1e-12);
    EXPECT_EQ(touch->feature, Feature::face);
}

TEST(Overlap, a_box_edge_across_a_triangle_edge_leaves_along_their_cross_product) {
    // A ridge along X at the origin, seen from above as a line; the box's lower edge runs along Z, turned 45 degrees.
    const dquat eighth(0.92387953251128675613, 0, 0, 0.38268343236508977173);
    const Triangle ridge{{-5, 0, 0}, {5, 0, 0}, {0, -5, 0}};
    const double root_two = std::sqrt(2.0);
    const auto touch = overlap(Volume(Box{{1, 1, 1}}, eighth), {0, root_two - 0.125, 0}, ridge);
    ASSERT_TRUE(touch);
    EXPECT_NEAR(touch->depth, 0.125, 1e-14);
    EXPECT_NEAR(touch->normal.y, 1, 1e-14);
    EXPECT_EQ(touch->feature, Feature::edge);
}

TEST(Overlap, a_cylinder_rim_on_an_edge_touches_and_a_hair_beyond_does_not) {
    // The rim of a 3-4-5 cylinder meets an upright edge at x = 5.
    const Triangle wall{{5, -3, 0}, {5, 3, 0}, {9, 0, 0}};
    EXPECT_TRUE(overlap(Cylinder{5, 1}, {0, 0, 0}, wall));
    EXPECT_FALSE(overlap(Cylinder{5, 1}, {-1e-9, 0, 0}, wall));
    // An oblique edge through the rim point (3, 1, 4), square to the rim's tangent there and to (3, 5, 4).
    const dvec3 rim{3, 1, 4};
    const dvec3 along{-4 + 3, 0 - 5, 3 + 4};
    const Triangle oblique{rim - along, rim + along, rim + dvec3{3, 5, 4}};
    const auto touch = overlap(Cylinder{5, 1}, {0, 0, 0}, oblique);
    ASSERT_TRUE(touch);
    EXPECT_NEAR(touch->depth, 0, 1e-12);
    EXPECT_NEAR(touch->point.x, 3, 1e-6);
    const dvec3 off = dvec3{3, 5, 4} * -1e-9;
    EXPECT_FALSE(overlap(Cylinder{5, 1}, off, oblique));
}

TEST(Overlap, a_cylinder_standing_on_a_floor_is_touched_below_its_middle) {
    const auto touch = overlap(Cylinder{0.4, 0.9}, {1, 0.8, 2}, floor_triangle);
    ASSERT_TRUE(touch);
    EXPECT_NEAR(touch->depth, 0.1, 1e-15);
    EXPECT_NEAR(touch->point.x, 1, 1e-15);
    EXPECT_NEAR(touch->point.z, 2, 1e-15);
}

TEST(Overlap, a_cone_on_its_apex_touches_with_its_reference_point) {
    const auto touch = overlap(Cone{0.4, 1.8}, {1, 0, 2}, floor_triangle);
    ASSERT_TRUE(touch);
    EXPECT_EQ(touch->depth, 0);
    EXPECT_EQ(touch->normal, dvec3(0, 1, 0));
    EXPECT_EQ(touch->point, dvec3(1, 0, 2));
    EXPECT_FALSE(overlap(Cone{0.4, 1.8}, {1, 1e-9, 2}, floor_triangle));
}

TEST(Overlap, the_side_of_a_cone_lies_along_a_face_that_leans_as_it_does) {
    // Slope 3/4: the side leaves the apex along (3, 4, 0); the wall is that plane, moved 0.125 m into the cone.
    const dvec3 outward{0.8, -0.6, 0};
    const dvec3 middle = dvec3{3, 4, 0} - outward * 0.125;
    const Triangle wall{middle + dvec3{-30, -40, -30}, middle + dvec3{-30, -40, 30}, middle + dvec3{30, 40, 0}};
    const auto touch = overlap(Cone{3, 4}, {0, 0, 0}, wall);
    ASSERT_TRUE(touch);
    EXPECT_NEAR(touch->depth, 0.125, 1e-12);
    EXPECT_NEAR(touch->normal.x, -0.8, 1e-14);
    EXPECT_NEAR(touch->normal.y, 0.6, 1e-14);
}

TEST(Overlap, triangles_without_area_are_the_segment_or_point_that_they_are) {
    for (int kind = 0; kind < 6; ++kind) {
        Random random(static_cast<std::uint64_t>(kind) + 7);
        const Volume volume(tests::some_shape(random, kind));
        const dvec3 inside{0.001, 0.05, -0.001};
        const dvec3 far{30, 20, 10};
        EXPECT_TRUE(overlap(volume, {0, 0, 0}, {inside, inside, inside})) << tests::shape_name(kind);
        EXPECT_TRUE(overlap(volume, {0, 0, 0}, {inside, far, inside + (far - inside) * 0.5}));
        EXPECT_FALSE(overlap(volume, {0, 0, 0}, {far, far, far}));
        const auto on_the_point = overlap(volume, {1, 2, 3}, {{1, 2, 3}, {1, 2, 3}, {1, 2, 3}});
        ASSERT_TRUE(on_the_point);
        EXPECT_NEAR(static_cast<double>(length(tests::point(on_the_point->normal))), 1, 1e-15);
    }
}

TEST(Overlap, one_sided_triangles_do_not_exist_for_a_reference_point_behind_them) {
    const OverlapOptions one_sided{.one_sided = true};
    EXPECT_TRUE(overlap(Sphere{1}, {0, 0.5, 0}, floor_triangle, one_sided));
    EXPECT_TRUE(overlap(Sphere{1}, {0, 0, 0}, floor_triangle, one_sided));
    EXPECT_FALSE(overlap(Sphere{1}, {0, -0x1p-1060, 0}, floor_triangle, one_sided));
    EXPECT_TRUE(overlap(Sphere{1}, {0, -0x1p-1060, 0}, floor_triangle));
    const Triangle segment{{-1, 0, 0}, {1, 0, 0}, {0, 0, 0}};
    EXPECT_TRUE(overlap(Sphere{1}, {0, -0.5, 0}, segment, one_sided));
}

TEST(Overlap, input_outside_the_limits_is_invalid_and_yields_no_nan) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    std::vector<std::optional<Overlap>> answers;
    for (const double bad : {nan, infinity, 2e9}) {
        answers.push_back(overlap(Sphere{1}, {0, bad, 0}, floor_triangle));
        answers.push_back(overlap(Sphere{1}, {0, 0, 0}, {{0, 0, 0}, {1, 0, bad}, {0, 1, 0}}));
    }
    for (const double bad : {nan, infinity, 0.0, -1.0, 1e-7, 1e7}) {
        answers.push_back(overlap(Sphere{bad}, {0, 0, 0}, floor_triangle));
        answers.push_back(overlap(Ellipsoid{{1, bad, 1}}, {0, 0, 0}, floor_triangle));
        answers.push_back(overlap(Cone{1, bad}, {0, 0, 0}, floor_triangle));
    }
    answers.push_back(overlap(Volume(Sphere{1}, dquat(0, 0, 0, 0)), {0, 0, 0}, floor_triangle));
    for (const auto& answer : answers) {
        ASSERT_TRUE(answer);
        EXPECT_EQ(answer->status, HitStatus::invalid);
        EXPECT_EQ(answer->normal, dvec3(0, 0, 0));
        EXPECT_EQ(answer->depth, 0);
    }
}

TEST(Overlap, the_way_out_is_enough_and_no_dense_search_finds_a_shorter_one) {
    for (int kind = 0; kind < 6; ++kind) {
        Random random(100 + static_cast<std::uint64_t>(kind));
        int touching = 0;
        Real worst_excess = 0;
        for (int i = 0; i < 400; ++i) {
            const Question q = random_question(random, kind);
            const auto answer = overlap(q.volume, q.position, q.triangle);
            const Real least = least_depth(q.volume, q.position, q.triangle);
            SCOPED_TRACE(testing::Message() << tests::shape_name(kind) << " " << i);
            if (!answer) {
                EXPECT_FALSE(some_point_is_within(q));
                continue;
            }
            ++touching;
            EXPECT_GT(least, -1e-11L);
            const Point n = tests::point(answer->normal);
            EXPECT_NEAR(static_cast<double>(length(n)), 1, 1e-14);
            const Real needed = depth_along(q.volume, q.position, q.triangle, n);
            double bound = 1;
            if (const auto* e = std::get_if<Ellipsoid>(&q.volume.shape)) {
                const dvec3 r = e->radii;
                bound = std::max({r.x, r.y, r.z}) / std::min({r.x, r.y, r.z});
            } else {
                EXPECT_NEAR(static_cast<double>(needed), answer->depth, 1e-11);
            }
            if (least > 1e-6L) worst_excess = std::max(worst_excess, answer->depth / least - 1);
            EXPECT_LE(answer->depth, static_cast<double>(least) * bound + 1e-9);
        }
        RecordProperty(tests::shape_name(kind), std::to_string(static_cast<double>(worst_excess)));
        EXPECT_GT(touching, 40);
    }
}

TEST(Overlap, moving_by_the_depth_leaves_the_shape_just_touching_at_the_point) {
    for (int kind = 0; kind < 6; ++kind) {
        Random random(200 + static_cast<std::uint64_t>(kind));
        for (int i = 0; i < 300; ++i) {
            const Question q = random_question(random, kind);
            const auto answer = overlap(q.volume, q.position, q.triangle);
            if (!answer) continue;
            SCOPED_TRACE(testing::Message() << tests::shape_name(kind) << " " << i);
            const dvec3 moved = q.position + answer->normal * answer->depth;
            // The plane that now lies between them: for an ellipsoid its own surface gives it, as it leaves askew.
            Point plane = tests::point(answer->normal);
            if (const auto* e = std::get_if<Ellipsoid>(&q.volume.shape)) {
                const Point own = turn_back(q.volume.orientation, tests::point(moved) - tests::point(answer->point));
                const Point steep{own.x / (e->radii.x * e->radii.x), own.y / (e->radii.y * e->radii.y),
                                  own.z / (e->radii.z * e->radii.z)};
                plane = unit(turn(q.volume.orientation, steep));
            }
            EXPECT_NEAR(static_cast<double>(depth_along(q.volume, moved, q.triangle, plane)), 0, 2e-9);
            // The point is of the triangle, and on the surface of the shape once that has been moved.
            const Point p = tests::point(answer->point) - tests::point(moved);
            EXPECT_TRUE(tests::is_within(q.volume, p * (1 - 1e-9L), -1e-6L));
            EXPECT_FALSE(tests::is_within(q.volume, p, 1e-6L));
            const Real off = tests::least_over_directions([&](const Point& n) {
                Real near = 1e300L;
                for (const dvec3& corner : {q.triangle.a, q.triangle.b, q.triangle.c}) {
                    near = std::min(near, dot(n, tests::point(corner) - tests::point(answer->point)));
                }
                return -near;
            });
            EXPECT_GT(off, -1e-9L);
        }
    }
}

TEST(Overlap, a_point_of_the_triangle_strictly_inside_the_shape_is_always_found) {
    for (int kind = 0; kind < 6; ++kind) {
        Random random(300 + static_cast<std::uint64_t>(kind));
        int inside = 0;
        for (int i = 0; i < 20000; ++i) {
            const Question q = random_question(random, kind);
            const double u = random.in(0, 1);
            const double v = random.in(0, 1) * (1 - u);
            const dvec3 p = q.triangle.a + (q.triangle.b - q.triangle.a) * u + (q.triangle.c - q.triangle.a) * v;
            if (!tests::is_within(q.volume, tests::point(p) - tests::point(q.position))) continue;
            ++inside;
            ASSERT_TRUE(overlap(q.volume, q.position, q.triangle)) << tests::shape_name(kind) << " " << i;
        }
        EXPECT_GT(inside, 500);
    }
}

TEST(Overlap, where_a_sweep_stopped_a_skin_thicker_shape_touches_and_a_thinner_one_does_not) {
    Random random(600);
    int stopped = 0;
    for (int i = 0; i < 2000; ++i) {
        const Question q = random_question(random, 0);
        const double radius = std::get<Sphere>(q.volume.shape).radius;
        const Motion motion{q.position + random.point(20), q.position};
        const auto hit = sweep(q.volume, motion, q.triangle);
        if (!hit || hit->started_inside) continue;
        ++stopped;
        const dvec3 place = motion.from + (motion.to - motion.from) * hit->t;
        EXPECT_TRUE(overlap(Sphere{radius + 1e-8}, place, q.triangle));
        EXPECT_FALSE(overlap(Sphere{radius - 1e-8}, place, q.triangle));
    }
    EXPECT_GT(stopped, 300);
}

TEST(Overlap, scaling_everything_by_two_scales_the_answer_bit_for_bit) {
    for (int kind = 0; kind < 6; ++kind) {
        Random random(400 + static_cast<std::uint64_t>(kind));
        for (int i = 0; i < 2000; ++i) {
            const Question q = random_question(random, kind);
            const auto small = overlap(q.volume, q.position, q.triangle);
            const auto large = overlap(Volume(tests::twice(q.volume.shape), q.volume.orientation), q.position * 2.0,
                                       {q.triangle.a * 2.0, q.triangle.b * 2.0, q.triangle.c * 2.0});
            ASSERT_EQ(small.has_value(), large.has_value());
            if (!small) continue;
            ASSERT_TRUE(same_bits(2 * small->depth, large->depth));
            ASSERT_EQ(small->normal, large->normal);
            ASSERT_EQ(small->point * 2.0, large->point);
            ASSERT_EQ(small->feature, large->feature);
        }
    }
}

TEST(Overlap, the_order_of_the_corners_changes_no_bit) {
    for (int kind = 0; kind < 6; ++kind) {
        Random random(500 + static_cast<std::uint64_t>(kind));
        for (int i = 0; i < 2000; ++i) {
            const Question q = random_question(random, kind);
            const auto abc = overlap(q.volume, q.position, q.triangle);
            const auto bca = overlap(q.volume, q.position, {q.triangle.b, q.triangle.c, q.triangle.a});
            const auto acb = overlap(q.volume, q.position, {q.triangle.a, q.triangle.c, q.triangle.b});
            ASSERT_EQ(abc.has_value(), bca.has_value());
            ASSERT_EQ(abc.has_value(), acb.has_value());
            if (!abc) continue;
            ASSERT_TRUE(same_bits(abc->depth, bca->depth));
            ASSERT_EQ(abc->normal, bca->normal);
            ASSERT_EQ(abc->point, bca->point);
            ASSERT_NEAR(abc->depth, acb->depth, 1e-12 * (1 + abc->depth));
        }
    }
}
