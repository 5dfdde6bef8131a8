// Queries that were once answered wrongly, found by `surefoot prove`: starts within the hair of a triangle, contacts in
// its plane, triangles that have no area but for rounding.
#include <array>
#include <gtest/gtest.h>

#include <surefoot/sweep.hpp>

namespace surefoot {
namespace {

struct Question {
    Shape shape;
    dquat turn;  // w, x, y, z
    Motion motion;
    Triangle triangle;

    [[nodiscard]] std::optional<Hit> answer() const { return sweep(Volume(shape, turn), motion, triangle); }
};

double inner(const dvec3& a, const dvec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

TEST(SweepStart, a_box_a_hair_from_a_sharp_edge_that_does_not_come_closer_passes) {
    const std::array<Question, 2> passing{{
        {Box{{0.46875, 0.15625, 1.40625}},
         dquat(1, -2, 0, 0),
         {{0, -2048.0000000000005, 6144}, {0.018066406249999997, -2048.10693359375, 6143.98193359375}},
         {{0.46875, -2046.96875, 6143.03125},
          {14.46875, -2046.96875, 6153.03125},
          {34.46875, -2192.96875, 6125.03125}}},
        {Box{{0.15625, 0.09765625, 0.05859375}},
         dquat(0, 1, 2, 0),
         {{-8192, 0, -6144}, {-8191.9997482299805, -0.002529144287109375, -6143.999771118164}},
         {{-8190.296875000001, 0.06640625, -6146.12109375},
          {-8194.046875, 0.06640625, -6141.99609375},
          {-8188.546875, -55.18359375, -6136.99609375}}},
    }};
    for (const Question& question : passing) EXPECT_FALSE(question.answer().has_value());
}

TEST(SweepStart, a_box_a_hair_from_a_sharp_edge_is_not_stopped_by_the_face_that_it_leaves) {
    const std::array<Question, 3> leaving{{
        {Box{{0.4375, 0.3125, 0.5625}},
         dquat(1, 0, 1, 0),
         {{-32, 32, 32}, {-32.00006866455078, 31.999984741210934, 32.000022888183594}},
         {{-31.437500000000004, 32, 32.4375}, {-13.4375, 32, 26.4375}, {-41.4375, 40, 42.4375}}},
        {Box{{640, 560, 160}},
         dquat(1, -2, 0, 0),
         {{-8192, 0, -32768}, {-14592, 1024.0000000000002, -33536}},
         {{-7552.000000000001, 336, -32320}, {-22912, -2736, -23616}, {-7552, -1712, -30784}}},
        {Box{{10, 5, 12.5}},
         dquat(2, 0, 1, 0),
         {{1, 0, -1}, {-0.0625, 0.8124999999999999, -0.9375}},
         {{10.999999999999998, 5, 6.5}, {15.25, 1, 7.5}, {5.5, 16, 8}}},
    }};
    for (const Question& question : leaving) {
        const auto hit = question.answer();
        ASSERT_TRUE(hit.has_value());
        const dvec3 along = question.motion.to - question.motion.from;
        EXPECT_LT(inner(hit->normal, along), 1e-9 * glm::length(along));
    }
}

TEST(SweepStart, the_least_motion_there_is_goes_against_the_normal) {
    const Question question{Box{{0.17578125, 0.2109375, 0.03515625}},
                            dquat(1, 2, 2, 0),
                            {{-0.0625, -0.06249999999999999, 0}, {-0.0625, -0.06249999999999999, -5e-324}},
                            {{14.97265625, 15.3359375, 0.19921875},
                             {-15.46484375, -15.1640625, -0.48828125},
                             {-4.30859375, -3.3828125, -1.20703125}}};
    const auto hit = question.answer();
    ASSERT_TRUE(hit.has_value());
    EXPECT_GE(hit->normal.z, -1e-12);
}

TEST(SweepStart, a_start_less_deep_than_the_allowed_gap_has_its_point_on_the_feature) {
    // Coordinates of 4e8 m: 0.04 m are allowed, and the box is half that thick.
    const Question question{Box{{0.8853340485645561, 0.008049601717386726, 0.8853340485645561}},
                            dquat(4, -4, -4, 2),
                            {{-370642371.9295641, 669693498.4546099, 203509721.5709053},
                             {-370642371.9293603, 669693498.4543343, 203509721.57071608}},
                            {{-370642371.4835565, 669693498.7739686, 203509721.81176865},
                             {-370642372.52537954, 669693497.9346409, 203509721.2222983},
                             {-370642371.4374415, 669693498.4847344, 203509721.73742485}}};
    const auto hit = question.answer();
    ASSERT_TRUE(hit.has_value());
    ASSERT_EQ(hit->feature, Feature::vertex);
    const Triangle& t = question.triangle;
    EXPECT_TRUE(hit->point == t.a || hit->point == t.b || hit->point == t.c);
}

TEST(SweepStart, the_point_on_a_triangle_without_area_lies_between_its_ends) {
    const auto ellipsoid = Question{Ellipsoid{{12.5, 25, 12.5}},
                                    dquat(3, 1, 0, 0),
                                    {{512, -511.4375, -1023.4375}, {512, -512.5625, -1024.5625}},
                                    {{499.5, -512, -1024}, {499.5, -511.5, -1023.5}, {499.5, -512.25, -1024.25}}}
                               .answer();
    ASSERT_TRUE(ellipsoid.has_value());
    EXPECT_LE(ellipsoid->point.y, -511.5 + 1e-9);
    EXPECT_GE(ellipsoid->point.y, -512.25 - 1e-9);

    const auto capsule = Question{Capsule{25, 30},
                                  dquat(2, 1, 0, 0),
                                  {{-32, 23.625, -8}, {-32, 24, -8}},
                                  {{-57, 42, 16}, {-57, 90, 16}, {-57, 74, 16}}}
                             .answer();
    ASSERT_TRUE(capsule.has_value());
    EXPECT_GE(capsule->point.y, 42 - 1e-9);
    EXPECT_LE(capsule->point.y, 90 + 1e-9);
}

TEST(SweepStart, the_point_of_a_cone_whose_disc_lies_in_the_triangles_plane_is_on_the_disc) {
    // The cone points down, turned about the vertical only: its disc is level, 25 m up.
    const Question question{Cone{25, 25},
                            dquat(2, 0, 1, 0),
                            {{-49200, 16384, -49200}, {-49140, 16384, -49140}},
                            {{-49166, 16409.000000000004, -49182}, {-49162, 16409, -49162}, {-49134, 16409, -49154}}};
    const auto hit = question.answer();
    ASSERT_TRUE(hit.has_value());
    const dvec3 apex = question.motion.from + (question.motion.to - question.motion.from) * hit->t;
    const dvec3 from_axis(hit->point.x - apex.x, 0, hit->point.z - apex.z);
    EXPECT_LE(glm::length(from_axis), 25 + 5e-6);
    EXPECT_NEAR(hit->point.y, 16409, 5e-6);
}

TEST(SweepStart, the_point_on_an_edge_that_grazes_a_flat_cones_rim_is_on_the_rim) {
    struct Case {
        Question question;
        dvec3 up;
        double allowed;
    };
    const std::array<Case, 2> cases{{
        {{Cone{18.14445021487593, 0.0018146264841360066},
          dquat(0.7, -0.7, 0, 0),
          {{-1856.924150021027, 1240.263079466228, -593.2707926187637},
           {-1910.5435729650492, 1215.0024159130946, -591.0510328491772}},
          {{-599.5638427734375, -1783.8809814453125, -591.8961791992188},
           {-1892.9801025390625, 1233.318115234375, -591.3485107421875},
           {789.8365478515625, -534.816162109375, 1280.6348876953125}}},
         {0, 0, -1},
         1.9e-7},
        {{Cone{136.7730175973506, 0.02671453636127362},
          dquat(1, 0, 0, -1),
          {{158.38206760036599, -350.18712174791307, -151.45861673690735},
           {158.31134919773626, -350.1471169669019, -151.53804092018336}},
          {{158.25767320116228, -166.42605137649986, 260.7598778502049},
           {-376.69215329374003, -643.6717644282119, 18.51305719055773},
           {158.44548492271923, -442.50532408916104, -517.5933490425734}}},
         {1, 0, 0},
         6.4e-8},
    }};
    for (const auto& [question, up, allowed] : cases) {
        const auto hit = question.answer();
        ASSERT_TRUE(hit.has_value());
        EXPECT_EQ(hit->feature, Feature::edge);
        const dvec3 apex = question.motion.from + (question.motion.to - question.motion.from) * hit->t;
        const dvec3 from_apex = hit->point - apex;
        const double upward = inner(from_apex, up);
        const auto& cone = std::get<Cone>(question.shape);
        EXPECT_LE(glm::length(from_apex - up * upward), cone.radius + allowed);
        EXPECT_NEAR(upward, cone.height, allowed);
    }
}

TEST(SweepStart, a_rim_that_grazes_an_edge_just_beside_its_corner_names_the_edge_and_not_the_corner) {
    // On the edge and on the face beside it lie points that are as near but for rounding, 1.5e-8 m from the corner.
    Question question{Cylinder{0.78125, 0.15625},
                      dquat(0, 1, 2, 0),
                      {{-0.76171875, 0.767578125, -1}, {-0.734375, 0.7265625, -1}},
                      {{-0.875, 0.65625, -0.21875}, {1.125, 0.65625, 5.78125}, {5.125, 0.65625, -0.21875}}};
    const auto named_edge = [&] {
        const auto hit = question.answer();
        ASSERT_TRUE(hit.has_value());
        EXPECT_EQ(hit->feature, Feature::edge);
        EXPECT_EQ(hit->point.z, -0.21875);
        EXPECT_GT(hit->point.x, -0.875);
    };
    named_edge();
    question.triangle = {question.triangle.a, question.triangle.c, {1.125, 0.65625, 5.781249999999999}};
    named_edge();
}

TEST(SweepStart, about_a_point_that_is_next_to_nothing_away_has_a_normal_of_unit_length) {
    // Found by fuzzing: no direction between the two was left in doubles, and the normal was zero.
    const Triangle point{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    for (const double away : {3.713684e-318, 5e-324, 1e-305}) {
        const auto hit = sweep(Sphere{3.25}, {{away, 0, 0}, {0, 0, 0}}, point);
        ASSERT_TRUE(hit.has_value()) << away;
        EXPECT_EQ(hit->t, 0);
        EXPECT_NEAR(glm::length(hit->normal), 1, 1e-12) << away;
    }
}

}  // namespace
}  // namespace surefoot
