// The movement course with every shape: a subset of its scenes that takes seconds, and a broken mover that each shape
// catches in it.
#include <algorithm>
#include <gtest/gtest.h>
#include <string>

#include "course/catalogue.hpp"
#include "course/mover.hpp"
#include "course/runner.hpp"

namespace surefoot::course {
namespace {

// What every shape clears, the cone too.
constexpr std::string_view everybody[] = {"floor-seams", "floor-stand", "wall-floor", "corners", "convex-edge",
                                          "slope-stand", "slope-climb", "funnel",     "lift",    "crevice-narrow"};

class CourseShape : public testing::TestWithParam<ShapeName> {
protected:
    static bool clears(const Scene& scene, std::string_view name) {
        const auto mover = make_mover(name);
        return run_scene(scene, *mover).passes();
    }
    static Scene scene(std::string_view name) {
        Scenes all = all_scenes(GetParam().shape);
        return *std::find_if(all.begin(), all.end(), [&](const Scene& one) { return one.name == name; });
    }
};

TEST_P(CourseShape, is_as_wide_as_the_capsule_and_stands_as_high_above_the_ground) {
    for (const Scene& one : all_scenes(GetParam().shape)) {
        if (one.name == "sizes") continue;
        for (const course::Run& run : one.runs) {
            EXPECT_TRUE(is_valid(run.settings)) << one.name << ": " << run.name;
            EXPECT_DOUBLE_EQ(half_width(run.settings), 0.4) << one.name << ": " << run.name;
            EXPECT_DOUBLE_EQ(standing(run.settings), GetParam().shape == BodyShape::sphere ? 0.4 : 0.9);
        }
    }
}

TEST_P(CourseShape, clears_the_quick_scenes) {
    for (const std::string_view name : everybody) {
        EXPECT_TRUE(clears(scene(name), "ours")) << name;
    }
}

TEST_P(CourseShape, catches_the_mover_that_stays_where_it_meets_something) {
    EXPECT_FALSE(clears(scene("convex-edge"), "broken-stop"));
}

TEST_P(CourseShape, stands_wedged_in_a_groove_though_its_touches_are_a_rounding_apart) {
    if (GetParam().shape == BodyShape::cone) GTEST_SKIP() << "its apex follows the bottom of the groove";
    EXPECT_TRUE(clears(scene("groove"), "ours"));
}

TEST_P(CourseShape, that_is_excused_from_a_scene_does_fail_it) {
    for (const Scene& one : all_scenes(GetParam().shape)) {
        if (one.cannot.empty()) continue;
        EXPECT_FALSE(clears(one, "ours")) << one.name << ": " << one.cannot;
    }
}

TEST(CourseShapes, are_refused_by_a_mover_that_has_capsules_only) {
    const auto bullet = make_mover("bullet");
    if (!bullet) GTEST_SKIP() << bullet_missing();
    EXPECT_EQ(run_scene(all_scenes(BodyShape::box).front(), *bullet).failure,
              "0 degrees: it moves no body of this shape");
}

INSTANTIATE_TEST_SUITE_P(Shapes, CourseShape, testing::ValuesIn(shapes().begin(), shapes().end()),
                         [](const auto& chosen) { return std::string(chosen.param.name); });

}  // namespace
}  // namespace surefoot::course
