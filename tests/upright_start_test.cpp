// Cylinder and cone that start in touch: cases that kernel or judge once had wrong. The families of `surefoot prove`
// found them; each is named after what is special about it.
#include <gtest/gtest.h>

#include "upright_things.hpp"

namespace {

using judge::Kind;
using judge::Query;
using judge::Verdict;

TEST(UprightStart, a_slope_that_is_zero_to_every_digit_is_no_approach) {
    Query query = query_of(Kind::cone, 400, 480, {2097151.998626709, 1048576.0016937256, -2097152.000793457},
                           {2097151.998626709, 1048160.0016937256, -2098040.000793457});
    turn(query, 1, -2, 0, 0);
    corners(query, {3635472, 1965024, -2804288}, {558352, 132064, -1391168}, {-2703088, -1766432, -709696});
    const Asked asked = ask(query);
    EXPECT_FALSE(asked.answer.hit);
    EXPECT_EQ(asked.verdict, Verdict::right);
    EXPECT_NE(verdict_of_the_opposite(query, asked.answer), Verdict::right);
}

TEST(UprightStart, three_normals_of_a_rim_may_meet_in_one) {
    // The edge passes the rim's ellipse at the cusp of its evolute: doubles know a third of the normal's digits.
    Query query = query_of(Kind::cone, 2.8125, 5.0625, {-1.0625, -3.5, -3.75}, {-1.1015625, -3.4921875, -3.744140625});
    turn(query, 1, 2, 2, 0);
    corners(query, {3.1875, -0.9375, 7.5}, {3.1875, -8.9375, -8.5}, {81.1875, -32.9375, 3.5});
    const Asked asked = ask(query);
    EXPECT_FALSE(asked.answer.hit);
    EXPECT_EQ(asked.verdict, Verdict::right);
    EXPECT_NE(verdict_of_the_opposite(query, asked.answer), Verdict::right);
}

TEST(UprightStart, the_far_side_of_a_rim_may_be_the_way_out) {
    // Two normals of the rim lie close together; a search on a grid saw neither and took the face for the nearest.
    Query query = query_of(Kind::cylinder, 0.15625, 0.03125, {-0.3984375, 0.09375, 0.0546875},
                           {-49.1484375, 12.59375, -13.6953125});
    turn(query, 1, 1, 1, 1);
    corners(query, {-65.46875, 13.75, -19.96875}, {-65.46875, 19, -16.96875}, {64.53125, -13.75, 20.03125});
    const Asked asked = ask(query);
    EXPECT_TRUE(asked.answer.hit);
    EXPECT_EQ(asked.answer.t, 0);
    EXPECT_EQ(asked.verdict, Verdict::right);
    EXPECT_NE(verdict_of_the_opposite(query, asked.answer), Verdict::right);
}

TEST(UprightStart, leaving_by_the_far_side_of_a_rim_is_no_hit) {
    Query query = query_of(Kind::cylinder, 2, 2, {-2.2604590835203586, 1.090911258835253, 4.2406471880144325},
                           {-5.719614695482704, 0.9219742435714519, -0.5895755858239751});
    turn(query, 2, 2, -4, -3);
    corners(query, {-3.097018003463745, -1.5870442390441895, 5.321222305297852},
            {-2.8783090114593506, 2.3264517784118652, 3.248534917831421},
            {1.362303376197815, 0.04756476357579231, 6.6031599044799805});
    const Asked asked = ask(query);
    EXPECT_FALSE(asked.answer.hit);
    EXPECT_EQ(asked.verdict, Verdict::right);
    EXPECT_NE(verdict_of_the_opposite(query, asked.answer), Verdict::right);
}

TEST(UprightStart, passing_within_the_hair_and_closing_at_first_may_be_said_to_hit) {
    // The apex passes a corner at an ulp of an ulp, never in touch: the promise lets it be either.
    Query query = query_of(Kind::cone, 0.09765625, 0.15625, {0.007812500000000002, -0.00390625, 0.0078125},
                           {-0.0390625, -0.0039062499999999996, 0.0078125});
    turn(query, 1, -2, 0, 0);
    corners(query, {0.0078125, -0.00390625, 0.0078125}, {-0.0078125, 0.01171875, 0.2890625},
            {0.0703125, 0.04296875, 0.0703125});
    const Asked asked = ask(query);
    EXPECT_EQ(asked.verdict, Verdict::right);
}

TEST(UprightStart, a_rim_that_passes_a_corner_by_an_ulp_of_an_ulp_is_right_either_way) {
    Query query = query_of(Kind::cone, 6.25, 1.25, {-24, -8, -32}, {-40, -135.99999999999997, 64});
    turn(query, 1, -2, 0, 0);
    corners(query, {-23.999999999999996, -13.75, -29.25}, {-20, -21.75, -23.25}, {-27, -31.75, -53.25});
    const Asked asked = ask(query);
    EXPECT_EQ(asked.verdict, Verdict::right);
}

TEST(UprightStart, the_rim_is_nearest_at_two_points_side_by_side) {
    // The edge runs through the long axis of the ellipse that the rim is, seen along it.
    Query query =
        query_of(Kind::cylinder, 1.5625, 1.25, {-1023.90625, -768, -256.125}, {-1023.75, -767.90625, -255.8125});
    turn(query, 2, 0, 1, 0);
    corners(query, {-1020.0625, -767.75, -255}, {-1017.5625, -767.25, -256.25}, {-1026.0625, -765.75, -259.5});
    const Asked asked = ask(query);
    EXPECT_TRUE(asked.answer.hit);
    EXPECT_EQ(asked.verdict, Verdict::right);
    EXPECT_NE(verdict_of_the_opposite(query, asked.answer), Verdict::right);
}

TEST(UprightStart, an_ulp_of_zero_against_a_side_counts) {
    Query edge =
        query_of(Kind::cylinder, 0.15625, 0.28125, {5e-324, 128, 256}, {0, 127.999755859375, 255.999755859375});
    turn(edge, 1, 0, 1, 0);
    corners(edge, {-0.15625, 125.21875, 253}, {-1.15625, 128.21875, 253}, {-0.15625, 131.21875, 259});
    Query vertex = query_of(Kind::cylinder, 1.25, 0.75, {0, -512, -384}, {1.5, -510.5, -384});
    turn(vertex, 1, 0, 1, 0);
    corners(vertex, {5e-324, -511.5, -385.25}, {-4, -510.5, -386.25}, {1, -512.5, -388.25});
    Query upright = query_of(Kind::cone, 1.25, 1.25, {5e-324, -16, 12}, {-18, 8, 18});
    turn(upright, 1, 1, 1, 1);
    corners(upright, {1, -15.25, 13.25}, {3.75, -14.75, 13.25}, {1, -15.25, 13.625});
    for (const Query& query : {edge, vertex, upright}) {
        const Asked asked = ask(query);
        EXPECT_TRUE(asked.answer.hit);
        EXPECT_EQ(asked.verdict, Verdict::right);
        EXPECT_NE(verdict_of_the_opposite(query, asked.answer), Verdict::right);
    }
}

TEST(UprightStart, a_side_that_lies_in_the_face_has_the_slope_of_the_face) {
    Query query = query_of(Kind::cone, 0.390625, 0.15625, {5e-324, 0, 0.0625}, {-1652.5, 263, 446.5625});
    turn(query, 2, 1, 0, 0);
    corners(query, {77.3046875, -10.34375, -21.671875}, {-103.4375, 13.8125, 29.15625},
            {51.484375, -6.234375, -14.6953125});
    const Asked asked = ask(query);
    EXPECT_TRUE(asked.answer.hit);
    EXPECT_EQ(asked.verdict, Verdict::right);
}

TEST(UprightStart, an_ulp_of_zero_away_from_a_cap_is_no_hit) {
    Query query = query_of(Kind::cylinder, 3.125, 2.5, {0, 0, -0.75}, {0, -5e-324, -0.76171875});
    turn(query, 2, 0, 1, 0);
    corners(query, {-2.125, 2.5, -0.031249999999999997}, {-2.125, 2.5, 0.03125}, {-2.15625, 2.53125, -0.09375});
    const Asked asked = ask(query);
    EXPECT_FALSE(asked.answer.hit);
    EXPECT_EQ(asked.verdict, Verdict::right);
    EXPECT_NE(verdict_of_the_opposite(query, asked.answer), Verdict::right);
}

TEST(UprightStart, apart_by_an_ulp_of_zero_and_closing_by_less_is_right_either_way) {
    Query query = query_of(Kind::cone, 100, 40, {-2048, -2048, 5e-324}, {-1536, 0, -1536});
    turn(query, 2, 1, 0, 0);
    corners(query, {-2048, -2432, 288}, {-2176, -1920, -96}, {-2048, -1664, -288});
    EXPECT_EQ(ask(query).verdict, Verdict::right);
    EXPECT_EQ(judge::judge(query, judge::Answer{}).verdict, Verdict::right);
}

TEST(UprightStart, apart_by_an_ulp_the_apex_itself_decides) {
    Query query =
        query_of(Kind::cone, 6.25, 6.25, {-2, 6, -4.000000000000001}, {-2.0000000000000004, 6, -4.000000000000001});
    turn(query, 1, -2, 0, 0);
    corners(query, {-2, 6, -4}, {-4, -346, 460}, {-4, 164, 390});
    const Asked asked = ask(query);
    EXPECT_FALSE(asked.answer.hit);
    EXPECT_EQ(asked.verdict, Verdict::right);
}

TEST(UprightStart, apart_by_an_ulp_a_rim_is_nearest_a_level_edge_and_leaves) {
    Query query = query_of(Kind::cone, 40, 32, {256, -256, 64}, {512.0000000000001, 8064, -1344});
    turn(query, 1, 0, 1, 0);
    corners(query, {-287.99999999999994, -224, 856}, {3104, -864, 600}, {864, -224, -680});
    const Asked asked = ask(query);
    EXPECT_FALSE(asked.answer.hit);
    EXPECT_EQ(asked.verdict, Verdict::right);
}

TEST(UprightStart, an_ulp_of_zero_nearer_a_level_normal_of_a_rim_is_a_hit) {
    Query first = query_of(Kind::cone, 90, 126, {-5e-324, -131072, 98304}, {15.5, -131023.25, 98285});
    turn(first, 1, 2, 2, 0);
    corners(first, {720, -129018, 97426}, {-416, -133178, 99154}, {568, -130642, 98082});
    Query second = query_of(Kind::cone, 0.1953125, 0.15625, {-5e-324, -4, 2}, {0.000274658203125, -4, 1.9993896484375});
    turn(second, 2, 1, 0, 0);
    corners(second, {102.15625, 236.5, 96.1953125}, {395.65625, 693.5, 192.1953125}, {-101.84375, -244.5, -91.8046875});
    for (const Query& query : {first, second}) {
        const Asked asked = ask(query);
        EXPECT_TRUE(asked.answer.hit);
        EXPECT_EQ(asked.verdict, Verdict::right);
    }
}

TEST(UprightStart, an_edge_that_passes_the_apex_by_an_ulp_of_zero_is_judged) {
    Query first = query_of(Kind::cone, 0.390625, 0.46875, {-1536, 1024, -5e-324},
                           {-1536.0068664550781, 1024.0032043457031, 0.000457763671875});
    turn(first, 2, 1, 0, 0);
    corners(first, {-1532.484375, 1022.359375, -0.234375}, {-1539.515625, 1025.640625, 0.234375},
            {-1537.484375, 1023.9375, -0.34375});
    Query second =
        query_of(Kind::cone, 2.8125, 1.6875, {5e-324, -0.125, 0.1875}, {5e-324, -0.125, 0.18749999999999997});
    turn(second, 1, 2, 2, 0);
    corners(second, {0, 19.875, -4.8125}, {0, -20.125, 5.1875}, {-6, -1.125, -7.8125});
    Query third = query_of(Kind::cone, 0.1953125, 0.1953125, {-1, 0, 5e-324}, {-1, 5e-324, 5e-324});
    turn(third, 3, 1, 0, 0);
    corners(third, {-1, 0.0390625, 0.2734375}, {-1.0625, 0.9765625, 3.7109375}, {-1.125, -0.2109375, 4.7734375});
    for (const Query& query : {first, second, third}) {
        const Asked asked = ask(query);
        EXPECT_FALSE(asked.answer.hit);
        EXPECT_EQ(asked.verdict, Verdict::right);
    }
}

TEST(UprightStart, an_apex_that_ends_on_the_corner_that_it_starts_an_ulp_of_zero_from_hits_it) {
    Query query = query_of(Kind::cone, 800, 640, {-96, 128, 5e-324}, {-96, 128, 0});
    turn(query, 3, 1, 0, 0);
    corners(query, {-96, 128, 0}, {-608, -640, -5376}, {928, -3712, -1280});
    const Asked asked = ask(query);
    EXPECT_TRUE(asked.answer.hit);
    EXPECT_EQ(asked.verdict, Verdict::right);
    EXPECT_EQ(verdict_of_the_opposite(query, asked.answer), Verdict::miss);
}

TEST(UprightStart, an_apex_that_passes_by_the_corner_that_it_starts_an_ulp_of_zero_from_misses_it) {
    Query query = query_of(Kind::cone, 0.78125, 0.78125, {1024, -5e-324, 512}, {1024, -1e-323, 512});
    turn(query, 0, 1, 2, 0);
    corners(query, {1024, 0, 512}, {980, -18, 495}, {1006, -6, 501});
    const Asked asked = ask(query);
    EXPECT_FALSE(asked.answer.hit);
    EXPECT_EQ(asked.verdict, Verdict::right);
    EXPECT_EQ(verdict_of_the_opposite(query, asked.answer), Verdict::false_hit);
}

TEST(UprightStart, the_least_motion_has_a_direction_away_from_a_corner_on_the_axis) {
    Query query = query_of(Kind::cone, 200, 40, {-768, 767.992, 0}, {-768, 767.992, -5e-324});
    turn(query, 2, 0, 1, 0);
    corners(query, {-768, 768, 0}, {-768, 640, -256}, {-512, 512, -512});
    const Asked asked = ask(query);
    EXPECT_FALSE(asked.answer.hit);
    EXPECT_EQ(asked.verdict, Verdict::right);
    EXPECT_EQ(verdict_of_the_opposite(query, asked.answer), Verdict::false_hit);
}

TEST(UprightStart, a_side_that_grazes_an_edge_near_its_corner_names_the_edge_and_not_the_corner) {
    Query along = query_of(Kind::cone, 2.5, 1.5, {-0.1875000000032639, 0.2499999999975521, 0.12500000000679976},
                           {-0.2851562500032639, 0.2499999999975521, 0.07812500000679974});
    turn(along, 1, 1, 1, 1);
    corners(along, {0.8125, 1, 0.875}, {-3.1875, 73, -247.125}, {-1927.1875, 12305, 3504.875});
    Query sliver = query_of(Kind::cone, 1.5625, 0.625, {-16384, -8192, -24576},
                            {-16389.119140625, -8207.89453125, -24574.376953125});
    turn(sliver, 2, 0, 0, 1);
    corners(sliver, {-16383.875, -8191.3125, -24576.468750000004}, {-21625.875, -24467.3125, -22914.46875},
            {-37553.875, -73381.3125, -19848.46875});
    for (const Query& query : {along, sliver}) {
        Asked asked = ask(query);
        ASSERT_TRUE(asked.answer.hit);
        EXPECT_EQ(asked.answer.feature, judge::Feature::edge);
        EXPECT_EQ(asked.verdict, Verdict::right);
        asked.answer.feature = judge::Feature::vertex;
        EXPECT_EQ(judge::judge(query, asked.answer).verdict, Verdict::bad_feature);
    }
}

TEST(UprightStart, an_edge_along_the_tangent_of_a_rim_has_the_slope_of_its_own_level_normal) {
    // The normal away from the axis, through the corner on the rim, differs by an ulp of zero, and has the other sign.
    Query leaving = query_of(Kind::cone, 400, 560, {-524288, -1048576, -5e-324}, {-524108, -1049120, -108});
    turn(leaving, 3, 1, 0, 0);
    corners(leaving, {-523968, -1047984, 144}, {-523600, -1047840, 32}, {-523776, -1048528, 56});
    const Asked left = ask(leaving);
    EXPECT_FALSE(left.answer.hit);
    EXPECT_EQ(left.verdict, Verdict::right);
    EXPECT_EQ(verdict_of_the_opposite(leaving, left.answer), Verdict::false_hit);

    // Apart by an ulp of zero, it ends exactly on the edge.
    Query closing = query_of(Kind::cone, 720, 1008, {-524288, -5e-324, 524288}, {-524240, -490.25, 524212.75});
    turn(closing, 1, 2, 2, 0);
    corners(closing, {-523088, 240, 524096}, {-516944, -62512, 514464}, {-517280, -62384, 513520});
    const Asked held = ask(closing);
    EXPECT_TRUE(held.answer.hit);
    EXPECT_EQ(held.verdict, Verdict::right);
    EXPECT_EQ(verdict_of_the_opposite(closing, held.answer), Verdict::miss);
}

TEST(UprightStart, a_triangle_without_area_has_no_face_that_a_grazing_side_could_be_apart_from) {
    // In the shape's frame its corners are no longer exactly in a row, and rounding gives it a plane, 329 m away.
    Query query = query_of(Kind::cone, 50, 80, {243, 640, -2}, {-237, -640, -2});
    turn(query, 1, -2, 0, 0);
    corners(query, {-78, -184, -26}, {-246, -664, -2}, {34, 136, -42});
    const Asked asked = ask(query);
    EXPECT_TRUE(asked.answer.hit);
    EXPECT_EQ(asked.verdict, Verdict::right);
    EXPECT_EQ(verdict_of_the_opposite(query, asked.answer), Verdict::miss);
}

TEST(UprightStart, the_least_motion_is_held_by_a_side_that_it_closes_on) {
    Query query = query_of(Kind::cone, 100, 140, {-1048576, -262144, 5e-324}, {-1048576, -262144, 0});
    turn(query, 1, -2, 0, 0);
    corners(query, {-1048576, -262144, 0}, {-1035344, -223424, -14240}, {-1035344, -223424, -14240});
    const Asked asked = ask(query);
    ASSERT_TRUE(asked.answer.hit);
    EXPECT_GT(asked.answer.normal.z, 0);
    EXPECT_EQ(asked.verdict, Verdict::right);
    EXPECT_EQ(verdict_of_the_opposite(query, asked.answer), Verdict::miss);
}

/// Standing shapes whose lowest points are `up` below the reference point.
struct Standing {
    Kind kind;
    double radius, height, up;
};

class UprightOnAFloor : public testing::TestWithParam<Standing> {
protected:
    [[nodiscard]] Query moving_by(const judge::Vec& d) const {
        const Standing& s = GetParam();
        Query query = query_of(s.kind, s.radius, s.height, {0.125, s.up, 0.25}, {0.125 + d.x, s.up + d.y, 0.25 + d.z});
        corners(query, {-10, 0, -10}, {10, 0, -9}, {0, 0, 12});
        return query;
    }
};

TEST_P(UprightOnAFloor, sliding_is_free_however_it_is_turned) {
    for (const double yaw : {0.0, 0.25, 0.3826834323650898}) {
        Query query = moving_by({0.25, 0, 0.5});
        turn(query, 1, 0, yaw, 0);
        EXPECT_FALSE(ask(query).answer.hit);
        EXPECT_EQ(ask(query).verdict, Verdict::right);
    }
}

TEST_P(UprightOnAFloor, the_least_step_down_is_a_hit_and_the_least_step_up_is_none) {
    for (const double step : {0x1p-40, 0x1p-20, 1.0}) {
        const Asked down = ask(moving_by({0.25, -step, 0}));
        EXPECT_TRUE(down.answer.hit);
        EXPECT_EQ(down.verdict, Verdict::right);
        const Asked up = ask(moving_by({0.25, step, 0}));
        EXPECT_FALSE(up.answer.hit);
        EXPECT_EQ(up.verdict, Verdict::right);
    }
}

INSTANTIATE_TEST_SUITE_P(Shapes, UprightOnAFloor,
                         testing::Values(Standing{Kind::cylinder, 0.5, 1, 1}, Standing{Kind::cone, 0.5, 1, 0}));

}  // namespace
