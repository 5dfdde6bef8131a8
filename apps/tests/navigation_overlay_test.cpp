// The navigation overlay: a mesh of the room's ground, a target that is put and dragged, and runners that get there.
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "playground/navigation/link_search.hpp"
#include "playground/navigation/overlay.hpp"
#include "small_app.hpp"

namespace surefoot::playground {
namespace {

/// Floors, given by their corners, y first: a level one each.
struct Floor {
    double y, low_x, high_x, low_z, high_z;
};

NavigationGroundPointer ground_of(const std::vector<Floor>& floors, double step_up = 0.4) {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (const Floor& f : floors) {
        const auto first = static_cast<std::uint32_t>(vertices.size());
        for (const auto& [x, z] : {std::pair{f.low_x, f.low_z}, std::pair{f.low_x, f.high_z},
                                   std::pair{f.high_x, f.high_z}, std::pair{f.high_x, f.low_z}})
            vertices.emplace_back(x, f.y, z);
        for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) indices.push_back(first + i);
    }
    auto ground = std::make_shared<NavigationGround>();
    ground->pieces.push_back({*Mesh::build({.vertices = vertices, .indices = indices})});
    ground->settings.step_up = step_up;
    ground->start = {-8, 0, 0};
    return ground;
}

/// A square of 20 m.
NavigationGroundPointer square() {
    return ground_of({{0, -10, 10, -10, 10}});
}

/// The overlay with its mesh, looked at from above a corner.
struct Shown {
    explicit Shown(const NavigationGroundPointer& on, const dvec3& from = {-8, 0, 0}, const dvec3& to = {8, 0, 0}) {
        overlay.shown = true;
        overlay.begin_at(from, to);
        overlay.set_ground(on);
        overlay.update();
        eye.camera.eye = {0, 12, 14};
        eye.camera.forward = glm::normalize(dvec3(0, -12, -14));
    }

    [[nodiscard]] view::dvec2 at(const dvec3& place) const { return eye.camera.project(place, eye.size)->at; }

    bool press(const view::dvec2& where, bool down, const view::Modifiers& held = {}) {
        return overlay.event(
            view::ButtonPress{.button = view::MouseButton::left, .down = down, .at = where, .held = held}, eye);
    }
    void click(const dvec3& place, const view::Modifiers& held = {}) {
        press(at(place), true, held);
        press(at(place), false, held);
    }
    bool move(const view::dvec2& where) { return overlay.event(view::PointerMove{.at = where}, eye); }

    NavigationOverlay overlay{true};
    NavigationOverlay::Eye eye{{}, {1280, 720}};
};

TEST(NavigationOverlay, has_a_mesh_of_the_ground_and_a_way_to_the_target) {
    const Shown s(square());
    ASSERT_NE(s.overlay.way(), nullptr) << s.overlay.failure();
    ASSERT_NE(s.overlay.way()->path(), nullptr);
    EXPECT_NEAR(s.overlay.way()->path()->length, 16, 0.1);
}

TEST(NavigationOverlay, says_in_words_why_there_is_no_mesh) {
    // A failure that is dropped would leave the panel with a progress bar for ever.
    auto none = std::make_shared<NavigationGround>();
    const Shown s(none);
    EXPECT_EQ(s.overlay.way(), nullptr);
    EXPECT_NE(s.overlay.failure(), "");
    EXPECT_FALSE(s.overlay.is_busy());
}

TEST(NavigationOverlay, is_off_and_builds_nothing_until_it_is_shown) {
    NavigationOverlay overlay(true);
    overlay.set_ground(square());
    overlay.update();
    EXPECT_EQ(overlay.scene(), nullptr);
    EXPECT_FALSE(overlay.takes_clicks());
}

TEST(NavigationOverlay, a_click_puts_the_target_and_with_shift_the_start) {
    Shown s(square());
    s.click({3, 0, 5});
    EXPECT_LT(glm::length(s.overlay.target()->feet() - dvec3(3, 0, 5)), 0.1);
    s.click({-4, 0, -6}, {.shift = true});
    EXPECT_LT(glm::length(s.overlay.start() - dvec3(-4, 0, -6)), 0.1);
    EXPECT_NEAR(s.overlay.way()->path()->length, std::hypot(7, 11), 0.2) << "the way goes along";
}

TEST(NavigationOverlay, a_drag_of_the_camera_is_no_click) {
    Shown s(square());
    const dvec3 before = s.overlay.target()->feet();
    s.press(s.at({3, 0, 5}), true);
    s.press(s.at({-3, 0, 5}), false);
    EXPECT_EQ(s.overlay.target()->feet(), before);
}

TEST(NavigationOverlay, the_target_is_grabbed_where_it_is_and_not_where_the_level_behind_it_is) {
    // A grab that asks the level, and not the ellipsoid, would find the ground far behind its head.
    Shown s(square(), {-8, 0, 0}, {2, 0, 2});
    const dvec3 head = s.overlay.target()->feet() + dvec3(0, 1.7, 0);
    const auto pick = s.overlay.target()->place_under(s.at(head), s.eye);
    ASSERT_TRUE(pick);
    EXPECT_GT(glm::length(*pick - s.overlay.target()->feet()), 1);
    EXPECT_TRUE(s.press(s.at(head), true)) << "the room hears nothing of it";
    EXPECT_TRUE(s.move(s.at(head) + (s.at({-5, 0, 4}) - s.at({2, 0, 2}))));
    EXPECT_LT(glm::length(s.overlay.target()->feet() - dvec3(-5, 0, 4)), 0.1) << "it does not jump to the pointer";
    EXPECT_TRUE(s.press(s.at(head), false));
    EXPECT_FALSE(s.move(s.at({0, 0, 0}))) << "it was let go";
    EXPECT_LT(glm::length(s.overlay.target()->feet() - dvec3(-5, 0, 4)), 0.1);
}

TEST(NavigationOverlay, a_target_behind_a_wall_is_not_grabbed) {
    // A floor high above hides what lies below from an eye over it.
    Shown s(ground_of({{0, -10, 10, -10, 10}, {6, -10, 10, -10, 10}}), {-8, 0, 0}, {2, 0, 2});
    EXPECT_FALSE(s.press(s.at(s.overlay.target()->middle()), true));
}

TEST(NavigationOverlay, runners_get_to_the_target_and_follow_it) {
    Shown s(square());
    const auto arrive = [&] {
        for (int i = 0; i < 60 * 8; ++i) s.overlay.update();
        ASSERT_EQ(s.overlay.runners()->size(), 1U);
        EXPECT_EQ(s.overlay.runners()->follower(0).status(), NavigationFollowStatus::arrived)
            << s.overlay.runners()->words();
        const dvec3 way = s.overlay.runners()->state(0).position - s.overlay.target()->feet();
        EXPECT_LT(std::hypot(way.x, way.z), 0.5);
    };
    arrive();
    s.click({-3, 0, -7});
    arrive();
}

TEST(NavigationOverlay, a_polygon_is_taken_out_by_control_and_put_back) {
    // Two squares with a bridge between them, that is gone over or not.
    Shown s(ground_of({{0, -10, -3, -5, 5}, {0, -3, 3, -1, 1}, {0, 3, 10, -5, 5}}));
    ASSERT_FALSE(s.overlay.way()->path()->partial);
    s.click({0, 0, 0}, {.control = true});
    ASSERT_NE(s.overlay.way()->path(), nullptr);
    EXPECT_TRUE(s.overlay.way()->path()->partial) << "nothing leads over what was taken out";
    s.click({0, 0, 0}, {.control = true});
    EXPECT_FALSE(s.overlay.way()->path()->partial);
}

TEST(NavigationOverlay, other_settings_make_another_mesh_and_leave_start_and_target) {
    const std::vector<Floor> high{{0, -10, 0, -10, 10}, {0.3, 0, 10, -10, 10}};
    Shown s(ground_of(high));
    EXPECT_FALSE(s.overlay.way()->path()->partial) << "a step of 0.3 m is walked up";
    s.overlay.set_ground(ground_of(high, 0.1));
    s.overlay.update();
    ASSERT_NE(s.overlay.way()->path(), nullptr);
    EXPECT_TRUE(s.overlay.way()->path()->partial) << "by who cannot, it is not";
    EXPECT_LT(glm::length(s.overlay.target()->feet() - dvec3(8, 0.3, 0)), 0.4);
}

TEST(NavigationWay, the_search_ends_with_what_the_path_found) {
    Shown s(ground_of({{0, -10, -3, -5, 5}, {0, -3, 3, -1, 1}, {0, 3, 10, -5, 5}}));
    const auto scene = make_scene(s.overlay.scene()->ground);
    ASSERT_TRUE(scene);
    NavigationWay way(**scene);
    way.plan({-8, 0, 3}, {8, 0, -3});
    const std::size_t rounds = way.rounds();
    ASSERT_GT(rounds, 1U);
    std::size_t closed_before = 0;
    for (std::size_t round = 0; round <= rounds; ++round) {
        std::size_t closed = 0;
        for (const NavigationSearchNode& node : way.nodes_after(round)) closed += node.open ? 0 : 1;
        EXPECT_GE(closed, closed_before) << round;
        EXPECT_LE(closed, closed_before + 1) << round << ": one a round";
        closed_before = closed;
    }
    const NavigationPolygon last = way.path()->polygons.back();
    const auto& nodes = way.nodes_after(rounds);
    EXPECT_TRUE(std::any_of(nodes.begin(), nodes.end(),
                            [&](const NavigationSearchNode& node) { return node.polygon == last; }));
}

TEST(LinkArc, goes_where_the_feet_went) {
    // Off a floor 2 m high.
    const auto scene = make_scene(ground_of({{0, 0, 12, -5, 5}, {2, -12, 0, -5, 5}}));
    ASSERT_TRUE(scene);
    LinkSearch search;
    search.begin(**scene, true);
    auto found = search.take();
    ASSERT_TRUE(found);
    ASSERT_FALSE(found->links.empty()) << "a drop of 2 m is done";
    ASSERT_TRUE(put_links(**scene, std::move(*found)));
    const auto links = (*scene)->mesh.links();
    ASSERT_EQ((*scene)->arcs.size(), links.size());
    for (std::size_t i = 0; i < links.size(); ++i) {
        const LinkArc& arc = (*scene)->arcs[i];
        EXPECT_LT(glm::length(arc.places.front() - links[i].from), 0.4) << i;
        EXPECT_LT(glm::length(arc.places.back() - links[i].to), 0.6) << i;
    }
    NavigationWay way(**scene);
    way.plan({-8, 2, 0}, {8, 0, 0});
    ASSERT_NE(way.path(), nullptr);
    EXPECT_FALSE(way.path()->partial) << "the way goes over a link";
}

TEST(LinkSearch, ends_at_once_when_its_scene_is_left) {
    const auto scene = make_scene(ground_of({{0, 0, 60, -60, 60}, {2, -60, 0, -60, 60}}));
    ASSERT_TRUE(scene);
    const auto before = std::chrono::steady_clock::now();
    {
        LinkSearch search;
        search.begin(**scene, false);
    }
    EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(5));
}

TEST(DrapedPolygon, ends_at_a_cliff) {
    // Pieces that are measured along the cliff never get short: that hung.
    const auto scene = make_scene(ground_of({{0, -10, 10, -10, 10}}));
    ASSERT_TRUE(scene);
    World cliff;
    const auto cut = ground_of({{-1.2, -10, 0, -10, 10}, {0, 0, 10, -10, 10}});
    ASSERT_TRUE(cliff.add(cut->pieces.front().mesh));
    for (const NavigationOutline& outline : (*scene)->outlines) {
        const DrapedPolygon draped = drape(cliff, (*scene)->mesh, outline);
        EXPECT_GE(draped.triangles.size(), outline.corners - 2);
        EXPECT_LT(draped.triangles.size(), 100'000U);
    }
}

TEST(NavigationOverlay, is_in_the_rooms_that_have_ground) {
    const std::string level = SUREFOOT_LEVELS_DIR "/training-ground.glb";
    for (const char* const room : {"walk", "course", "debugger"}) {
        const auto app = open(room, std::string(room) == "course" ? std::string() : level);
        const auto play = [&](const std::string& script) {
            app->play(*view::parse_script(script, "test"));
            for (int i = 0; i < 400 && app->frame(); ++i) {
            }
            EXPECT_EQ(app->failure(), "") << room;
        };
        play("wait 5\nquit");
        EXPECT_EQ(app->stage().navigation.scene(), nullptr) << room << ": it is off";
        const auto without = app->picture().colours(1U << 20);
        play("key F2\nwait 5\nquit");
        ASSERT_NE(app->stage().navigation.scene(), nullptr) << room << app->stage().navigation.failure();
        EXPECT_NE(app->picture().colours(1U << 20), without) << room;
        play("key F2\nwait 3\nquit");
        EXPECT_FALSE(app->stage().navigation.shown);
        play("key Escape\nwait 3\nquit");
        EXPECT_EQ(app->stage().navigation.scene(), nullptr) << room << ": the start has no ground";
    }
}

TEST(NavigationOverlay, is_asked_for_by_the_command_line) {
    const std::string out = testing::TempDir() + "navigation.png";
    const std::string command =
        SUREFOOT_PLAYGROUND " --room course --headless --frames 5 --size 640x400 --screenshot '" + out + "' ";
    EXPECT_EQ(std::system((command + "--navigation --from=0,0,0 --to=3,0,1.5").c_str()), 0);
    const int status = std::system((command + "--from 0,0 2> /dev/null").c_str());
    EXPECT_EQ(WEXITSTATUS(status), 2);
}

}  // namespace
}  // namespace surefoot::playground
