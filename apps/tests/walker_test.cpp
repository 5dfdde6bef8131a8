// The character of the room Walk and its past, without a window.
#include "playground/walk/walker.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "level.hpp"
#include "playground/walk/controls.hpp"
#include "playground/walk/follow_camera.hpp"
#include "playground/walk/settings_panel.hpp"
#include "playground/walk/settings_table.hpp"
#include "playground/walk/stations.hpp"

namespace surefoot::playground {
namespace {

/// A floor, and a wall across it at z = -3.
const Mesh& yard() {
    static const Mesh mesh = [] {
        const std::vector<vec3> vertices{{-9, 0, 9},  {9, 0, 9},  {9, 0, -9}, {-9, 0, -9},
                                         {-9, 0, -3}, {9, 0, -3}, {9, 5, -3}, {-9, 5, -3}};
        const std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
        return *Mesh::build(MeshInput{.vertices = vertices, .indices = indices});
    }();
    return mesh;
}

/// Walks, turns and jumps, as the number of the tick says.
CharacterInput input_of(int tick) {
    CharacterInput input;
    input.wish = dvec3(std::sin(tick * 0.1), 0, -1) * 4.0;
    input.jump = tick % 40 > 30;
    return input;
}

void walk(Walker& walker, int from, int to) {
    for (int i = from; i < to; ++i) walker.make_tick(input_of(i));
}

TEST(Walker, makes_the_steps_that_step_makes_by_hand) {
    Walker walker(yard());
    ASSERT_TRUE(walker.put({0, 0, 2}));
    World world;
    ASSERT_TRUE(world.add(yard()));
    CharacterState state = walker.state();
    for (int i = 0; i < 120; ++i) {
        walker.make_tick(input_of(i));
        state = step(world, walker.settings(), input_of(i), Walker::tick, state).state;
        ASSERT_EQ(walker.state(), state) << i;
    }
    EXPECT_LT(state.position.z, -2) << "it has come to the wall";
}

TEST(Walker, going_back_and_on_with_the_same_inputs_gives_the_same_bits) {
    Walker walker(yard());
    ASSERT_TRUE(walker.put({0, 0, 2}));
    walk(walker, 0, 100);
    const CharacterState end = walker.state();
    walker.look_at(30);
    EXPECT_TRUE(walker.paused);
    const CharacterState past = walker.state();
    EXPECT_NE(past, end);
    walker.go_on_from_here();
    EXPECT_EQ(walker.ticks(), 30U);
    EXPECT_EQ(walker.state(), past);
    walk(walker, 30, 100);
    EXPECT_EQ(walker.state(), end);
    walker.look_at(30);
    walker.go_on_from_here();
    walk(walker, 31, 101);
    EXPECT_NE(walker.state(), end) << "other inputs lead elsewhere";
}

TEST(Walker, what_is_told_is_the_step_that_led_to_what_is_looked_at) {
    Walker walker(yard());
    ASSERT_TRUE(walker.put({0, 0, 2}));
    EXPECT_EQ(walker.told(), nullptr);
    walk(walker, 0, 60);
    for (std::size_t when = 60; when > 0; --when) {
        walker.look_at(when);
        ASSERT_NE(walker.told(), nullptr);
        EXPECT_EQ(walker.told()->result.state, walker.state()) << when;
        EXPECT_FALSE(walker.told()->records.empty());
    }
    walker.look_at(0);
    EXPECT_EQ(walker.told(), nullptr);
    walker.make_tick({});  // in the past it is the step that was made then
    EXPECT_EQ(walker.looks_at(), 1U);
    EXPECT_EQ(walker.told()->input.wish, input_of(0).wish);
}

TEST(Walker, the_past_is_as_long_as_it_says_and_its_stops_are_found) {
    Walker walker(yard());
    ASSERT_TRUE(walker.put({0, 0, -1}));
    EXPECT_EQ(walker.last_stop().step, nullptr);
    CharacterInput north;
    north.wish = {0, 0, -4};
    for (int i = 0; i < 60; ++i) walker.make_tick(north);
    ASSERT_NE(walker.last_stop().step, nullptr);
    EXPECT_EQ(walker.last_stop().ago, 0);
    EXPECT_FALSE(walker.why(*walker.last_stop().step).empty());
    for (int i = 0; i < 30; ++i) walker.make_tick({});
    EXPECT_NEAR(walker.last_stop().ago, 30 * Walker::tick, 1e-9);
    for (std::size_t i = 0; i < Walker::most_ticks; ++i) walker.make_tick({});
    EXPECT_EQ(walker.ticks(), Walker::most_ticks);
    EXPECT_EQ(walker.last_stop().step, nullptr) << "that is forgotten";
}

TEST(Walker, a_moment_of_the_past_replays_to_the_bit) {
    Walker walker(yard());
    ASSERT_TRUE(walker.put({0, 0, 2}));
    EXPECT_FALSE(walker.moment());
    walk(walker, 0, 90);
    walker.look_at(77);
    auto moment = walker.moment();
    ASSERT_TRUE(moment);
    EXPECT_EQ(moment->after, walker.state());
    EXPECT_TRUE(replay(*moment).is_same()) << replay(*moment).differs;
    moment->before.position.x += 1e-6;
    EXPECT_FALSE(replay(*moment).is_same());
}

TEST(Walker, slow_motion_makes_fewer_steps_and_draws_between_them) {
    Walker walker(yard());
    ASSERT_TRUE(walker.put({0, 0, 8}));
    CharacterInput north;
    north.wish = {0, 0, -4};
    const auto pass = [&](int times) {
        for (int i = 0; i < times; ++i) EXPECT_TRUE(walker.pass(Walker::tick, [&] { return north; }));
    };
    pass(60);
    EXPECT_EQ(walker.ticks(), 60U);
    walker.speed = 0.25;
    pass(60);
    EXPECT_EQ(walker.ticks(), 75U);
    const double first = walker.drawn_position(0).z;
    pass(1);
    EXPECT_NEAR(walker.drawn_position(0).z, first - 4 * 0.25 * Walker::tick, 1e-9);
    EXPECT_NEAR(walker.drawn_position(Walker::tick).z, first - 4 * 0.5 * Walker::tick, 1e-9);
    walker.paused = true;
    EXPECT_FALSE(walker.pass(1, [&] { return north; }));
    EXPECT_EQ(walker.drawn_position(0), walker.state().position);
}

TEST(Walker, a_change_of_settings_begins_a_new_past_and_the_feet_stay) {
    for (std::size_t shape = 0; shape < shape_names().size(); ++shape) {
        Walker walker(yard());
        ASSERT_TRUE(walker.put({0, 0, 2}));
        walk(walker, 0, 20);
        const auto feet = [&] { return walker.state().position.y - foot_of(walker.settings().volume.shape); };
        const double before = feet();
        CharacterSettings settings = walker.settings();
        settings.volume.shape = as_large(settings.volume.shape, shape);
        walker.change(settings);
        EXPECT_NEAR(feet(), before, 1e-12) << shape_names()[shape];
        for (int i = 0; i < 10; ++i) walker.make_tick({});
        EXPECT_EQ(walker.ticks(), 10U);
        EXPECT_EQ(walker.told()->result.state, walker.state());
        EXPECT_EQ(walker.session().ticks.size(), 10U);
    }
}

TEST(Walker, changed_settings_show_where_the_same_inputs_would_have_led) {
    Walker walker(yard());
    ASSERT_TRUE(walker.put({0, 0, 2}));
    walk(walker, 0, 80);
    walker.look_at(25);
    EXPECT_TRUE(walker.what_if().empty());
    CharacterSettings settings = walker.settings();
    settings.jump_height = 2;
    walker.change(settings);
    const std::vector<dvec3> led = walker.what_if();
    ASSERT_EQ(led.size(), 80U - 25 + 1);
    EXPECT_EQ(led.front(), walker.state().position);
    walker.look_at(80);
    EXPECT_NE(led.back(), walker.state().position);
    walker.look_at(25);
    walker.go_on_from_here();
    for (int i = 25; i < 80; ++i) {
        walker.make_tick(input_of(i));
        EXPECT_EQ(walker.state().position, led[static_cast<std::size_t>(i) - 24]) << i;
    }
    EXPECT_TRUE(walker.what_if().empty()) << "these are the settings of the past now";
}

TEST(Walker, in_a_house_it_begins_under_the_roof) {
    // A floor and a roof, each a sheet that faces up.
    const std::vector<vec3> vertices{{-5, 0, 5}, {5, 0, 5}, {5, 0, -5}, {-5, 0, -5},
                                     {-5, 4, 5}, {5, 4, 5}, {5, 4, -5}, {-5, 4, -5}};
    const std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3, 4, 5, 6, 4, 6, 7};
    tools::Level level{.mesh = *Mesh::build(MeshInput{.vertices = vertices, .indices = indices}),
                       .file = {},
                       .surface_names = {},
                       .markers = {},
                       .notes = {}};
    const auto stations = stations_of(level);
    ASSERT_EQ(stations.size(), 1U);
    EXPECT_NEAR(stations[0].place.y, 0, 1e-6);
    level.markers.push_back({.name = "door", .kind = "spawn", .extras = {}, .position = {1, 0, 1}});
    EXPECT_EQ(stations_of(level)[0].name, "door");
    EXPECT_NEAR(stations_of(level)[0].look.z, 1, 1e-12) << "the front of a node";
}

TEST(Walker, stands_at_every_station_of_the_training_ground) {
    const tools::Level level = tools::load_level(
        {.file = SUREFOOT_LEVELS_DIR "/training-ground.glb", .scale = {}, .up = {}, .tolerance = {}, .solids = {}});
    Walker walker(level.mesh);
    walker.change(room_settings());
    const auto stations = stations_of(level);
    EXPECT_GT(stations.size(), 20U);
    for (const Station& station : stations) {
        ASSERT_TRUE(walker.put(station.place)) << station.name;
        EXPECT_EQ(walker.state().footing, Footing::ground) << station.name;
        const dvec3 moved = walker.state().position - station.place;
        EXPECT_LT(std::hypot(moved.x, moved.z), 0.05) << station.name;
        EXPECT_LT(moved.y, 1.2) << station.name;
        EXPECT_NEAR(glm::length(station.look), 1, 1e-12);
    }
}

TEST(FollowCamera, no_wall_comes_between_it_and_the_body) {
    World world;
    ASSERT_TRUE(world.add(yard()));
    const dvec3 middle(0, 0.91, -2.4);  // with the wall behind its back
    FollowCamera camera;
    camera.jump_to(middle, yaw_towards({0, 0, 1}));
    EXPECT_NEAR(camera.ahead().z, 1, 1e-12);
    for (int i = 0; i < 120; ++i) {
        static_cast<void>(camera.update(Walker::tick, world, middle));
        const dvec3 eye = camera.camera(world, middle).eye;
        EXPECT_GT(eye.z, -3 + 0.1);
        EXPECT_FALSE(world.ray_any({middle, eye}));
    }
    camera.turn({3.141592653589793, 0});
    for (int i = 0; i < 120; ++i) static_cast<void>(camera.update(Walker::tick, world, middle));
    EXPECT_GT(camera.camera(world, middle).eye.z, 1) << "there is room on the other side";
}

TEST(Controls, a_press_between_two_ticks_counts_in_the_next_one) {
    Controls controls;
    controls.event(view::KeyPress{view::Key::space, true});
    controls.event(view::KeyPress{view::Key::space, false});
    EXPECT_TRUE(controls.take({0, 0, -1}).jump);
    EXPECT_FALSE(controls.take({0, 0, -1}).jump);
}

TEST(Controls, a_wish_is_as_fast_in_every_direction_and_a_loose_stick_wishes_nothing) {
    Controls controls;
    controls.event(view::KeyPress{view::Key::w, true});
    controls.event(view::KeyPress{view::Key::d, true});
    const dvec3 wish = controls.take({0, 0, -1}).wish;
    EXPECT_NEAR(glm::length(wish), controls.walk_speed, 1e-12);
    EXPECT_GT(wish.x, 0);
    EXPECT_LT(wish.z, 0);
    controls.release();
    controls.event(view::GamepadAxis{view::PadAxis::left_x, 0.1});
    EXPECT_EQ(controls.take({0, 0, -1}).wish, dvec3(0));
    controls.event(view::GamepadAxis{view::PadAxis::left_y, -1});
    controls.event(view::GamepadAxis{view::PadAxis::left_x, 0});
    EXPECT_NEAR(controls.take({0, 0, -1}).wish.z, -controls.walk_speed, 1e-12);
}

}  // namespace
}  // namespace surefoot::playground
