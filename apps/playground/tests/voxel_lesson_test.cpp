#include "debugger/voxel_lesson.hpp"

#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>

#include "splitmix.hpp"

namespace surefoot::debugger {
namespace {

bool same_bits(const dvec3& a, const dvec3& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

VoxelScene random_scene(tests::SplitMix& random) {
    VoxelScene scene;
    scene.window = {.first = {-1, 0, 2}, .cells = {7, 5, 7}, .size = {1, 0.75, 1.25}, .origin = {0.3, -0.2, 0.1}};
    for (std::int32_t x = -1; x < 6; ++x)
        for (std::int32_t y = 0; y < 5; ++y)
            for (std::int32_t z = 2; z < 9; ++z)
                if (random.next() % 4 == 0) scene.solid.push_back({x, y, z});
    scene.box = {.half_extents = {random.in(0.1, 0.6), random.in(0.1, 0.9), random.in(0.1, 0.6)}};
    scene.from = dvec3(2.5, 1.5, 6.5) + random.point(2);
    scene.displacement = random.point(2.5);
    for (int axis = 0; axis < 3; ++axis)
        if (random.next() % 5 == 0) scene.displacement[axis] = 0;
    scene.order = static_cast<AxisOrder>(random.next() % 6);
    return scene;
}

TEST(VoxelLesson, replays_to_the_library_s_own_bits) {
    tests::SplitMix random(4);
    int stopped = 0;
    int inside = 0;
    for (int i = 0; i < 3000; ++i) {
        const VoxelScene scene = random_scene(random);
        for (const VoxelMethod method : {VoxelMethod::each_from_the_last, VoxelMethod::all_from_the_start}) {
            const VoxelLesson lesson = voxel_lesson(scene, method);
            dvec3 at = scene.from;
            for (const VoxelStep& step : lesson.steps) {
                EXPECT_TRUE(same_bits(step.moved_from, at));
                const bool right = method == VoxelMethod::each_from_the_last;
                EXPECT_TRUE(same_bits(step.tried_from, right ? at : scene.from));
                at[step.axis] = step.tried_to[step.axis];
                EXPECT_TRUE(same_bits(step.moved_to, at));
                const AxisStop stops[] = {lesson.result.x, lesson.result.y, lesson.result.z};
                EXPECT_EQ(step.stopped_by.has_value(), stops[step.axis].blocked);
                if (step.stopped_by) {
                    ++stopped;
                    EXPECT_TRUE(scene.is_solid(step.stopped_by->x, step.stopped_by->y, step.stopped_by->z));
                    EXPECT_NE(std::find(step.looked_at.begin(), step.looked_at.end(), *step.stopped_by),
                              step.looked_at.end())
                        << "it was stopped by a block that it did not look at";
                }
            }
            EXPECT_TRUE(same_bits(at, lesson.result.position));
            if (lesson.ends_inside && !lesson.result.started_inside) {
                ++inside;
                EXPECT_EQ(method, VoxelMethod::all_from_the_start);
            }
        }
    }
    EXPECT_GT(stopped, 1000);
    EXPECT_GT(inside, 50);
}

TEST(VoxelLesson, shows_the_wrong_one_in_the_block_and_the_right_one_beside_it) {
    const VoxelScene scene = corner_scene();
    const VoxelLesson wrong = voxel_lesson(scene, VoxelMethod::all_from_the_start);
    const VoxelLesson right = voxel_lesson(scene, VoxelMethod::each_from_the_last);
    EXPECT_TRUE(wrong.ends_inside);
    EXPECT_FALSE(right.ends_inside);
    ASSERT_EQ(wrong.steps.size(), 2U);
    for (const VoxelStep& step : wrong.steps) EXPECT_FALSE(step.stopped_by);
    EXPECT_FALSE(wrong.steps[0].inside);
    EXPECT_TRUE(wrong.steps[1].inside);
    EXPECT_NE(wrong.steps[1].text.find("It does not."), std::string::npos);
    ASSERT_EQ(right.steps.size(), 2U);
    EXPECT_EQ(right.steps[1].stopped_by, (Cell{3, 1, 3}));
    EXPECT_NEAR(right.result.position.z, 2.75, 1e-12);
    EXPECT_NEAR(right.result.position.x, 3.4, 1e-12);
}

TEST(VoxelLesson, goes_on_through_when_the_wrong_move_is_made_again) {
    VoxelScene scene = corner_scene();
    scene.from = voxel_lesson(scene, VoxelMethod::all_from_the_start).result.position;
    const VoxelLesson next = voxel_lesson(scene, VoxelMethod::all_from_the_start);
    EXPECT_TRUE(next.result.started_inside);
    EXPECT_GT(next.result.position.z, 4) << "it came out at the other side of the wall";
}

}  // namespace
}  // namespace surefoot::debugger
