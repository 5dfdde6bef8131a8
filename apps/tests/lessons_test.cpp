// The panels with scenes of their own: what their clocks and steps do, and that each is a picture.
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <gtest/gtest.h>

#include "playground/debugger_room/contest.hpp"
#include "playground/debugger_room/lesson_view.hpp"
#include "playground/debugger_room/panels_lessons.hpp"
#include "playground/debugger_room/voxel_play.hpp"
#include "playground/navigation/overlay.hpp"
#include "view/gl.hpp"
#include "view/imgui_adapter.hpp"
#include "view/orbit_camera.hpp"
#include "view/picture.hpp"
#include "view/script.hpp"
#include "view/text.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

constexpr double degree = 3.14159265358979323846 / 180;

bool same_bits(const dvec3& a, const dvec3& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}

// The contest -------------------------------------------------------------------------------------------------------

TEST(Contest, stepped_back_is_where_it_was_stepped_to) {
    for (const Course course : {Course::stairs, Course::ledge}) {
        Contest contest;
        contest.choose(course);
        std::vector<dvec3> seen;
        for (int tick = 0; tick < 150; ++tick, contest.step())
            for (std::size_t i = 0; i < Contest::count; ++i) seen.push_back(contest.position(i));
        for (int tick = 149; tick >= 0; --tick) {
            contest.step(-1);
            ASSERT_EQ(contest.tick(), tick);
            for (std::size_t i = 0; i < Contest::count; ++i)
                ASSERT_TRUE(same_bits(contest.position(i), seen[static_cast<std::size_t>(tick) * Contest::count + i]));
        }
        contest.step(-1);
        EXPECT_EQ(contest.tick(), 0) << "there is nothing before the start";
    }
}

TEST(Contest, plays_to_the_end_stops_there_and_begins_again_when_played_again) {
    Contest contest;
    contest.choose(Course::stairs);
    ASSERT_EQ(contest.last_tick(), 240);
    EXPECT_FALSE(contest.update()) << "nobody said play";
    contest.play();
    int ticks = 0;
    while (contest.update()) ++ticks;
    EXPECT_EQ(ticks, 240);
    EXPECT_EQ(contest.tick(), 240);
    EXPECT_FALSE(contest.plays());
    contest.play();
    EXPECT_EQ(contest.tick(), 0);
    contest.update();
    contest.pause();
    EXPECT_FALSE(contest.update());
    EXPECT_EQ(contest.tick(), 1);
}

TEST(Contest, played_is_where_it_is_stepped_to) {
    Contest played;
    Contest stepped;
    for (Contest* const contest : {&played, &stepped}) contest->choose(Course::ledge);
    played.play();
    for (int i = 0; i < 90; ++i) {
        played.update();
        stepped.step();
    }
    for (std::size_t i = 0; i < Contest::count; ++i)
        EXPECT_TRUE(same_bits(played.position(i), stepped.position(i))) << i;
}

TEST(Contest, on_the_stairs_all_climb) {
    Contest contest;
    contest.choose(Course::stairs);
    contest.go_to(contest.last_tick());
    for (std::size_t i = 0; i < Contest::count; ++i) {
        EXPECT_GT(contest.climbed(i), 1.6) << contest.contestant(i).name;
        EXPECT_EQ(contest.footprints(i).size(), 241U);
    }
    contest.restart();
    for (std::size_t i = 0; i < Contest::count; ++i) EXPECT_LT(contest.climbed(i), 0.02) << "nobody has climbed yet";
}

TEST(Contest, shows_each_at_the_first_tick_at_which_it_has_sunk) {
    for (const double speed : {0.25, 0.5, 1.0, 4.0}) {
        Contest contest;
        contest.choose(Course::ledge);
        contest.set_speed(speed);
        contest.show_sunk(true);
        for (std::size_t i = 0; i < Contest::count; ++i) {
            ASSERT_TRUE(contest.ledge(i).overhang) << speed;
            EXPECT_LE(contest.foot(i).y, -Contest::sink);
            EXPECT_EQ(contest.position(i).x, *contest.ledge(i).overhang);
            EXPECT_GT(contest.footprints(i)[static_cast<std::size_t>(contest.tick_of(i) - 1)].y, -Contest::sink);
        }
        // At 4 m/s what follows the edge down goes faster than what falls freely.
        if (speed <= 1) {
            EXPECT_LT(contest.tick_of(2), contest.tick_of(3)) << "a cone lets go before an ellipsoid";
        }
        EXPECT_LT(contest.tick_of(3), contest.tick_of(0)) << "an ellipsoid before a box";
        contest.step();
        EXPECT_FALSE(contest.shows_sunk()) << "the clock is everybody's again";
    }
}

TEST(Contest, with_another_speed_is_at_a_tick_that_there_is) {
    Contest contest;
    contest.choose(Course::stairs);
    contest.go_to(240);
    contest.set_speed(4);
    EXPECT_EQ(contest.tick(), contest.last_tick());
    contest.set_speed(1e300);
    EXPECT_EQ(contest.speed(), Contest::fastest);
}

TEST(Contest, on_a_slope_measures_what_the_closed_form_says) {
    Contest contest;
    for (const double degrees : {0.0, 17.0, 30.0, 60.0}) {
        contest.set_angle(degrees * degree);
        EXPECT_FALSE(contest.update());
        for (std::size_t i = 0; i < Contest::count; ++i)
            EXPECT_NEAR(contest.slope(i).gap, contest.slope(i).expected, 1e-9) << i << " at " << degrees;
    }
    contest.set_angle(2);
    EXPECT_EQ(contest.angle(), Contest::steepest);
}

// The voxel lesson --------------------------------------------------------------------------------------------------

void settle(VoxelPlay& play) {
    for (int i = 0; i < 200 && play.update(1.0 / 60); ++i) {
    }
}

TEST(VoxelPlay, stepped_back_is_where_it_was_stepped_to) {
    for (std::size_t story = 0; story < voxel_stories().size(); ++story) {
        VoxelPlay play;
        play.choose(story);
        std::vector<dvec3> seen;
        for (int i = 0; i <= play.count(); ++i) {
            for (const VoxelTale* const tale : {&play.wrong(), &play.right()}) seen.push_back(play.position(*tale));
            play.next();
            settle(play);
        }
        ASSERT_EQ(play.taken(), play.count());
        EXPECT_TRUE(play.at_end());
        for (int i = play.count(); i >= 0; --i) {
            ASSERT_EQ(play.taken(), i);
            const auto at = static_cast<std::size_t>(2 * i);
            EXPECT_TRUE(same_bits(play.position(play.wrong()), seen[at]));
            EXPECT_TRUE(same_bits(play.position(play.right()), seen[at + 1]));
            play.back();
        }
        EXPECT_EQ(play.taken(), 0);
        EXPECT_EQ(play.step(play.wrong()), nullptr);
    }
}

TEST(VoxelPlay, has_as_many_steps_wrong_as_right_and_each_begins_where_the_last_one_ended) {
    for (const VoxelStory& story : voxel_stories()) {
        const VoxelTale wrong = tell(story, debugger::VoxelMethod::all_from_the_start);
        const VoxelTale right = tell(story, debugger::VoxelMethod::each_from_the_last);
        EXPECT_EQ(wrong.steps.size(), right.steps.size()) << story.name;
        for (const VoxelTale* const tale : {&wrong, &right}) {
            dvec3 at = story.scene.from;
            for (const debugger::VoxelStep& step : tale->steps) {
                EXPECT_TRUE(same_bits(step.moved_from, at)) << story.name;
                at = step.moved_to;
            }
        }
    }
}

TEST(VoxelPlay, tells_of_a_box_that_only_the_wrong_method_lets_in) {
    for (const VoxelStory& story : voxel_stories()) {
        const auto ever_inside = [&](debugger::VoxelMethod method) {
            const VoxelTale tale = tell(story, method);
            return std::any_of(tale.steps.begin(), tale.steps.end(), [](const auto& step) { return step.inside; });
        };
        EXPECT_TRUE(ever_inside(debugger::VoxelMethod::all_from_the_start)) << story.name;
        EXPECT_FALSE(ever_inside(debugger::VoxelMethod::each_from_the_last)) << story.name;
    }
}

TEST(VoxelPlay, walks_through_the_wall_in_the_story_of_that_name) {
    VoxelPlay play;
    play.choose(1);
    play.play();
    for (int i = 0; i < 3000 && !play.at_end(); ++i) play.update(1.0 / 60);
    ASSERT_TRUE(play.at_end());
    EXPECT_GT(play.position(play.wrong()).z, 4.25) << "it is wholly behind the wall";
    EXPECT_LE(play.position(play.right()).z, 2.75) << "it is still before it";
    EXPECT_NE(play.wrong().conclusion.find("through the wall"), std::string::npos);
    EXPECT_EQ(play.right().conclusion.find("through"), std::string::npos);
    EXPECT_TRUE(same_bits(play.move_start(play.wrong()), play.wrong().steps[4].moved_from));
    play.play();
    EXPECT_EQ(play.taken(), 0) << "played again it begins again";
}

// Pictures ----------------------------------------------------------------------------------------------------------

/// A panel in a window, as the room has it, without the room.
class Show {
public:
    explicit Show(std::unique_ptr<Panel> panel, const view::ivec2& size = {1280, 720}) : panel_(std::move(panel)) {
        auto display = view::Display::open({.size = size, .headless = true});
        EXPECT_TRUE(display) << display.error().text;
        display_ = std::move(*display);
        renderer_ = std::make_unique<view::Renderer>();
        imgui_ = std::make_unique<view::ImGuiAdapter>(*display_);
        stage_.emplace(
            Stage{*display_, *renderer_, settings_, toasts_, browser_, chooser_, levels_, navigation_, true});
        panel_->enter(*stage_);
        look();
        for (int i = 0; i < 3; ++i) frame();
    }

    /// Stands where the room would.
    void look() {
        const auto places = panel_->scene_places();
        ASSERT_FALSE(places.empty());
        constexpr double panel = 460;  // with its margins
        const view::dvec2 size(display_->size());
        camera_.jump_to({.yaw = lesson_yaw, .pitch = lesson_pitch});
        camera_.frame(places, {{0, 0}, {std::max(size.x - panel, 300.0), size.y}}, display_->size());
        camera_.arrive();
    }

    /// Lets time go by without anybody who looks.
    void pass(int ticks) {
        for (int i = 0; i < ticks; ++i) panel_->update(1.0 / 60, inquiry_);
    }

    void frame() {
        imgui_->begin_frame(1.0 / 60);
        panel_->update(1.0 / 60, inquiry_);
        renderer_->begin({camera_.camera(), display_->size(), display_->framebuffer_size()});
        panel_->draw(*renderer_, inquiry_);
        renderer_->end(display_->framebuffer());
        view::draw_labels(renderer_->view(), renderer_->labels());
        if (view::ui::begin(std::string(panel_->name()).c_str(),
                            {.corner = view::ui::Panel::Corner::upper_right, .width = 430}))
            panel_->ui(inquiry_);
        view::ui::end();
        glBindFramebuffer(GL_FRAMEBUFFER, display_->framebuffer());
        glViewport(0, 0, display_->framebuffer_size().x, display_->framebuffer_size().y);
        imgui_->end_frame();
        imgui_->paint();
    }

    /// A script, as docs/playground.md has them.
    void play(const std::string& text) {
        view::ScriptPlayer player(*view::parse_script(text, "test"),
                                  [](std::string_view label) { return view::ui::find_item(label); });
        for (int i = 0; i < 3 || !player.done(); ++i) {
            const auto played = player.next();
            ASSERT_TRUE(played) << played.error().text << "; there are " << view::ui::known_items();
            for (const view::InputEvent& event : played->events) imgui_->event(event);
            frame();
        }
        for (int i = 0; i < 3; ++i) frame();
    }

    view::Picture photo(const std::string& name) {
        EXPECT_EQ(view::gl::take_error(), "");
        const view::Picture picture = view::read_picture(display_->framebuffer(), display_->framebuffer_size());
        std::filesystem::create_directories("lessons");
        EXPECT_TRUE(view::write_png(picture, "lessons/" + name + ".png"));
        EXPECT_GT(picture.colours(), 500U) << name;
        return picture;
    }

private:
    std::unique_ptr<Panel> panel_;
    std::unique_ptr<view::Display> display_;
    std::unique_ptr<view::Renderer> renderer_;
    std::unique_ptr<view::ImGuiAdapter> imgui_;
    view::Settings settings_;
    view::Toasts toasts_;
    view::FileBrowser browser_;
    view::Chooser chooser_;
    LevelLoader levels_{true};
    NavigationOverlay navigation_{true};
    std::optional<Stage> stage_;
    view::OrbitCamera camera_;
    debugger::Question question_;
    debugger::Arena arena_{std::vector<Triangle>{}};
    std::optional<Hit> hit_;
    Inquiry inquiry_{question_, arena_, hit_};
};

bool same(const view::Picture& a, const view::Picture& b) {
    return a.size == b.size && std::memcmp(a.pixels.data(), b.pixels.data(), a.pixels.size() * 4) == 0;
}

TEST(Lessons, side_by_side_is_a_picture_on_every_course) {
    Show show(make_side_by_side_panel());
    const view::Picture slope = show.photo("debugger-slope");
    show.play("click \"45°\"\nmove 5 700");
    EXPECT_FALSE(same(slope, show.photo("slope-45")));
    show.play("click \"30°\"\nmove 5 700");
    EXPECT_TRUE(same(slope, show.photo("debugger-slope"))) << "there and back is another picture";
    show.play("click \"Stairs\"\nwait 1\nclick \"Play\"\nmove 5 700");
    show.pass(300);
    show.play("wait 1");
    show.photo("debugger-stairs");
    show.play("click \"Ledge\"\nwait 1\nclick \"Each where it has sunk 5 cm\"\nmove 5 700");
    const view::Picture sunk = show.photo("debugger-ledge");
    show.play("click \"Step\"\nmove 5 700");
    EXPECT_FALSE(same(sunk, show.photo("ledge-step")));
}

TEST(Lessons, voxels_is_a_picture_at_every_step_of_every_story) {
    Show show(make_voxels_panel());
    show.photo("voxels-start");
    const auto click = [&](const std::string& label, int ticks) {
        show.play("click \"" + label + "\"\nmove 5 700");
        show.pass(ticks);
        show.play("wait 1");
    };
    click("Next", 60);
    click("Next", 60);
    const view::Picture second = show.photo("debugger-voxels");
    click("Back", 10);
    EXPECT_FALSE(same(second, show.photo("voxels-first")));
    click("Next", 60);
    EXPECT_TRUE(same(second, show.photo("debugger-voxels"))) << "back and next again is another picture";
    click("The wall it walks through", 1);
    click("Play", 800);
    show.photo("voxels-wall");
    click("The step it falls into", 1);
    click("Next", 60);
    click("Next", 60);
    show.photo("voxels-step");
}

TEST(Lessons, are_pictures_in_a_small_window_too) {
    {
        Show show(make_side_by_side_panel(), {800, 600});
        show.photo("slope-800");
        show.play("click \"Ledge\"\nwait 1\nclick \"Each where it has sunk 5 cm\"\nmove 5 590");
        show.photo("ledge-800");
    }
    Show show(make_voxels_panel(), {800, 600});
    show.play("click \"Next\"\nmove 5 590");
    show.pass(60);
    show.play("wait 1");
    show.photo("voxels-800");
}

}  // namespace
}  // namespace surefoot::playground
