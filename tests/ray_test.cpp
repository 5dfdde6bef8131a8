#include <gtest/gtest.h>
#include <limits>

#include <surefoot/ray.hpp>

#include "splitmix.hpp"

namespace surefoot {
namespace {

const Triangle floor_triangle{{-5, 0, -5}, {0, 0, 5}, {5, 0, -5}};

TEST(Ray, meets_a_face_where_it_crosses_it) {
    const auto hit = ray({{1, 3, 0}, {1, -1, 0}}, floor_triangle);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->t, 0.75);
    EXPECT_EQ(hit->feature, Feature::face);
    EXPECT_EQ(hit->normal.y, 1);
    EXPECT_EQ(hit->point, dvec3(1, 0, 0));
    const auto from_below = ray({{1, -3, 0}, {1, 1, 0}}, floor_triangle);
    ASSERT_TRUE(from_below.has_value());
    EXPECT_EQ(from_below->normal.y, -1);
}

TEST(Ray, stops_short_of_a_face_it_does_not_reach) {
    EXPECT_FALSE(ray({{1, 3, 0}, {1, 0.5, 0}}, floor_triangle).has_value());
    EXPECT_FALSE(ray({{1, 3, 0}, {9, 3, 0}}, floor_triangle).has_value());
    EXPECT_FALSE(ray({{9, 3, 0}, {9, -3, 0}}, floor_triangle).has_value());
}

TEST(Ray, through_an_edge_or_a_vertex_is_a_hit) {
    const auto edge = ray({{0, 1, -5}, {0, -1, -5}}, floor_triangle);
    ASSERT_TRUE(edge.has_value());
    EXPECT_EQ(edge->feature, Feature::edge);
    const auto vertex = ray({{0, 1, 5}, {0, -1, 5}}, floor_triangle);
    ASSERT_TRUE(vertex.has_value());
    EXPECT_EQ(vertex->feature, Feature::vertex);
}

TEST(Ray, within_the_plane_meets_the_first_edge) {
    const auto hit = ray({{-9, 0, -4}, {9, 0, -4}}, floor_triangle);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->feature, Feature::edge);
    EXPECT_NEAR(hit->point.x, -4.5, 1e-12);
    EXPECT_EQ(hit->normal.x, -1);
    EXPECT_FALSE(ray({{-9, 0, 6}, {9, 0, 6}}, floor_triangle).has_value());
}

TEST(Ray, that_starts_on_the_triangle_hits_it_there) {
    for (const dvec3& to : {dvec3(0, 1, 0), dvec3(0, -1, 0), dvec3(1, 0, 0)}) {
        const auto hit = ray({{0, 0, 0}, to}, floor_triangle);
        ASSERT_TRUE(hit.has_value());
        EXPECT_EQ(hit->t, 0);
        EXPECT_TRUE(hit->started_inside);
    }
    EXPECT_FALSE(ray({{0, 0, 0}, {0, 0, 0}}, floor_triangle).has_value());
}

TEST(Ray, against_a_triangle_without_area_meets_the_segment) {
    const Triangle segment{{-2, 0, 0}, {2, 0, 0}, {1, 0, 0}};
    const auto hit = ray({{0, 1, 0}, {0, -1, 0}}, segment);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->t, 0.5);
    EXPECT_FALSE(ray({{0, 1, 1e-30}, {0, -1, 1e-30}}, segment).has_value());
    EXPECT_TRUE(ray({{-9, 0, 0}, {9, 0, 0}}, segment).has_value());
}

TEST(Ray, never_slips_between_two_triangles_that_share_an_edge) {
    // Rays aimed at points of the shared edge, rounded to doubles, so that they pass within an ulp of it on either
    // side.
    tests::SplitMix random(7);
    for (int i = 0; i < 20000; ++i) {
        const dvec3 a = random.point(10);
        const dvec3 b = random.point(10);
        const dvec3 mid = (a + b) * 0.5;
        const dvec3 side = random.point(5);
        const Triangle left{a, b, mid + side};
        const Triangle right{b, a, mid - side};
        const dvec3 target = a + (b - a) * random.in(0.01, 0.99);
        const dvec3 from = random.point(20);
        const Motion motion{from, target + (target - from)};
        // A ray almost in the plane of the pair may pass beside it: ask only those that cross it clearly.
        const dvec3 u = b - a;
        const dvec3 n(u.y * side.z - u.z * side.y, u.z * side.x - u.x * side.z, u.x * side.y - u.y * side.x);
        const dvec3 d = target - from;
        const double slope = n.x * d.x + n.y * d.y + n.z * d.z;
        if (slope < 1 && slope > -1) continue;
        EXPECT_TRUE(ray(motion, left).has_value() || ray(motion, right).has_value()) << i;
    }
}

TEST(Ray, tiny_triangles_are_decided_as_exactly_as_any) {
    // Products of these coordinates are far below the smallest double.
    const Triangle tiny{{-5e-120, 0, -5e-120}, {0, 0, 5e-120}, {5e-120, 0, -5e-120}};
    EXPECT_TRUE(ray({{1e-121, 3e-120, 0}, {1e-121, -1e-120, 0}}, tiny).has_value());
    EXPECT_FALSE(ray({{9e-120, 3e-120, 0}, {9e-120, -1e-120, 0}}, tiny).has_value());
    EXPECT_FALSE(ray({{0, 3e-120, 0}, {0, 1e-120, 0}}, tiny).has_value());
}

TEST(Ray, one_sided_sees_fronts_only) {
    const Motion down{{0, 3, 0}, {0, -3, 0}};
    EXPECT_TRUE(ray(down, floor_triangle, {.one_sided = true}).has_value());
    EXPECT_FALSE(ray({down.to, down.from}, floor_triangle, {.one_sided = true}).has_value());
}

TEST(Ray, as_short_as_an_ulp_of_zero_meets_a_point_with_a_normal_of_unit_length) {
    // Found by fuzzing: the direction was lost, and the normal was zero.
    const Triangle point{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    for (const double length : {1.428065e-317, 5e-324, 1e-300}) {
        const auto hit = ray({{length, 0, 0}, {0, 0, 0}}, point);
        ASSERT_TRUE(hit.has_value()) << length;
        EXPECT_EQ(hit->normal, dvec3(1, 0, 0)) << length;
        EXPECT_EQ(hit->t, 1);
    }
}

TEST(Ray, through_a_triangle_of_a_few_ulps_of_zero_has_its_normal) {
    const double tiny = 1e-310;
    const Triangle small{{-tiny, 0, -tiny}, {-tiny, 0, tiny}, {tiny, 0, 0}};
    const auto hit = ray({{0, 1, 0}, {0, -1, 0}}, small);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->normal, dvec3(0, 1, 0));
    EXPECT_EQ(hit->t, 0.5);
}

TEST(Ray, through_a_face_that_doubles_have_lost_has_a_normal_of_unit_length) {
    // Found by fuzzing: seen from the first corner, the others are one.
    const double s = 2.5865632706146919e-231;
    const Triangle lost{
        {s, s, s}, {5.441718073798824e-317, 0, 2.2773090716423929e-311}, {2.5296161067071823e-321, 0, 0}};
    for (const dvec3& to : {dvec3(0, 0, 0), lost.b, lost.c, dvec3(-s, -s, -s)}) {
        const auto hit = ray({{2.5865632706147331e-231, s, s}, to}, lost);
        if (hit) {
            EXPECT_NEAR(glm::length(hit->normal), 1, 1e-12);
        }
    }
    const auto through = ray({{0, 0, s}, {0, 0, -s}}, {{s, s, 0}, {-s, s, 0}, {0, -s, 1e-320}});
    ASSERT_TRUE(through.has_value());
    EXPECT_NEAR(glm::length(through->normal), 1, 1e-12);
}

TEST(Ray, with_numbers_out_of_range_blocks_and_says_so) {
    const auto hit = ray({{0, std::numeric_limits<double>::quiet_NaN(), 0}, {0, 0, 0}}, floor_triangle);
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->status, HitStatus::invalid);
    EXPECT_EQ(hit->t, 0);
}

}  // namespace
}  // namespace surefoot
