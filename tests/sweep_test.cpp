// Sweeps with answers that a hand can compute.
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

#include <surefoot/sweep.hpp>

#include "splitmix.hpp"

namespace surefoot {
namespace {

const Triangle floor_triangle{{-5, 0, -5}, {0, 0, 5}, {5, 0, -5}};

struct Standing {
    Shape shape;
    double height;  // of the reference point above a floor that the upright shape just touches
};

const std::array<Standing, 6> all_shapes{{{Sphere{0.5}, 0.5},
                                          {Ellipsoid{{0.4, 0.9, 0.4}}, 0.9},
                                          {Capsule{0.25, 0.5}, 0.75},
                                          {Box{{0.4, 0.9, 0.4}}, 0.9},
                                          {Cylinder{0.4, 0.9}, 0.9},
                                          {Cone{0.4, 1.8}, 0.0}}};

TEST(Sweep, every_shape_lands_on_a_floor_when_its_lowest_point_reaches_it) {
    for (const Standing& standing : all_shapes) {
        const auto hit = sweep(standing.shape, {{0.25, 3, 0.25}, {0.25, -1, 0.25}}, floor_triangle);
        ASSERT_TRUE(hit.has_value());
        EXPECT_NEAR(hit->t, (3 - standing.height) / 4, 1e-12);
        EXPECT_LE(hit->t, (3 - standing.height) / 4);
        EXPECT_EQ(hit->feature, Feature::face);
        EXPECT_NEAR(hit->normal.y, 1, 1e-12);
        EXPECT_NEAR(hit->point.y, 0, 1e-12);
        EXPECT_FALSE(hit->started_inside);
        EXPECT_EQ(hit->status, HitStatus::ok);
    }
}

TEST(Sweep, the_same_from_below_with_the_normal_pointing_down) {
    for (const Standing& standing : all_shapes) {
        const double top = std::holds_alternative<Cone>(standing.shape) ? 1.8 : standing.height;
        const auto hit = sweep(standing.shape, {{0, -4, 0}, {0, 4, 0}}, floor_triangle);
        ASSERT_TRUE(hit.has_value());
        EXPECT_NEAR(hit->t, (4 - top) / 8, 1e-12);
        EXPECT_NEAR(hit->normal.y, -1, 1e-12);
    }
}

TEST(Sweep, a_shape_standing_on_a_floor_may_slide_and_leave_but_not_go_down) {
    for (const Standing& standing : all_shapes) {
        const dvec3 at(0, standing.height, 0);
        EXPECT_FALSE(sweep(standing.shape, {at, at + dvec3(1, 0, 0.5)}, floor_triangle).has_value());
        EXPECT_FALSE(sweep(standing.shape, {at, at + dvec3(1, 0.25, 0)}, floor_triangle).has_value());
        const auto hit = sweep(standing.shape, {at, at + dvec3(1, -0.25, 0)}, floor_triangle);
        ASSERT_TRUE(hit.has_value());
        EXPECT_EQ(hit->t, 0);
        EXPECT_TRUE(hit->started_inside);
        EXPECT_NEAR(hit->normal.y, 1, 1e-12);
    }
}

TEST(Sweep, standing_still_is_never_a_hit) {
    for (const Standing& standing : all_shapes) {
        EXPECT_FALSE(sweep(standing.shape, {{0, 0.1, 0}, {0, 0.1, 0}}, floor_triangle).has_value());
    }
}

TEST(Sweep, a_shape_cut_in_the_middle_may_move_along_the_cut_but_not_along_the_way_deeper) {
    // 0.1 below the surface the way out is up for every shape but the cone, whose apex is far through.
    for (const Standing& standing : all_shapes) {
        if (std::holds_alternative<Cone>(standing.shape)) continue;
        const dvec3 at(0, standing.height - 0.1, 0);
        EXPECT_FALSE(sweep(standing.shape, {at, at + dvec3(0, 3, 0)}, floor_triangle).has_value());
        EXPECT_TRUE(sweep(standing.shape, {at, at - dvec3(0, 3, 0)}, floor_triangle).has_value());
    }
}

TEST(Sweep, a_sphere_meets_an_edge_at_three_four_five) {
    // The edge from (-5, 0, -5) to (5, 0, -5); the centre passes 3 above it with radius 5, so it stops 4 before it.
    const auto hit = sweep(Sphere{5}, {{0, 3, -25}, {0, 3, -5}}, floor_triangle);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->t, 16.0 / 20.0, 1e-12);
    EXPECT_EQ(hit->feature, Feature::edge);
    EXPECT_NEAR(hit->normal.y, 0.6, 1e-12);
    EXPECT_NEAR(hit->normal.z, -0.8, 1e-12);
    EXPECT_NEAR(hit->point.z, -5, 1e-12);
}

TEST(Sweep, a_sphere_meets_a_vertex_and_reports_the_callers_own_numbers) {
    const auto hit = sweep(Sphere{5}, {{0, 3, 25}, {0, 3, 5}}, floor_triangle);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->t, 16.0 / 20.0, 1e-12);
    EXPECT_EQ(hit->feature, Feature::vertex);
    EXPECT_EQ(hit->point, dvec3(0, 0, 5));
}

TEST(Sweep, an_ellipsoid_is_a_sphere_in_squashed_space_with_a_normal_of_the_world) {
    // Squashed by (1, 2, 1), the picture of the three-four-five edge: passes 6 above with radii (5, 10, 5).
    const auto hit = sweep(Ellipsoid{{5, 10, 5}}, {{0, 6, -25}, {0, 6, -5}}, floor_triangle);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->t, 16.0 / 20.0, 1e-12);
    // The contact is at (0, -6, 4) from the centre; the normal is proportional to contact / radii^2.
    const double y = 6.0 / 100.0;
    const double z = -4.0 / 25.0;
    const double size = std::sqrt(y * y + z * z);
    EXPECT_NEAR(hit->normal.y, y / size, 1e-12);
    EXPECT_NEAR(hit->normal.z, z / size, 1e-12);
}

TEST(Sweep, a_capsule_grazing_an_edge_is_a_hit) {
    // Exactly tangent: the core passes at distance 0.5 beside the edge at z = -5, which it only touches.
    const Triangle wall{{-5, -5, -5}, {5, -5, -5}, {0, 5, -5}};
    EXPECT_TRUE(sweep(Capsule{0.5, 0.5}, {{-9, -6, -5}, {9, -6, -5}}, wall).has_value());
    EXPECT_FALSE(sweep(Capsule{0.5, 0.5}, {{-9, -6.001, -5}, {9, -6.001, -5}}, wall).has_value());
}

TEST(Sweep, a_thin_ledge_met_edge_on_is_a_hit_for_every_shape) {
    const Triangle ledge{{-2, 0, 0}, {2, 0, 0}, {0, 0, 3}};
    for (const Standing& standing : all_shapes) {
        const double y = std::holds_alternative<Cone>(standing.shape) ? -0.9 : 0;
        const auto hit = sweep(standing.shape, {{0, y, -9}, {0, y, 9}}, ledge);
        ASSERT_TRUE(hit.has_value());
        EXPECT_EQ(hit->feature, Feature::edge);
        EXPECT_LT(hit->normal.z, -0.5);
    }
}

TEST(Sweep, a_cylinder_meets_a_slanted_edge_with_its_rim) {
    // The edge z = y in the plane x = 0; the lower rim's foremost point (0, -1, 1) meets it coming along z.
    const Triangle slope{{0, -5, -5}, {0, 5, 5}, {9, 0, 20}};
    const auto hit = sweep(Cylinder{1, 1}, {{0, 0, -10}, {0, 0, 10}}, slope);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->t, (10.0 - 2.0) / 20.0, 1e-12);
    EXPECT_EQ(hit->feature, Feature::edge);
    EXPECT_NEAR(hit->point.y, -1, 1e-9);
}

TEST(Sweep, a_cone_meets_a_vertex_with_its_side) {
    // Radius 1 at height 2: half a metre wide one metre up, where the vertex is.
    const Triangle spike{{0, 1, 0}, {-1, 9, 9}, {1, 9, 9}};
    const auto hit = sweep(Cone{1, 2}, {{0, 0, -5}, {0, 0, 5}}, spike);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->t, 4.5 / 10, 1e-12);
    EXPECT_EQ(hit->feature, Feature::vertex);
    EXPECT_NEAR(hit->normal.y / -hit->normal.z, 0.5, 1e-12);
}

TEST(Sweep, orientation_turns_the_shape) {
    const dquat quarter(1, 0, 0, 1);  // about z, of length sqrt(2) on purpose: +y of the shape is -x of the world
    const auto lying = sweep(Volume(Cylinder{0.25, 2}, quarter), {{0, 3, 0}, {0, -1, 0}}, floor_triangle);
    ASSERT_TRUE(lying.has_value());
    EXPECT_NEAR(lying->t, 2.75 / 4, 1e-12);
}

TEST(Sweep, a_one_sided_triangle_exists_only_against_its_front) {
    const Triangle front_up{{-5, 0, -5}, {0, 0, 5}, {5, 0, -5}};
    const Triangle front_down{{-5, 0, -5}, {5, 0, -5}, {0, 0, 5}};
    const Motion down{{0, 3, 0}, {0, -3, 0}};
    EXPECT_TRUE(sweep(Sphere{0.5}, down, front_up, {.one_sided = true}).has_value());
    EXPECT_FALSE(sweep(Sphere{0.5}, down, front_down, {.one_sided = true}).has_value());
    EXPECT_FALSE(sweep(Sphere{0.5}, {{-9, 0, 0}, {9, 0, 0}}, front_up, {.one_sided = true}).has_value());
    const Triangle no_area{{-5, 0, 0}, {0, 0, 0}, {5, 0, 0}};
    EXPECT_TRUE(sweep(Sphere{0.5}, down, no_area).has_value());
    EXPECT_FALSE(sweep(Sphere{0.5}, down, no_area, {.one_sided = true}).has_value());
}

TEST(Sweep, a_triangle_without_area_is_the_segment_or_the_point_that_it_is) {
    const Motion down{{0, 3, 0}, {0, -3, 0}};
    const auto on_segment = sweep(Sphere{0.5}, down, {{-5, 0, 0}, {5, 0, 0}, {1, 0, 0}});
    ASSERT_TRUE(on_segment.has_value());
    EXPECT_NEAR(on_segment->t, 2.5 / 6, 1e-12);
    EXPECT_EQ(on_segment->feature, Feature::edge);
    const auto on_point = sweep(Sphere{0.5}, down, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
    ASSERT_TRUE(on_point.has_value());
    EXPECT_NEAR(on_point->t, 2.5 / 6, 1e-12);
    EXPECT_EQ(on_point->feature, Feature::vertex);
}

TEST(Sweep, what_cannot_be_answered_blocks_and_says_so) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double infinity = std::numeric_limits<double>::infinity();
    const Motion far{{0, 50, 0}, {1, 50, 0}};
    const auto expect_blocked = [](const std::optional<Hit>& hit) {
        ASSERT_TRUE(hit.has_value());
        EXPECT_EQ(hit->status, HitStatus::invalid);
        EXPECT_EQ(hit->t, 0);
        EXPECT_EQ(hit->normal, dvec3(0, 0, 0));
    };
    expect_blocked(sweep(Sphere{0}, far, floor_triangle));
    expect_blocked(sweep(Sphere{nan}, far, floor_triangle));
    expect_blocked(sweep(Sphere{-1}, far, floor_triangle));
    expect_blocked(sweep(Ellipsoid{{1, 20000, 1}}, far, floor_triangle));
    expect_blocked(sweep(Box{{1, infinity, 1}}, far, floor_triangle));
    expect_blocked(sweep(Volume(Box{}, dquat(0, 0, 0, 0)), far, floor_triangle));
    expect_blocked(sweep(Volume(Box{}, dquat(nan, 0, 0, 0)), far, floor_triangle));
    expect_blocked(sweep(Sphere{1}, {{0, nan, 0}, {0, 0, 0}}, floor_triangle));
    expect_blocked(sweep(Sphere{1}, {{0, 50, 0}, {0, 2e9, 0}}, floor_triangle));
    expect_blocked(sweep(Sphere{1}, far, {{0, 0, 0}, {infinity, 0, 0}, {0, 0, 1}}));
}

TEST(Sweep, a_capsule_without_a_straight_part_is_a_sphere) {
    const Motion motion{{0.3, 3, 0.2}, {0.5, -3, 5.5}};
    const auto capsule = sweep(Capsule{0.5, 0}, motion, floor_triangle);
    const auto sphere = sweep(Sphere{0.5}, motion, floor_triangle);
    ASSERT_TRUE(capsule && sphere);
    EXPECT_NEAR(capsule->t, sphere->t, 1e-12);
}

TEST(Sweep, a_contact_can_be_left_but_not_passed_when_it_is_swept_from_again) {
    const Motion down{{0.1, 3, 5.1}, {0.05, -3, 4.9}};
    for (const Standing& standing : all_shapes) {
        const auto hit = sweep(standing.shape, down, floor_triangle);
        ASSERT_TRUE(hit.has_value());
        const dvec3 at = down.from + hit->t * (down.to - down.from);
        const auto again = sweep(standing.shape, {at, down.to}, floor_triangle);
        ASSERT_TRUE(again.has_value());
        EXPECT_LT(again->t, 1e-9);
        EXPECT_FALSE(sweep(standing.shape, {at, down.from}, floor_triangle).has_value());
    }
}

TEST(Sweep, two_triangles_that_share_an_edge_stop_a_shape_on_it_at_one_t) {
    tests::SplitMix random(3);
    for (const Standing& standing : all_shapes) {
        int compared = 0;
        for (int i = 0; i < 20000; ++i) {
            const dvec3 a = random.point(3);
            const dvec3 b = random.point(3);
            const Volume volume(standing.shape, i % 2 == 0 ? random.turn() : dquat(1, 0, 0, 0));
            const Motion motion{random.point(4), random.point(4)};
            const auto left = sweep(volume, motion, {a, b, random.point(3)});
            const auto right = sweep(volume, motion, {b, a, random.point(3)});
            if (!left || !right || left->t == 0) continue;
            if (left->feature != Feature::edge || right->feature != Feature::edge) continue;
            const dvec3 apart = left->normal - right->normal;
            if (apart.x * apart.x + apart.y * apart.y + apart.z * apart.z > 1e-20) continue;  // another edge of one
            EXPECT_EQ(left->t, right->t);
            ++compared;
        }
        EXPECT_GT(compared, 200);
    }
}

TEST(Sweep, a_trace_tells_which_planes_were_asked_and_what_was_decided) {
    std::array<TraceRecord, 64> room;
    Trace trace(room);
    const auto hit = sweep(Sphere{0.5}, {{0, 3, 0}, {0, -1, 0}}, floor_triangle, {}, &trace);
    ASSERT_TRUE(hit.has_value());
    ASSERT_FALSE(trace.records().empty());
    EXPECT_EQ(trace.dropped(), 0U);
    EXPECT_EQ(trace.records().back().verdict, Verdict::decided);
    EXPECT_EQ(trace.records().back().t, hit->t);
    double last = 0;
    for (const TraceRecord& record : trace.records()) {
        if (record.verdict == Verdict::enters && record.t > last) last = record.t;
    }
    EXPECT_EQ(last, hit->t);
}

TEST(Sweep, a_trace_says_that_the_start_was_in_touch) {
    std::array<TraceRecord, 128> room;
    for (const double rise : {-0.25, 0.25}) {
        Trace trace(room);
        const auto hit = sweep(Sphere{0.5}, {{0, 0.5, 0}, {1, 0.5 + rise, 0}}, floor_triangle, {}, &trace);
        EXPECT_EQ(hit.has_value(), rise < 0);
        int contacts = 0;
        for (const TraceRecord& record : trace.records()) {
            if (record.verdict != Verdict::contact) continue;
            ++contacts;
            EXPECT_NEAR(record.normal.y, 1, 1e-12);
            EXPECT_NEAR(record.gap_from, 0, 1e-12);
        }
        EXPECT_EQ(contacts, 1);
    }
}

TEST(Sweep, a_trace_names_the_edge_or_vertex_in_the_callers_order) {
    const auto decisive = [](const Motion& motion, const Triangle& triangle) {
        std::array<TraceRecord, 64> room;
        Trace trace(room);
        const auto hit = sweep(Sphere{0.5}, motion, triangle, {}, &trace);
        EXPECT_TRUE(hit.has_value());
        TraceRecord last;
        for (const TraceRecord& record : trace.records()) {
            if (record.verdict == Verdict::enters && record.t == hit->t) last = record;
        }
        return last;
    };
    // The far edge, from a at x = -5 to c at x = 5, met from outside; as ca, as ab, as bc.
    const Motion to_far_edge{{0, 0.25, -9}, {0, 0.25, 0}};
    const dvec3 a(-5, 0, -5);
    const dvec3 b(0, 0, 5);
    const dvec3 c(5, 0, -5);
    EXPECT_EQ(decisive(to_far_edge, {a, b, c}).feature_index, 2);
    EXPECT_EQ(decisive(to_far_edge, {a, c, b}).feature_index, 0);
    EXPECT_EQ(decisive(to_far_edge, {b, a, c}).feature_index, 1);
    const Motion to_tip{{0, 0.25, 9}, {0, 0.25, 0}};
    EXPECT_EQ(decisive(to_tip, {a, b, c}).feature, Feature::vertex);
    EXPECT_EQ(decisive(to_tip, {a, b, c}).feature_index, 1);
    EXPECT_EQ(decisive(to_tip, {c, a, b}).feature_index, 2);
}

}  // namespace
}  // namespace surefoot
