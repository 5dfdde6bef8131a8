// A .pk3 with several maps: the user is asked which.
#include <filesystem>
#include <gtest/gtest.h>
#include <unistd.h>

#include "quake3_map.hpp"
#include "small_app.hpp"
#include "view/widgets.hpp"
#include "zipped.hpp"

namespace surefoot::playground {
namespace {

namespace fs = std::filesystem;

std::string box_map(float size) {
    test::MapWriter map;
    map.box(map.texture("stone", 0, test::player_clip), {0, 0, 0}, {size, size, size});
    return map.bytes();
}

std::string packed(const std::string& name, const test::Files& files) {
    const fs::path folder = fs::path(testing::TempDir()) / ("surefoot-packed-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    fs::remove(folder / name);
    return test::zipped((folder / name).string(), files);
}

std::string two_maps() {
    return packed("two.pk3", {{"maps/attic.bsp", box_map(32)}, {"maps/cellar.bsp", box_map(320)}});
}

void play(App& app, const std::string& script) {
    app.play(*view::parse_script(script + "\nquit", "test"));
    for (int i = 0; i < 400 && app.frame(); ++i) {
    }
    EXPECT_EQ(app.failure(), "");
}

std::string newest_level(App& app) {
    return app.stage().settings.recent.empty() ? "" : app.stage().settings.recent.front();
}

TEST(PackedMaps, every_room_that_is_given_several_asks_which_and_opens_it) {
    const std::string file = two_maps();
    for (const char* const room : {"walk", "debugger"}) {
        const auto app = open(room, file);
        play(*app, "wait 3");
        EXPECT_TRUE(app->stage().chooser.is_open()) << room;
        EXPECT_TRUE(app->stage().toasts.texts().empty()) << app->stage().toasts.texts().back();
        EXPECT_TRUE(view::ui::find_item("maps/attic.bsp"));
        play(*app, "click \"maps/cellar.bsp\"\nwait 3");
        EXPECT_FALSE(app->stage().chooser.is_open());
        EXPECT_EQ(newest_level(*app), file + ":maps/cellar.bsp") << room;
    }
}

TEST(PackedMaps, one_that_is_dropped_asks_and_escape_leaves_the_level_that_was_open) {
    const auto app = open("walk", SUREFOOT_LEVELS_DIR "/training-ground.glb");
    play(*app, "wait 3\ndrop " + two_maps() + "\nwait 3");
    EXPECT_TRUE(app->stage().chooser.is_open());
    play(*app, "key Escape\nwait 2");
    EXPECT_FALSE(app->stage().chooser.is_open());
    EXPECT_EQ(app->room(), "walk");
    EXPECT_TRUE(newest_level(*app).ends_with("training-ground.glb"));
}

TEST(PackedMaps, part_of_a_name_shortens_the_list) {
    const auto app = open("walk", two_maps());
    play(*app, "wait 3\nclick \"Part of its name\"\ntext cel\nwait 3");
    EXPECT_FALSE(view::ui::find_item("maps/attic.bsp"));
    EXPECT_TRUE(view::ui::find_item("maps/cellar.bsp"));
}

TEST(PackedMaps, the_only_map_is_opened_without_asking) {
    const std::string file = packed("one.pk3", {{"maps/attic.bsp", box_map(32)}, {"scripts/a.txt", "x"}});
    const auto app = open("walk", file);
    play(*app, "wait 3");
    EXPECT_FALSE(app->stage().chooser.is_open());
    EXPECT_EQ(newest_level(*app), file);
}

TEST(PackedMaps, the_map_that_was_open_last_opens_again) {
    const std::string file = two_maps();
    const auto app = open("", "");
    app->stage().settings.recent = {file + ":maps/cellar.bsp", SUREFOOT_LEVELS_DIR "/training-ground.glb"};
    app->go_to("walk");
    play(*app, "wait 3");
    EXPECT_EQ(newest_level(*app), file + ":maps/cellar.bsp");
    EXPECT_TRUE(app->stage().toasts.texts().empty());
    EXPECT_TRUE(view::ui::find_item("Recent"));
}

TEST(PackedMaps, asking_ends_with_the_room) {
    const auto app = open("walk", two_maps());
    play(*app, "wait 3");
    app->go_to("");
    app->frame();
    EXPECT_FALSE(app->stage().chooser.is_open());
}

}  // namespace
}  // namespace surefoot::playground
