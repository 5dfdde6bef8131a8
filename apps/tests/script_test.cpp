#include "view/script.hpp"

#include <gtest/gtest.h>

namespace surefoot::view {
namespace {

std::string error_of(std::string_view text) {
    const auto script = parse_script(text, "tour.txt");
    return script ? std::string() : script.error().text;
}

ScriptPlayer player(std::string_view text, ScriptPlayer::FindLabel find = {}) {
    return ScriptPlayer(*parse_script(text, "tour.txt"), std::move(find));
}

TEST(Script, reads_every_command) {
    const auto script = parse_script(
        "# a comment\n\nframe 10\nwait 2\nmove 640 360.5\npress left\nrelease left\nclick right 1 2\nclick \"Open "
        "...\"\n"
        "drag 100 100 200 220 12  # behind it\nwheel -2\nkey Control+Shift+z\nhold W\nunhold W\ntext 1.5 m\n"
        "drop my level.obj\nresize 800 600\ncaption what is seen\nscreenshot out.png\nquit\n",
        "tour.txt");
    ASSERT_TRUE(script) << script.error().text;
    ASSERT_EQ(script->commands.size(), 18U);
    EXPECT_EQ(script->commands[2].to, dvec2(640, 360.5));
    EXPECT_EQ(script->commands[5].button, MouseButton::right);
    EXPECT_EQ(script->commands[6].text, "Open ...");
    EXPECT_EQ(script->commands[7].count, 12);
    EXPECT_TRUE(script->commands[9].held.control && script->commands[9].held.shift);
    EXPECT_EQ(script->commands[9].key, Key::z);
    EXPECT_EQ(script->commands[12].text, "1.5 m");
    EXPECT_EQ(script->commands[13].text, "my level.obj");
    EXPECT_EQ(script->commands[17].line, 20);
}

TEST(Script, errors_name_file_and_line_and_say_how_to_write_it) {
    EXPECT_EQ(error_of("wait 1\nmove 1\n"), "tour.txt:2: write: move X Y");
    EXPECT_NE(error_of("jump 3").find("tour.txt:1: unknown command 'jump'"), std::string::npos);
    EXPECT_NE(error_of("\n\nkey Hyper").find("tour.txt:3: there is no such key"), std::string::npos);
    EXPECT_NE(error_of("move a b").find("'a' is no number"), std::string::npos);
    EXPECT_NE(error_of("click \"Open").find("quotation mark"), std::string::npos);
    EXPECT_NE(error_of("drag 1 2 3 4 0").find("at least one frame"), std::string::npos);
    EXPECT_NE(error_of("resize 0 5").find("1 to 16384"), std::string::npos);
    EXPECT_NE(error_of("move nan 5").find("no number"), std::string::npos);
}

TEST(Script, a_gamepad_is_played_as_any_other_hand) {
    ScriptPlayer p = player("pad press A\naxis left_y -0.5\npad release a\n");
    const auto frame = p.next();
    ASSERT_TRUE(frame);
    ASSERT_EQ(frame->events.size(), 3U);
    EXPECT_EQ(std::get<GamepadButton>(frame->events[0]).button, PadButton::a);
    EXPECT_TRUE(std::get<GamepadButton>(frame->events[0]).down);
    EXPECT_EQ(std::get<GamepadAxis>(frame->events[1]).axis, PadAxis::left_y);
    EXPECT_EQ(std::get<GamepadAxis>(frame->events[1]).value, -0.5);
    EXPECT_FALSE(std::get<GamepadButton>(frame->events[2]).down);
    EXPECT_NE(error_of("pad A").find("write: pad press A"), std::string::npos);
    EXPECT_NE(error_of("pad press Z").find("left_bumper"), std::string::npos);
    EXPECT_NE(error_of("axis left_y 2").find("from -1 to 1"), std::string::npos);
    EXPECT_NE(error_of("axis nose 0").find("right_trigger"), std::string::npos);
}

TEST(Script, a_caption_belongs_to_the_next_screenshot_alone) {
    ScriptPlayer p = player("caption One thing\nscreenshot a.png\nscreenshot b.png\n");
    const auto first = p.next();
    const auto second = p.next();
    ASSERT_TRUE(first && second);
    ASSERT_EQ(first->screenshots.size(), 1U);
    EXPECT_EQ(first->screenshots[0].caption, "One thing");
    EXPECT_EQ(first->screenshots[0].path, "a.png");
    EXPECT_EQ(second->screenshots.at(0).caption, "");
}

TEST(Script, a_drag_goes_all_the_way_and_lets_go_at_its_end) {
    ScriptPlayer p = player("drag 10 10 40 70 3");
    std::vector<InputEvent> all;
    for (int i = 0; i < 10 && !p.done(); ++i) {
        const auto frame = p.next();
        ASSERT_TRUE(frame);
        all.insert(all.end(), frame->events.begin(), frame->events.end());
    }
    ASSERT_EQ(all.size(), 6U);
    EXPECT_TRUE(std::get<ButtonPress>(all[1]).down);
    EXPECT_EQ(std::get<PointerMove>(all[4]).at, dvec2(40, 70));
    EXPECT_EQ(std::get<PointerMove>(all[4]).by, dvec2(10, 20));
    EXPECT_FALSE(std::get<ButtonPress>(all[5]).down);
}

TEST(Script, what_stands_behind_frame_waits_for_that_frame) {
    ScriptPlayer p = player("frame 2\nmove 1 1");
    EXPECT_TRUE(p.next()->events.empty());
    EXPECT_TRUE(p.next()->events.empty());
    EXPECT_EQ(p.next()->events.size(), 1U);
    EXPECT_TRUE(p.done());
}

TEST(Script, a_label_is_pressed_where_it_is_and_one_that_never_comes_is_an_error) {
    ScriptPlayer p = player("click \"Go\"", [](std::string_view label) {
        return label == "Go" ? std::optional<dvec2>(dvec2(30, 40)) : std::nullopt;
    });
    EXPECT_EQ(std::get<PointerMove>(p.next()->events.at(0)).at, dvec2(30, 40));
    ScriptPlayer never = player("wait 1\nclick \"Stop\"", [](std::string_view) { return std::optional<dvec2>(); });
    std::string text;
    for (int i = 0; i < 200 && text.empty(); ++i) {
        const auto frame = never.next();
        if (!frame) text = frame.error().text;
    }
    EXPECT_EQ(text, "tour.txt:2: no widget is called \"Stop\"");
}

TEST(Script, a_moment_is_waited_for_as_long_as_it_takes_but_not_for_ever) {
    bool come = false;
    ScriptPlayer p(*parse_script("await The old tower\nmove 1 1", "tour.txt"), {},
                   [&](std::string_view moment) { return come && moment == "The old tower"; });
    for (int i = 0; i < 1000; ++i) ASSERT_TRUE(p.next()->events.empty());
    come = true;
    EXPECT_EQ(p.next()->events.size(), 1U);
    ScriptPlayer never = player("wait 1\nawait Godot");
    std::string text;
    for (int i = 0; i < 20000 && text.empty(); ++i) {
        const auto frame = never.next();
        if (!frame) text = frame.error().text;
    }
    EXPECT_EQ(text, "tour.txt:2: the moment \"Godot\" does not come");
    EXPECT_EQ(error_of("await"), "tour.txt:1: write: await MOMENT");
}

TEST(Script, what_follows_a_screenshot_happens_in_the_next_frame) {
    ScriptPlayer p = player("screenshot a.png\nmove 5 5");
    const auto first = p.next();
    EXPECT_EQ(first->screenshots.size(), 1U);
    EXPECT_TRUE(first->events.empty());
    EXPECT_EQ(p.next()->events.size(), 1U);
}

}  // namespace
}  // namespace surefoot::view
