#include "view/camera.hpp"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <gtest/gtest.h>
#include <vector>

#include "view/fly_camera.hpp"
#include "view/orbit_camera.hpp"
#include "view/text.hpp"

namespace surefoot::view {
namespace {

constexpr ivec2 size(1280, 720);

Camera tilted() {
    Camera camera;
    camera.eye = {1e6 + 3, 7, -2e6};
    camera.forward = glm::normalize(dvec3(0.3, -0.4, 0.8));
    return camera;
}

TEST(Camera, a_ray_through_a_place_of_the_picture_projects_back_to_it) {
    const Camera camera = tilted();
    for (const dvec2 at : {dvec2(0, 0), dvec2(640, 360), dvec2(1279, 5), dvec2(300.25, 700.5)}) {
        const auto back = camera.project(camera.eye + camera.direction(at, size) * 25.0, size);
        ASSERT_TRUE(back);
        EXPECT_NEAR(back->at.x, at.x, 1e-4);
        EXPECT_NEAR(back->at.y, at.y, 1e-4);
    }
}

TEST(Camera, what_is_behind_the_eye_is_not_on_the_picture) {
    const Camera camera = tilted();
    EXPECT_FALSE(camera.project(camera.eye - camera.forward, size));
    EXPECT_FALSE(camera.project(camera.eye, size));
}

TEST(Camera, one_unit_at_a_depth_is_one_unit_on_the_picture) {
    const Camera camera = tilted();
    const dvec3 middle = camera.eye + camera.forward * 12.0;
    const auto moved = camera.project(middle + camera.right() * camera.unit_at(12, size), size);
    EXPECT_NEAR(moved->at.x, 641, 1e-5);
}

TEST(Camera, picking_meets_the_triangle_under_the_pointer) {
    const std::vector<vec3> vertices{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    const std::vector<std::uint32_t> indices{0, 1, 2};
    const Mesh mesh = *Mesh::build({.vertices = vertices, .indices = indices});
    Camera camera;
    camera.eye = {0, 0, 5};
    const auto hit = pick(mesh, camera, {640, 360}, size);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(glm::length(hit->point), 0, 1e-9);
    EXPECT_FALSE(pick(mesh, camera, {5, 5}, size));
}

void settle(OrbitCamera& camera) {
    for (int i = 0; i < 600 && camera.update(1.0 / 60); ++i) {
    }
}

TEST(OrbitCamera, framing_brings_all_corners_into_the_picture) {
    OrbitCamera orbit;
    const Bounds bounds{{-30, -2, 5}, {50, 9, 25}};
    orbit.frame(bounds);
    settle(orbit);
    for (int i = 0; i < 8; ++i) {
        const dvec3 corner((i & 1) != 0 ? bounds.max.x : bounds.min.x, (i & 2) != 0 ? bounds.max.y : bounds.min.y,
                           (i & 4) != 0 ? bounds.max.z : bounds.min.z);
        const auto at = orbit.camera().project(corner, size);
        ASSERT_TRUE(at);
        EXPECT_GE(at->at.y, 0);
        EXPECT_LE(at->at.y, size.y);
    }
}

TEST(Camera, with_a_shifted_lens_a_ray_projects_back_and_straight_ahead_is_off_the_middle) {
    Camera camera = tilted();
    camera.lens_shift = {0.4, -0.25};
    for (const dvec2 at : {dvec2(0, 0), dvec2(640, 360), dvec2(1279, 5)}) {
        const auto back = camera.project(camera.eye + camera.direction(at, size) * 25.0, size);
        ASSERT_TRUE(back);
        EXPECT_NEAR(back->at.x, at.x, 1e-4);
        EXPECT_NEAR(back->at.y, at.y, 1e-4);
    }
    const auto ahead = camera.project(camera.eye + camera.forward * 9.0, size);
    ASSERT_TRUE(ahead);
    EXPECT_NEAR(ahead->at.x, 640 * 1.4, 1e-4);
    EXPECT_NEAR(ahead->at.y, 360 * 1.25, 1e-4);
    // What is drawn goes by the matrix, and what is picked by the ray.
    const dvec3 place = camera.eye + camera.direction({200, 600}, size) * 25.0;
    const auto clip = camera.projection(1280.0 / 720) * camera.turn() * glm::dvec4(place - camera.eye, 1);
    EXPECT_NEAR((clip.x / clip.w + 1) / 2 * 1280, 200, 1e-4);
    EXPECT_NEAR((1 - clip.y / clip.w) / 2 * 720, 600, 1e-4);
}

TEST(OrbitCamera, places_are_framed_in_a_part_of_the_picture_and_fill_it) {
    const std::vector<dvec3> places{{-3, 0, 1}, {4, 9, -2}, {1, -6, 12}, {0, 2, 0}, {7, 1, 7}};
    for (const Area& part : {Area{{340, 14}, {820, 630}}, Area{{20, 500}, {1200, 700}}, Area{{0, 0}, {1280, 720}}}) {
        for (const double yaw : {0.62, 2.2, -2.0}) {
            OrbitCamera orbit;
            orbit.go_to({.pivot = {500, 0, 0}, .yaw = yaw, .pitch = 0.34, .distance = 3});
            orbit.frame(places, part, size);
            settle(orbit);
            dvec2 low(1e9);
            dvec2 high(-1e9);
            for (const dvec3& place : places) {
                const auto at = orbit.camera().project(place, size);
                ASSERT_TRUE(at);
                low = glm::min(low, at->at);
                high = glm::max(high, at->at);
            }
            EXPECT_GE(low.x, part.low.x - 0.5);
            EXPECT_GE(low.y, part.low.y - 0.5);
            EXPECT_LE(high.x, part.high.x + 0.5);
            EXPECT_LE(high.y, part.high.y + 0.5);
            const dvec2 filled = (high - low) / part.size();
            EXPECT_NEAR(std::max(filled.x, filled.y), 1, 0.01) << "it could be seen from nearer";
            EXPECT_EQ(orbit.stand().yaw, yaw);
            const auto pivot = orbit.camera().project(orbit.stand().pivot, size);
            ASSERT_TRUE(pivot);
            EXPECT_NEAR(glm::length(pivot->at - part.middle()), 0, 0.5) << "a drag would not turn about the middle";
        }
    }
}

TEST(OrbitCamera, the_wheel_keeps_what_is_under_the_pointer_under_it) {
    OrbitCamera orbit;
    orbit.jump_to({.pivot = {0, 0, 0}, .distance = 20});
    const dvec2 at(900, 200);
    const Camera before = orbit.camera();
    const dvec3 place = before.eye + before.direction(at, size) * 17.0;
    EXPECT_TRUE(orbit.event(WheelTurn{{0, 5}, at, {}}, size, place));
    settle(orbit);
    EXPECT_LT(orbit.stand().distance, 15);
    const auto after = orbit.camera().project(place, size);
    ASSERT_TRUE(after);
    EXPECT_NEAR(after->at.x, at.x, 0.5);
    EXPECT_NEAR(after->at.y, at.y, 0.5);
}

TEST(OrbitCamera, a_left_drag_turns_and_a_right_drag_moves_the_pivot) {
    OrbitCamera orbit;
    const auto stand = orbit.stand();
    orbit.event(ButtonPress{MouseButton::left, true, {10, 10}, {}}, size);
    orbit.event(PointerMove{{60, 10}, {50, 0}, {}}, size);
    orbit.event(ButtonPress{MouseButton::left, false, {60, 10}, {}}, size);
    EXPECT_NE(orbit.goal().yaw, stand.yaw);
    EXPECT_EQ(orbit.goal().pivot, stand.pivot);
    orbit.event(ButtonPress{MouseButton::right, true, {10, 10}, {}}, size);
    orbit.event(PointerMove{{60, 10}, {50, 0}, {}}, size);
    EXPECT_GT(glm::length(orbit.goal().pivot - stand.pivot), 0.1);
}

TEST(OrbitCamera, takes_over_where_another_camera_looks_for_any_up) {
    for (const dvec3 up : {dvec3(0, 1, 0), dvec3(0, 0, 1), glm::normalize(dvec3(1, 2, -3))}) {
        FlyCamera fly(up);
        fly.place({4, 5, 6}, {0.3, -0.2, 0.7});
        OrbitCamera orbit(up);
        orbit.take(fly.camera(), 8);
        EXPECT_NEAR(glm::length(orbit.camera().forward - fly.camera().forward), 0, 1e-9);
        EXPECT_NEAR(glm::length(orbit.camera().eye - dvec3(4, 5, 6)), 0, 1e-9);
    }
}

TEST(FlyCamera, flies_ahead_while_w_is_held_and_comes_to_rest) {
    FlyCamera fly;
    fly.place({0, 0, 0}, {0, 0, -1});
    fly.event(KeyPress{Key::w, true, false, {}});
    for (int i = 0; i < 60; ++i) fly.update(1.0 / 60);
    EXPECT_LT(fly.camera().eye.z, -4);
    EXPECT_NEAR(fly.camera().eye.x, 0, 1e-9);
    fly.event(KeyPress{Key::w, false, false, {}});
    int frames = 0;
    while (fly.update(1.0 / 60) && frames < 600) ++frames;
    EXPECT_LT(frames, 200);
}

TEST(FlyCamera, losing_the_focus_lets_all_keys_go) {
    FlyCamera fly;
    fly.event(KeyPress{Key::w, true, false, {}});
    fly.event(FocusChange{false});
    EXPECT_FALSE(fly.update(1.0 / 60));
}

TEST(Labels, that_yield_step_aside_by_little_and_the_others_stay) {
    const auto box = [](double x, double y, bool yields) { return LabelBox{{{x, y}, {x + 60, y + 20}}, yields}; };
    LabelBox boxes[] = {box(100, 105, true), box(100, 110, true), box(100, 100, false), box(300, 100, true),
                        box(130, 100, false)};
    const LabelBox before[] = {boxes[0], boxes[1], boxes[2], boxes[3], boxes[4]};
    step_aside(boxes);
    for (std::size_t i = 0; i < std::size(boxes); ++i) {
        EXPECT_EQ(boxes[i].area.size(), before[i].area.size());
        EXPECT_EQ(boxes[i].area.low.x, before[i].area.low.x) << "only up or down";
        EXPECT_LE(std::abs(boxes[i].area.low.y - before[i].area.low.y), 50);
        if (i > 1) {
            EXPECT_EQ(boxes[i].area.low, before[i].area.low) << i;
        }
    }
    EXPECT_GE(boxes[0].area.low.y, 120) << "it lay on one that does not yield";
    EXPECT_LE(boxes[0].area.low.y, 126);
    EXPECT_LE(boxes[1].area.high.y, 100) << "the nearer side is taken";
}

}  // namespace
}  // namespace surefoot::view
