// Every screen, by the program itself, without a display.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <thread>

#include "playground/walk/fetcher.hpp"
#include "small_app.hpp"
#include "view/gl.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

const std::string ground = SUREFOOT_LEVELS_DIR "/training-ground.glb";

void play(App& app, const std::string& script) {
    app.play(*view::parse_script(script, "test"));
    for (int i = 0; i < 400 && app.frame(); ++i) {
    }
    EXPECT_EQ(app.failure(), "");
}

void expect_a_picture(App& app) {
    EXPECT_EQ(view::gl::take_error(), "");
    EXPECT_GT(app.picture().colours(), 500U);
}

bool same(const view::Picture& a, const view::Picture& b) {
    return a.size == b.size && std::equal(a.pixels.begin(), a.pixels.end(), b.pixels.begin(),
                                          [](auto x, auto y) { return x.r == y.r && x.g == y.g && x.b == y.b; });
}

TEST(Playground, the_start_screen_is_a_picture_and_its_card_opens_the_room) {
    const auto app = open("");
    play(*app, "wait 3\nclick \"Walk\"\nwait 3\nquit");
    EXPECT_EQ(app->room(), "walk");
    expect_a_picture(*app);
}

TEST(Playground, every_room_is_entered_and_left_by_escape) {
    for (const RoomCard& card : rooms()) {
        const auto app = open(std::string(card.id), ground);
        play(*app, "wait 4\nquit");
        EXPECT_EQ(app->room(), card.id);
        expect_a_picture(*app);
        app->go_to("");
        app->frame();
        EXPECT_EQ(app->room(), "");
    }
}

TEST(Playground, every_overlay_and_tool_of_walk_is_a_picture) {
    const auto app = open("walk", ground);
    play(*app, "wait 3\nclick \"Edges by kind\"\nclick \"Tree\"\nkey I\nkey N\nwait 20\nquit");
    expect_a_picture(*app);
    play(*app, "key 2\nclick 320 250\nclick 400 270\nwait 2\nquit");
    expect_a_picture(*app);
    play(*app, "key F\nkey 3\nclick 320 240\nwait 80\nquit");
    expect_a_picture(*app);
    play(*app, "key C\nhold W\nwait 20\nunhold W\ndrag 300 200 400 220 4\nquit");
    expect_a_picture(*app);
}

TEST(Playground, help_opens_with_f1_and_closes_with_escape) {
    const auto app = open("walk", ground);
    play(*app, "wait 2\nkey G\nwait 5\nquit");  // nothing moves while nobody is on foot
    const view::Picture before = app->picture();
    play(*app, "key F1\nwait 3\nquit");
    EXPECT_FALSE(same(before, app->picture()));
    play(*app, "key Escape\nwait 3\nquit");
    EXPECT_TRUE(same(before, app->picture()));
    EXPECT_EQ(app->room(), "walk");
}

TEST(Playground, the_same_script_gives_the_same_picture) {
    view::Picture pictures[2];
    for (view::Picture& picture : pictures) {
        const auto app = open("walk", ground);
        play(*app, "wait 2\nkey 3\nclick 320 240\ndrag 300 200 380 230 6\nwait 12\nquit");
        picture = app->picture();
    }
    EXPECT_TRUE(same(pictures[0], pictures[1]));
}

TEST(Playground, a_level_that_is_dropped_is_opened_and_remembered) {
    const auto app = open("walk", ground);
    play(*app, "wait 2\nquit");
    app->push(view::FileDrop{{SUREFOOT_LEVELS_DIR "/../examples/yard.obj"}});
    app->frame();
    app->frame();
    ASSERT_FALSE(app->stage().settings.recent.empty());
    EXPECT_TRUE(app->stage().settings.recent.front().ends_with("examples/yard.obj"));
}

TEST(Playground, a_file_that_is_no_level_is_told_and_the_old_level_stays) {
    const auto app = open("walk", ground);
    play(*app, "wait 2\ndrop " SUREFOOT_LEVELS_DIR "/README.md\nwait 3\nquit");
    ASSERT_FALSE(app->stage().toasts.texts().empty());
    EXPECT_NE(app->stage().toasts.texts().back().find("README.md"), std::string::npos);
    expect_a_picture(*app);
}

TEST(Playground, a_label_that_is_not_there_fails_the_run) {
    const auto app = open("");
    app->play(*view::parse_script("click \"Nothing of the kind\"", "test"));
    for (int i = 0; i < 200 && app->frame(); ++i) {
    }
    EXPECT_NE(app->failure().find("test:1"), std::string::npos);
    EXPECT_NE(app->failure().find("\"Walk\""), std::string::npos);
}

TEST(Playground, a_level_that_arrives_after_its_room_was_left_calls_nobody) {
    for (const RoomCard& card : rooms()) {
        const auto app = open(std::string(card.id), ground);
        play(*app, "wait 2\nquit");
        bool called = false;
        app->stage().open_level(ground, [&](const LevelLoader::Loaded&) { called = true; });
        app->go_to("");
        for (int i = 0; i < 3; ++i) app->frame();
        EXPECT_FALSE(called) << card.id;
        EXPECT_EQ(app->stage().levels.loading(), "") << card.id;
    }
}

TEST(Playground, a_dialog_closes_with_the_room_that_opened_it) {
    const auto app = open("walk", ground);
    play(*app, "wait 2\nkey Control+O\nwait 2\nquit");
    ASSERT_TRUE(app->stage().browser.is_open());
    app->go_to("");
    app->frame();
    EXPECT_FALSE(app->stage().browser.is_open());
}

TEST(Playground, the_dialog_goes_into_folders_and_opens_what_is_chosen) {
    namespace fs = std::filesystem;
    const fs::path folder = fs::path(::testing::TempDir()) / "surefoot-dialog";
    fs::remove_all(folder);
    fs::create_directories(folder / "inner");
    fs::copy_file(SUREFOOT_LEVELS_DIR "/../examples/yard.obj", folder / "inner/yard.obj");
    std::ofstream(folder / "inner/notes.txt") << "no level";
    const auto app = open("walk", ground);
    play(*app, "wait 2\nquit");
    std::string chosen;
    app->stage().browser.open(
        "Open", {".obj"}, [&](const std::string& path) { chosen = path; }, folder.string());
    play(*app, "wait 2\nclick \"inner/\"\nwait 2\nquit");
    EXPECT_FALSE(view::ui::find_item("notes.txt"));
    play(*app, "click \"Up\"\nwait 2\nclick \"inner/\"\nwait 2\nclick \"yard.obj\"\nwait 2\nquit");
    EXPECT_EQ(fs::path(chosen), fs::weakly_canonical(folder / "inner/yard.obj"));
    EXPECT_FALSE(app->stage().browser.is_open());
    app->stage().browser.open("Open", {".obj"}, [&](const std::string&) { chosen = "again"; });
    play(*app, "wait 2\nclick \"Cancel\"\nwait 2\nquit");
    EXPECT_FALSE(app->stage().browser.is_open());
    EXPECT_NE(chosen, "again");
}

TEST(Playground, maps_are_fetched_by_the_button_and_the_room_may_be_left_meanwhile) {
    namespace fs = std::filesystem;
    const fs::path home = fs::path(::testing::TempDir()) / "surefoot-fetch";
    fs::remove_all(home);
    fs::create_directories(home / "levels");
    const fs::path script = home / "levels/fetch";
    const std::string level = fs::absolute(ground).string();
    const fs::path before = fs::current_path();
    fs::current_path(home);
    ::setenv("XDG_CACHE_HOME", (home / "cache").c_str(), 1);
    const auto write = [&](const char* body) {
        std::ofstream(script) << "#!/bin/sh\n" << body;
        fs::permissions(script, fs::perms::owner_all);
    };
    const auto fetched = [&](App& app) {
        play(app, "wait 3\nclick \"Fetch OpenArena's maps\"\nwait 1\nquit");
        for (int i = 0; i < 500 && app.stage().toasts.texts().empty(); ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
            app.frame();
        }
        return app.stage().toasts.texts().empty() ? std::string() : app.stage().toasts.texts().back();
    };
    write("echo no network today >&2\nexit 1\n");
    EXPECT_EQ(fetched(*open("walk", level)), "no network today");
    write("mkdir -p \"$XDG_CACHE_HOME/surefoot/levels/openarena-081-maps\"; test \"$1\" = openarena\n");
    auto app = open("walk", level);
    EXPECT_NE(fetched(*app).find("are there"), std::string::npos);
    play(*app, "wait 2\nquit");
    EXPECT_FALSE(view::ui::find_item("Fetch OpenArena's maps")) << "they are there";
    app.reset();
    fs::remove_all(home / "cache");
    write("echo started >> starts\nsleep 20\n");
    const auto slow = open("walk", level);
    play(*slow, "wait 3\nclick \"Fetch OpenArena's maps\"\nwait 1\nquit");
    const auto start = std::chrono::steady_clock::now();
    slow->go_to("");
    slow->frame();
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
    slow->go_to("walk");
    play(*slow, "wait 3\nquit");
    EXPECT_FALSE(view::ui::find_item("Fetch OpenArena's maps")) << "it still runs";
    Fetcher().begin();
    for (int i = 0; i < 500 && !fs::exists(home / "starts"); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    EXPECT_EQ(fs::file_size(home / "starts"), std::string("started\n").size()) << "one start";
    fs::current_path(before);
}

TEST(LevelLoader, a_level_that_was_forgotten_while_it_was_read_never_calls_back) {
    LevelLoader loader(false);
    int called = 0;
    const auto count = [&](const auto&) { ++called; };
    loader.load(ground, count, count);
    loader.forget();
    EXPECT_EQ(loader.loading(), "");
    EXPECT_EQ(loader.step(), "");
    EXPECT_FALSE(loader.update());
    loader.load(ground, count, count);
    EXPECT_NE(loader.step(), "");
    while (loader.update()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_EQ(called, 1);
}

TEST(Playground, a_contact_sheet_has_every_screenshot_and_its_caption) {
    const std::string folder = ::testing::TempDir();
    const auto app = open("", {}, folder + "sheet.png");
    const auto shots = [&](int count, const std::string& caption) {
        std::string script = "wait 2\n";
        for (int i = 0; i < count; ++i) script += caption + "screenshot " + folder + "shot.png\n";
        play(*app, script + "wait 1\nquit");
    };
    shots(1, "");
    const view::Picture bare = app->contact_sheet();
    EXPECT_GT(bare.size.x, view::thumbnail_width);
    EXPECT_LT(bare.size.x, 2 * view::thumbnail_width);
    shots(4, "caption The start, again\n");
    const view::Picture five = app->contact_sheet();
    EXPECT_GT(five.size.x, 3 * view::thumbnail_width);
    EXPECT_GT(five.size.y, 2 * bare.size.y - 40);
    // Ink below the second picture, none below the first.
    const auto ink = [&](int column) {
        int dark = 0;
        for (int y = bare.size.y - 40; y < bare.size.y - 18; ++y)
            for (int x = 0; x < view::thumbnail_width; ++x)
                dark += five.at(18 + column * (view::thumbnail_width + 18) + x, y).g < 120;
        return dark;
    };
    EXPECT_EQ(ink(0), 0);
    EXPECT_GT(ink(1), 100);
}

TEST(Playground, another_size_is_drawn_at_that_size) {
    const auto app = open("walk", ground);
    play(*app, "wait 2\nresize 800 300\nwait 4\nquit");
    EXPECT_EQ(app->picture().size, view::ivec2(800, 300));
    expect_a_picture(*app);
}

}  // namespace
}  // namespace surefoot::playground
