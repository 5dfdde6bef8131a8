// The Debugger by hand: everything is done by events, and seen by what the room copies to the clipboard.
#include <algorithm>
#include <glm/geometric.hpp>

#include "debugger_house.hpp"
#include "playground/debugger_room/contest_view.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

using debugger::WorldKind;
using view::dvec2;

const std::string ground = SUREFOOT_LEVELS_DIR "/training-ground.glb";

double moved_out_of_plane(const dvec3& by, const dvec3& normal) {
    return std::abs(glm::dot(by, normal));
}

TEST(DebuggerRoom, opens_with_the_triangle_and_its_question) {
    const DebuggerHouse house;
    EXPECT_TRUE(house.question() == debugger::default_question(WorldKind::triangle));
    house.expect_a_picture();
}

TEST(DebuggerRoom, every_world_is_chosen_and_is_a_picture) {
    const DebuggerHouse house;
    const std::pair<const char*, WorldKind> worlds[] = {
        {"Fold", WorldKind::fold}, {"Acute wedge", WorldKind::wedge}, {"One triangle", WorldKind::triangle}};
    for (const auto& [name, world] : worlds) {
        house.play(fmt::format("click \"World\"\nwait 2\nclick \"{}\"\nwait 60", name));
        EXPECT_EQ(house.question().world, world);
        EXPECT_EQ(house.question().triangles.size(), debugger::triangles_of(world).size());
        house.expect_a_picture();
    }
}

TEST(DebuggerRoom, a_level_is_opened_from_the_command_line_and_by_dropping_and_both_searches_agree) {
    const DebuggerHouse house(ground);
    EXPECT_GT(house.app->stage().renderer.counts().triangles, 100U);
    EXPECT_TRUE(house.question().motion.from != debugger::default_question(WorldKind::triangle).motion.from);
    house.play("click \"Brute force\"\nwait 3");
    house.expect_a_picture();
    house.play("drop " SUREFOOT_LEVELS_DIR "/../examples/yard.obj\nwait 60");
    EXPECT_TRUE(house.app->stage().settings.recent.front().ends_with("examples/yard.obj"));
    house.expect_a_picture();
    house.play("key Control+Z\nwait 3");
    EXPECT_GT(house.app->stage().renderer.counts().triangles, 100U) << "the level before comes back with its question";
}

TEST(DebuggerRoom, a_level_that_comes_after_the_room_was_left_is_nobodys) {
    const DebuggerHouse house;
    house.app->push(view::FileDrop{{ground}});
    house.app->go_to("");
    for (int i = 0; i < 5; ++i) house.app->frame();
    // The other order: the drop is seen, and the room goes before the level is there.
    house.app->go_to("debugger");
    house.app->frame();
    static_cast<void>(house.app->current().event(view::FileDrop{{ground}}));
    house.app->go_to("");
    for (int i = 0; i < 5; ++i) house.app->frame();
    EXPECT_EQ(house.app->room(), "");
    EXPECT_EQ(house.app->failure(), "");
}

TEST(DebuggerRoom, start_follows_the_pointer_in_the_plane_that_faces_the_eye) {
    const DebuggerHouse house;
    const auto before = house.question();
    const view::Camera camera = house.camera();
    const dvec2 at = house.on_picture(before.motion.from);
    house.drag(at, {40, -25});
    const auto after = house.question();
    const dvec3 by = after.motion.from - before.motion.from;
    EXPECT_GT(glm::length(by), 0.3);
    EXPECT_LT(moved_out_of_plane(by, camera.forward), 1e-9);
    EXPECT_EQ(after.motion.to, before.motion.to);
    const auto now = camera.project(after.motion.from, house.app->stage().display.size());
    // The point that was grabbed follows the pointer; the middle, a radius deeper, nearly.
    EXPECT_LT(glm::length(now->at - (at + dvec2(40, -25))), 4);
}

TEST(DebuggerRoom, end_is_dragged_and_snaps_to_the_grid_with_shift) {
    const DebuggerHouse house;
    const auto before = house.question();
    const dvec2 at = house.on_picture(before.motion.to - dvec3(0, 0.8, 0));
    house.play(fmt::format("hold Shift\ndrag {} {} {} {} 8\nunhold Shift", at.x, at.y, at.x - 50, at.y + 30));
    const dvec3 end = house.question().motion.to;
    EXPECT_NE(end, before.motion.to);
    EXPECT_EQ(end, debugger::snapped(end, 0.5));
    EXPECT_EQ(house.question().motion.from, before.motion.from);
}

TEST(DebuggerRoom, a_corner_is_dragged_and_what_shares_it_comes_along) {
    const DebuggerHouse house;
    house.play("click \"World\"\nclick \"Fold\"\nwait 90");
    const auto before = house.question();
    house.drag(house.on_picture({-4, 3, 5}), {-30, -30});
    const auto after = house.question();
    EXPECT_NE(after.triangles[0].b, before.triangles[0].b);
    EXPECT_EQ(after.triangles[0].b, after.triangles[1].c);
    EXPECT_EQ(after.triangles[0].a, before.triangles[0].a);
}

TEST(DebuggerRoom, a_handle_moves_in_the_plane_of_its_face) {
    const DebuggerHouse house;
    const auto before = house.question();
    house.click(before.motion.from);
    // The upper face of the box, which is 6 % of the shape's height above it.
    house.drag(house.on_picture(before.motion.from + dvec3(0, 1.4 * 1.12, 0)), {45, 12});
    const dvec3 by = house.question().motion.from - before.motion.from;
    EXPECT_EQ(by.y, 0);
    EXPECT_GT(std::abs(by.x) + std::abs(by.z), 0.2);
}

TEST(DebuggerRoom, an_arrow_moves_along_its_axis) {
    const DebuggerHouse house;
    const auto before = house.question();
    house.click(before.motion.from);
    const dvec2 middle = house.on_picture(before.motion.from);
    const dvec2 along = house.on_picture(before.motion.from + dvec3(1, 0, 0)) - middle;
    const double unit = glm::length(along);
    // Outside of the shape, where the arrow of x is.
    const dvec2 at = house.on_picture(before.motion.from + dvec3(0.8 + 30 / unit, 0, 0));
    house.drag(at, along * (40 / unit) + dvec2(0, 9));
    const dvec3 by = house.question().motion.from - before.motion.from;
    EXPECT_GT(by.x, 0.2);
    EXPECT_EQ(by.y, 0);
    EXPECT_EQ(by.z, 0);
}

TEST(DebuggerRoom, a_drag_elsewhere_turns_the_camera_and_asks_nothing_else) {
    const DebuggerHouse house;
    const auto before = house.question();
    const dvec3 eye = house.camera().eye;
    house.drag({880, 300}, {60, 30});
    EXPECT_GT(glm::length(house.camera().eye - eye), 0.5);
    EXPECT_TRUE(house.question() == before);
}

TEST(DebuggerRoom, the_camera_looks_at_the_middle_of_the_motion_after_a_drop_beside_the_panels) {
    const DebuggerHouse house;
    house.drag(house.on_picture(house.question().motion.from), {60, 20});
    const Motion motion = house.question().motion;
    const dvec2 middle = house.on_picture((motion.from + motion.to) * 0.5);
    const view::Area part = view::ui::uncovered(house.app->stage().display.size());
    EXPECT_LT(glm::length(middle - part.middle()), 4);
}

/// Is all of this seen in what the panels leave free?
void expect_beside_the_panels(const DebuggerHouse& house, const std::vector<dvec3>& places, const std::string& what) {
    const view::Area part = view::ui::uncovered(house.app->stage().display.size());
    for (const dvec3& place : places) {
        const dvec2 at = house.on_picture(place);
        EXPECT_GT(at.x, part.low.x) << what;
        EXPECT_LT(at.x, part.high.x) << what;
        EXPECT_GT(at.y, part.low.y) << what;
        EXPECT_LT(at.y, part.high.y) << what;
    }
}

TEST(DebuggerRoom, all_of_a_question_is_seen_beside_the_panels_in_large_windows_and_small_ones) {
    for (const view::ivec2 size : {view::ivec2(1280, 720), view::ivec2(800, 600)}) {
        const DebuggerHouse house({}, size);
        const debugger::Question question = house.question();
        std::vector<dvec3> places{question.motion.from, question.motion.to};
        for (const Triangle& t : question.triangles) places.insert(places.end(), {t.a, t.b, t.c});
        expect_beside_the_panels(house, places, "no panel");
        for (const std::string panel : {"Mathematics", "Strategies", "A step", "Search"}) {
            house.play("click \"" + panel + "\"\nwait 90");
            expect_beside_the_panels(house, places, panel);
            const view::dvec2 free = view::ui::uncovered(size).size();
            EXPECT_GT(std::min(free.x, free.y), 300) << panel << " leaves too little";
        }
        // Back where it was, when the panel is closed again.
        house.play("click \"Search\"\nwait 90");
        expect_beside_the_panels(house, places, "closed again");
    }
}

TEST(DebuggerRoom, every_course_of_a_lesson_is_seen_beside_its_panel_in_a_small_window_too) {
    for (const view::ivec2 size : {view::ivec2(1280, 720), view::ivec2(800, 600)}) {
        const DebuggerHouse house({}, size);
        house.play("click \"Side by side\"");
        for (const auto& [label, course] : {std::pair("Stairs", Course::stairs), std::pair("Ledge", Course::ledge),
                                            std::pair("Slope", Course::slope)}) {
            house.play(std::string("click \"") + label + "\"\nwait 90");
            Contest contest;
            contest.choose(course);
            expect_beside_the_panels(house, ContestView::places(contest), label);
        }
    }
}

TEST(DebuggerRoom, without_its_squashed_world_the_real_one_is_seen_from_nearer) {
    const DebuggerHouse house({}, {1280, 720});
    const debugger::Question question = house.question();
    const auto length = [&] {
        return glm::length(house.on_picture(question.motion.from) - house.on_picture(question.motion.to));
    };
    house.play("click \"Mathematics\"\nwait 90");
    const double both = length();
    house.play("click \"Squashed world\"\nwait 90");
    EXPECT_GT(length(), both * 1.3);
    expect_beside_the_panels(house, {question.motion.from, question.motion.to}, "alone");
}

TEST(DebuggerRoom, what_a_hand_has_turned_stays_turned_when_a_panel_opens) {
    const DebuggerHouse house;
    house.drag({880, 300}, {60, 30});
    const view::Camera before = house.camera();
    house.play("click \"Strategies\"\nwait 90");
    EXPECT_LT(glm::length(house.camera().eye - before.eye), 1e-6);
    EXPECT_NE(house.camera().lens_shift, before.lens_shift) << "the panel would lie over it";
}

TEST(DebuggerRoom, a_drag_is_one_step_that_is_undone_and_redone) {
    const DebuggerHouse house;
    const auto before = house.question();
    house.drag(house.on_picture(before.motion.from), {40, -25});
    const auto after = house.question();
    house.play("key Control+Z\nwait 2");
    EXPECT_TRUE(house.question() == before);
    house.play("key Control+Shift+Z\nwait 2");
    EXPECT_TRUE(house.question() == after);
    house.play("click \"Undo\"\nwait 2");
    EXPECT_TRUE(house.question() == before);
    house.play("click \"Redo\"\nwait 2");
    EXPECT_TRUE(house.question() == after);
}

TEST(DebuggerRoom, numbers_are_typed_after_a_double_click) {
    const DebuggerHouse house;
    house.play("click \"START x\"\nclick \"START x\"\nwait 2\ntext 6.25\nkey Enter\nwait 3");
    EXPECT_EQ(house.question().motion.from.x, 6.25);
    house.play("click \"Radii y\"\nclick \"Radii y\"\nwait 2\ntext 2\nkey Enter\nwait 3");
    EXPECT_EQ(house.question().sizes.ellipsoid.radii.y, 2);
    house.play("click \"Turn z\"\nclick \"Turn z\"\nwait 2\ntext 90\nkey Enter\nwait 3");
    EXPECT_NEAR(house.question().orientation.z, std::sqrt(0.5), 1e-12);
}

TEST(DebuggerRoom, all_shapes_and_sides_are_chosen) {
    const DebuggerHouse house;
    const char* names[] = {"Sphere", "Capsule", "Box", "Cylinder", "Cone", "Ellipsoid"};
    for (const char* const name : names) {
        house.play(fmt::format("click \"Shape\"\nwait 2\nclick \"{}\"\nwait 3", name));
        house.expect_a_picture();
    }
    house.play("click \"One-sided\"");
    EXPECT_TRUE(house.question().one_sided);
}

TEST(DebuggerRoom, a_question_that_is_pasted_is_asked_and_nonsense_is_refused_in_words) {
    const DebuggerHouse house;
    house.app->stage().display.set_clipboard(
        R"({"shape":{"sphere":[0.5]},"from":[2,3,8],"to":[2,-3,8],"triangles":[[[0,0,0],[0,0,10],[5,0,10]]]})");
    house.play("key Control+V\nwait 60");
    const auto pasted = house.question();
    EXPECT_EQ(pasted.shape, debugger::ShapeName::sphere);
    EXPECT_EQ(pasted.motion.from, dvec3(2, 3, 8));
    EXPECT_EQ(pasted.triangles[0].c, dvec3(5, 0, 10));
    house.app->stage().display.set_clipboard("nonsense");
    house.play("click \"Paste\"\nwait 2");
    EXPECT_NE(house.last_toast(), "");
    EXPECT_TRUE(house.question() == pasted);
}

TEST(DebuggerRoom, a_shape_that_is_none_is_blocked_in_words_and_nothing_breaks) {
    const DebuggerHouse house;
    house.play("click \"Radii x\"\nclick \"Radii x\"\nwait 2\ntext 0\nkey Enter\nwait 60\nkey F\nwait 60");
    house.expect_a_picture();
    house.play("key Control+Z\nwait 3");
    EXPECT_TRUE(house.question() == debugger::default_question(WorldKind::triangle));
}

TEST(DebuggerRoom, the_moment_runs_and_help_tells_the_keys) {
    const DebuggerHouse house;
    const view::Picture before = house.app->picture();
    house.play("key Space\nwait 40");
    const view::Picture running = house.app->picture();
    const auto same = [](const view::Picture& a, const view::Picture& b) {
        return std::equal(a.pixels.begin(), a.pixels.end(), b.pixels.begin(),
                          [](auto x, auto y) { return x.r == y.r && x.g == y.g && x.b == y.b; });
    };
    EXPECT_FALSE(same(before, running));
    EXPECT_FALSE(house.app->current().help().empty());
    house.play("key F1\nwait 2");
    house.expect_a_picture();
}

}  // namespace
}  // namespace surefoot::playground
