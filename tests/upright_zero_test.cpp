// Cylinder and cone by an ulp of zero from a face or a corner: more cases that kernel or judge once had wrong.
#include <gtest/gtest.h>

#include "upright_things.hpp"

namespace {

using judge::Kind;
using judge::Query;
using judge::Verdict;

TEST(UprightZero, a_face_that_stands_an_ulp_of_zero_off_upright_has_its_own_slope_and_not_that_of_its_edges) {
    // The normals of the face and of the side across each edge are an ulp of zero apart, and all perpendicular to
    // edges.
    Query first = query_of(Kind::cylinder, 10, 8, {74, 46, 2}, {-94, -80, -12});
    turn(first, 1, 1, 1, 1);
    corners(first, {-4, 5e-324, -138}, {380, 288, 246}, {-388, -288, -138});
    Query second = query_of(Kind::cylinder, 1.5625, 1.5625, {0.1875, 0.0625, 0.4375}, {-0.1875, -0.3125, -0.0625});
    turn(second, 1, -2, 0, 0);
    corners(second, {-0.25, -1.3125, -4}, {-0.5, 0.1875, -2}, {0.75, 1.6875, -5e-324});
    Query inside = query_of(Kind::cylinder, 80, 112, {76, -13, 55}, {60, -17, 67});
    corners(inside, {2064, 384, -1536}, {-2032, -2176, 1536}, {16, 1408, 5e-324});
    for (const Query& query : {first, second, inside}) {
        const Asked asked = ask(query);
        EXPECT_TRUE(asked.answer.hit);
        EXPECT_EQ(asked.verdict, Verdict::right);
    }
    // Deeper by an ulp of zero, and so it has to be held.
    EXPECT_EQ(judge::judge(inside, judge::Answer{}).verdict, Verdict::miss);
}

TEST(UprightZero, a_rim_that_nears_a_corner_by_an_ulp_of_zero_before_it_passes_by_is_right_either_way) {
    // Its normal, (0, 4, 3) in the shape's frame, is that of no part; the slope is an ulp of zero.
    Query query = query_of(Kind::cylinder, 50, 80, {-393216, 131072, -5e-324}, {-393216.015625, 131072, 0});
    turn(query, 1, -2, 0, 0);
    corners(query, {-393216, 131080, 94}, {-393220, 131002, 440}, {-393218, 130998, 268});
    const Asked asked = ask(query);
    EXPECT_EQ(asked.verdict, Verdict::right);
    judge::Answer held{true, 0, {0, -0.6, -0.8}, {-393216, 131080, 94}};
    held.feature = judge::Feature::vertex;
    EXPECT_EQ(judge::judge(query, held).verdict, Verdict::right);
    EXPECT_EQ(judge::judge(query, judge::Answer{}).verdict, Verdict::right);
    // Leaving by as little, or sliding past, it may not be held.
    for (const double z : {-1e-323, -5e-324}) {
        query.to.z = z;
        EXPECT_EQ(judge::judge(query, held).verdict, Verdict::false_hit);
    }
}

TEST(UprightZero, a_triangle_as_thin_as_an_ulp_of_zero_has_a_face_that_the_motion_leaves) {
    Query query = query_of(Kind::cone, 50, 10, {2097152, 524288, 0}, {1294976, 484992, 12928});
    turn(query, 2, 0, 1, 0);
    corners(query, {2498240, 544704, -2144}, {1696064, 503872, 2144}, {2097152, 524288, 5e-324});
    const Asked asked = ask(query);
    EXPECT_FALSE(asked.answer.hit);
    EXPECT_EQ(asked.verdict, Verdict::right);
    EXPECT_EQ(verdict_of_the_opposite(query, asked.answer), Verdict::false_hit);
}

}  // namespace
