// What the camera of a game does in places that are made for it.
#include "platformer/camera/game_camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include "hero_ground.hpp"
#include "platformer/camera/sight.hpp"
#include "platformer/hero/frame.hpp"

namespace surefoot::platformer::tests {
namespace {

Blocks plain() {
    return Blocks().add({-60, -1, -60}, {60, 0, 60});
}

/// A hero and the camera behind it; yaw 0 looks along Z.
struct Follow {
    explicit Follow(const World& world_, const dvec3& at = {0, 0.82, 0}, double yaw = 0) : world(world_) {
        state.position = at;
        for (int i = 0; i < 10; ++i) state = step(world, settings, {}, tick, state).state;
        camera = camera_behind(world, target(), look, yaw);
    }

    [[nodiscard]] CameraTarget target() const { return target_of(state, settings, facing); }

    void go(const CharacterInput& input, const CameraInput& hand = {}) {
        state = step(world, settings, input, tick, state).state;
        camera = advance(camera, world, target(), look, hand, hint, tick);
    }
    void go_on(int ticks, const CharacterInput& input, const CameraInput& hand = {}) {
        for (int i = 0; i < ticks; ++i) go(input, hand);
    }

    const World& world;
    CharacterSettings settings = hero_settings();
    CameraSettings look;
    CharacterState state;
    CameraState camera;
    std::optional<CameraHint> hint;
    double facing = 0;
};

/// How much heights shake: the largest of their second differences.
double shaking(const std::vector<double>& heights) {
    double most = 0;
    for (std::size_t i = 2; i < heights.size(); ++i)
        most = std::max(most, std::abs(heights[i] - 2 * heights[i - 1] + heights[i - 2]));
    return most;
}

TEST(GameCamera, is_not_shaken_by_stairs) {
    Blocks blocks = plain();
    for (int i = 0; i < 20; ++i) blocks.add({-2, 0, 4 + 0.4 * i}, {2, 0.2 * (i + 1), 14});
    const Mesh mesh = blocks.mesh();
    const World world = world_of(mesh);
    Follow f(world);
    std::vector<double> raw;
    std::vector<double> seen;
    for (int i = 0; i < 150 && f.state.position.y < 4; ++i) {
        f.go({.wish = {0, 0, 5}});
        raw.push_back(f.state.position.y);
        seen.push_back(f.camera.eye.y);
    }
    ASSERT_GT(f.state.position.y, 3.9);
    EXPECT_GT(shaking(raw), 0.05);
    EXPECT_LT(shaking(seen), 0.2 * shaking(raw));
    EXPECT_GT(seen.back(), seen.front() + 2);
}

TEST(GameCamera, stays_on_its_height_in_a_jump_and_rises_with_what_leads_higher) {
    const Mesh mesh = plain().add({-3, 0, 6}, {3, 1.3, 30}).mesh();
    const World world = world_of(mesh);
    Follow f(world);
    const double before = f.camera.eye.y;
    for (int i = 0; i < 60; ++i) {
        f.go({.jump = i < 30});
        EXPECT_NEAR(f.camera.eye.y, before, 0.12) << i;
    }
    for (int i = 0; i < 160; ++i) f.go({.wish = {0, 0, 6.5}, .jump = i % 60 > 30});
    ASSERT_GT(f.state.position.z, 8);
    f.go_on(60, {});
    EXPECT_NEAR(f.camera.eye.y, before + 1.3, 0.25);
}

TEST(GameCamera, comes_behind_one_who_runs_sideways_but_never_while_it_is_turned_by_hand) {
    const Mesh mesh = plain().mesh();
    const World world = world_of(mesh);
    Follow left_alone(world);
    left_alone.go_on(120, {.wish = {6, 0, 0}});
    EXPECT_GT(left_alone.camera.yaw, 0.8);
    Follow by_hand(world);
    double turned_so_far = 0;
    for (int i = 0; i < 120; ++i) {
        const double turn = i % 2 == 0 ? 0.004 : -0.002;
        turned_so_far += turn;
        by_hand.go({.wish = {6, 0, 0}}, {.turn_left = turn});
        ASSERT_NEAR(by_hand.camera.yaw, turned_so_far, 1e-9);
    }
}

TEST(GameCamera, leaves_one_alone_who_runs_towards_it) {
    const Mesh mesh = plain().mesh();
    const World world = world_of(mesh);
    Follow f(world);
    f.go_on(180, {.wish = {0, 0, -6}});
    EXPECT_NEAR(f.camera.yaw, 0, 0.05);
}

TEST(GameCamera, goes_behind_the_hero_when_it_is_told_to) {
    const Mesh mesh = plain().mesh();
    const World world = world_of(mesh);
    Follow f(world);
    f.facing = 2;
    f.go_on(60, {}, {.behind = true});
    EXPECT_NEAR(f.camera.yaw, 2, 0.05);
}

TEST(GameCamera, looks_ahead_where_one_runs_unless_motion_is_reduced) {
    const Mesh mesh = plain().mesh();
    const World world = world_of(mesh);
    Follow f(world);
    f.go_on(90, {.wish = {0, 0, 6.5}});
    EXPECT_GT(f.camera.look_at.z - f.state.position.z, 0.9);
    Follow calm(world);
    calm.look.reduced_motion = true;
    calm.go_on(90, {.wish = {0, 0, 6.5}});
    EXPECT_NEAR(calm.camera.look_at.z, calm.state.position.z, 1e-9);
}

TEST(GameCamera, widens_its_view_in_a_dash_unless_motion_is_reduced) {
    const Mesh mesh = plain().mesh();
    const World world = world_of(mesh);
    for (const bool reduced : {false, true}) {
        Follow f(world);
        f.look.reduced_motion = reduced;
        double widest = 0;
        for (int i = 0; i < 30; ++i) {
            f.go({.wish = {0, 0, 6}, .dash = i == 5});
            widest = std::max(widest, f.camera.field_of_view);
        }
        EXPECT_EQ(widest > f.look.field_of_view + 0.08, !reduced);
        f.go_on(90, {.wish = {0, 0, 6}});
        EXPECT_NEAR(f.camera.field_of_view, f.look.field_of_view, 0.01);
    }
}

TEST(GameCamera, looks_down_where_one_walks_towards_a_drop_and_not_on_the_flat) {
    const Mesh mesh = Blocks().add({-5, -1, -30}, {5, 0, 6}).add({-50, -30, -50}, {50, -20, 50}).mesh();
    const World world = world_of(mesh);
    Follow f(world, {0, 0.82, -12});
    f.go_on(90, {.wish = {0, 0, 3}});
    EXPECT_LT(f.camera.dip, 0.01);
    while (f.state.position.z < 5.2) f.go({.wish = {0, 0, 3}});
    EXPECT_GT(f.camera.dip, 0.08);
}

TEST(GameCamera, comes_closer_in_a_corridor_and_goes_back_slowly_where_it_ends) {
    const Mesh mesh = plain().add({-3, 0, 0}, {-1.1, 4, 30}).add({1.1, 0, 0}, {3, 4, 30}).mesh();
    const World world = world_of(mesh);
    Follow f(world, {0, 0.82, 12});
    const auto away = [&] { return glm::length(f.camera.eye - f.state.position); };
    f.go_on(60, {});
    const double inside = away();
    EXPECT_LT(inside, 4.8);
    EXPECT_GT(inside, 1.5);
    double last = away();
    while (f.state.position.z < 42) {
        f.go({.wish = {0, 0, 6}});
        EXPECT_LT(away() - last, 0.15);
        last = away();
    }
    f.go_on(120, {});
    EXPECT_GT(away(), inside + 0.3);
}

TEST(GameCamera, stands_as_a_hint_asks_where_there_is_one) {
    const Mesh mesh = plain().mesh();
    const World world = world_of(mesh);
    Follow f(world);
    f.hint = CameraHint{.yaw = 1.2, .pitch = 0.7, .distance = 9};
    f.go_on(360, {.wish = {0, 0, 0.1}});
    EXPECT_NEAR(f.camera.yaw, 1.2, 0.05);
    EXPECT_NEAR(f.camera.pitch, 0.7, 0.05);
    EXPECT_NEAR(glm::length(f.camera.eye - f.camera.look_at), 9, 0.3);
}

TEST(GameCamera, gives_way_to_a_wall_that_moves_and_is_never_in_it) {
    const Mesh ground = plain().mesh();
    const Mesh wall = Blocks().add({-4, 0, -0.3}, {4, 5, 0.3}).mesh();
    World world = world_of(ground);
    const auto handle = world.add(wall, {.pose = {{0, 0, -12}, {1, 0, 0, 0}}});
    ASSERT_TRUE(handle.has_value());
    Follow f(world);
    std::array<Overlap, 8> room;
    int near = 0;
    for (int i = 0; i < 360; ++i) {
        const double z = -12 + 10.5 * std::sin(std::min(i / 120.0, 1.0) * 1.5708);
        world.begin_tick();
        ASSERT_TRUE(world.move(*handle, {{3 * std::sin(i * 0.05), 0, z}, {1, 0, 0, 0}}));
        const dvec3 last = f.camera.eye;
        f.go({});
        ASSERT_EQ(world.overlap(Sphere{eye_radius}, f.camera.eye, room, {.begin = 1, .end = 1}), 0U) << i;
        ASSERT_LT(glm::length(f.camera.eye - last), 0.45) << i;
        near += glm::length(f.camera.eye - f.state.position) < 3 ? 1 : 0;
    }
    EXPECT_GT(near, 60);
}

TEST(GameCamera, is_at_once_behind_a_hero_who_was_put_elsewhere) {
    const Mesh mesh = plain().mesh();
    const World world = world_of(mesh);
    Follow f(world);
    f.state.position = {30, 0.82, 30};
    f.camera = advance(f.camera, world, f.target(), f.look, {}, {}, tick);
    EXPECT_LT(glm::length(f.camera.eye - f.state.position), 7);
    EXPECT_LT(glm::length(f.camera.look_at - f.state.position), 2);
}

TEST(GameCamera, is_a_function_of_what_it_is_told) {
    const Mesh mesh = training_ground();
    const World world = world_of(mesh);
    const auto run = [&] {
        Follow f(world, {0, 2, 12});
        f.go_on(200, {.wish = {4, 0, -4}}, {.turn_left = 0.01});
        return f.camera;
    };
    const CameraState a = run();
    const CameraState b = run();
    EXPECT_EQ(a.eye, b.eye);
    EXPECT_EQ(a.yaw, b.yaw);
    EXPECT_EQ(a.share, b.share);
}

TEST(GameCamera, draws_between_two_ticks_without_leaving_the_way_between_their_eyes) {
    CameraState a;
    CameraState b;
    b.eye = {0.4, 0, 0};
    a.look_at = b.look_at = {0, 0, 5};
    const view::Camera camera = camera_between(a, b, 0.25);
    EXPECT_NEAR(camera.eye.x, 0.1, 1e-12);
    EXPECT_NEAR(glm::length(camera.forward), 1, 1e-9);
    EXPECT_GT(camera.forward.z, 0.9);
}

}  // namespace
}  // namespace surefoot::platformer::tests
