// The movement course with every shape: a part of its scenes that takes seconds, with the broken mover that each fails.
// All of them are walked by the campaigns of ./test --all.
#include <algorithm>
#include <gtest/gtest.h>
#include <string>

#include "course/catalogue.hpp"
#include "course/mover.hpp"
#include "course/runner.hpp"

namespace surefoot::course {
namespace {

// The quickest of what was hard for one shape or another.
constexpr std::string_view quick[] = {"floor-stand", "wall-bodies",  "convex-edge", "stairs-spiral",
                                      "groove",      "ceiling-jump", "ledge-low",   "ledge-perch",
                                      "lift",        "pusher",       "rates-open",  "spawn-inside"};

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
    for (const std::string_view name : quick) {
        EXPECT_TRUE(clears(scene(name), "ours")) << name;
    }
}

TEST_P(CourseShape, catches_a_broken_mover_in_each_quick_scene) {
    for (const std::string_view name : quick) {
        const Scene one = scene(name);
        ASSERT_FALSE(one.catches.empty()) << name;
        const auto mover = make_mover(one.catches.front());
        ASSERT_TRUE(mover) << one.catches.front();
        EXPECT_TRUE(fails_scene(one, *mover)) << name << " by " << one.catches.front();
    }
}

TEST_P(CourseShape, knows_a_broken_mover_for_every_scene_that_applies) {
    for (const Scene& one : all_scenes(GetParam().shape)) {
        if (!one.applies()) continue;
        ASSERT_FALSE(one.catches.empty()) << one.name;
        EXPECT_TRUE(make_mover(one.catches.front())) << one.name << ": " << one.catches.front();
    }
}

TEST_P(CourseShape, that_is_excused_from_a_scene_does_not_clear_it) {
    for (const Scene& one : all_scenes(GetParam().shape)) {
        if (one.applies()) continue;
        EXPECT_FALSE(clears(one, "ours")) << one.name << ": " << one.not_for_shape;
    }
}

TEST(CourseShapes, but_the_ball_are_excused_from_nothing) {
    for (const ShapeName& shape : shapes()) {
        const Scenes all = all_scenes(shape.shape);
        const auto apply = std::count_if(all.begin(), all.end(), [](const Scene& one) { return one.applies(); });
        EXPECT_EQ(apply, static_cast<int>(all.size()) - (shape.shape == BodyShape::sphere ? 1 : 0)) << shape.name;
    }
}

TEST(CourseShapes, pass_nothing_where_nothing_was_walked) {
    const Scenes all = all_scenes(BodyShape::sphere);
    EXPECT_FALSE((Score{&all.front(), {}, {}}.passes()));
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
