#include "view/camera.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>
#include <vector>

#include "view/fly_camera.hpp"
#include "view/orbit_camera.hpp"

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

}  // namespace
}  // namespace surefoot::view
