// What GLFW's callbacks make of what they are told.
#include "view/window_events.hpp"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

namespace surefoot::view {
namespace {

TEST(WindowEvents, a_drop_of_files_is_one_event_with_all_of_them) {
    WindowEvents events;
    const char* const paths[] = {"/levels/a.obj", "/levels/b c.glb"};
    events.drop(2, paths);
    ASSERT_EQ(events.waiting.size(), 1U);
    EXPECT_EQ(std::get<FileDrop>(events.waiting[0]).files,
              (std::vector<std::string>{"/levels/a.obj", "/levels/b c.glb"}));
}

TEST(WindowEvents, keys_carry_what_is_held_with_them) {
    WindowEvents events;
    events.key(GLFW_KEY_LEFT_CONTROL, GLFW_PRESS, 0);
    events.key(GLFW_KEY_Z, GLFW_PRESS, GLFW_MOD_CONTROL | GLFW_MOD_SHIFT);
    events.key(GLFW_KEY_Z, GLFW_REPEAT, GLFW_MOD_CONTROL);
    EXPECT_TRUE(std::get<KeyPress>(events.waiting[0]).held.control);
    EXPECT_TRUE(is_press(events.waiting[1], Key::z, {.shift = true, .control = true}));
    EXPECT_TRUE(std::get<KeyPress>(events.waiting[2]).repeat);
}

TEST(WindowEvents, the_first_move_is_no_jump) {
    WindowEvents events;
    events.move(500, 300);
    events.move(510, 290);
    EXPECT_EQ(std::get<PointerMove>(events.waiting[0]).by, dvec2(0, 0));
    EXPECT_EQ(std::get<PointerMove>(events.waiting[1]).by, dvec2(10, -10));
    events.button(GLFW_MOUSE_BUTTON_RIGHT, GLFW_PRESS, 0);
    EXPECT_EQ(std::get<ButtonPress>(events.waiting[2]).at, dvec2(510, 290));
}

TEST(WindowEvents, of_a_gamepad_what_changes_is_an_event_and_without_it_nothing_is_held) {
    WindowEvents events;
    GLFWgamepadstate pad{};
    pad.axes[GLFW_GAMEPAD_AXIS_LEFT_TRIGGER] = pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER] = -1;
    events.gamepad(&pad);
    EXPECT_TRUE(events.waiting.empty());
    pad.buttons[GLFW_GAMEPAD_BUTTON_A] = GLFW_PRESS;
    pad.axes[GLFW_GAMEPAD_AXIS_LEFT_Y] = -0.5F;
    pad.axes[GLFW_GAMEPAD_AXIS_RIGHT_X] = 0.001F;  // it trembles
    events.gamepad(&pad);
    events.gamepad(&pad);
    ASSERT_EQ(events.waiting.size(), 2U);
    EXPECT_EQ(std::get<GamepadButton>(events.waiting[0]).button, PadButton::a);
    EXPECT_TRUE(std::get<GamepadButton>(events.waiting[0]).down);
    EXPECT_EQ(std::get<GamepadAxis>(events.waiting[1]).axis, PadAxis::left_y);
    EXPECT_EQ(std::get<GamepadAxis>(events.waiting[1]).value, -0.5);
    events.waiting.clear();
    events.gamepad(nullptr);  // it was pulled out
    ASSERT_EQ(events.waiting.size(), 2U);
    EXPECT_FALSE(std::get<GamepadButton>(events.waiting[0]).down);
    EXPECT_EQ(std::get<GamepadAxis>(events.waiting[1]).value, 0);
}

TEST(WindowEvents, letters_of_any_alphabet_become_utf8) {
    EXPECT_EQ(utf8('a'), "a");
    EXPECT_EQ(utf8(0xE4), "\xC3\xA4");
    EXPECT_EQ(utf8(0x20AC), "\xE2\x82\xAC");
    EXPECT_EQ(utf8(0x1F600), "\xF0\x9F\x98\x80");
    EXPECT_EQ(utf8(0x110000), "");
}

TEST(WindowEvents, losing_the_focus_lets_shift_go) {
    WindowEvents events;
    events.key(GLFW_KEY_LEFT_SHIFT, GLFW_PRESS, 0);
    events.focus(false);
    events.move(1, 1);
    EXPECT_FALSE(std::get<PointerMove>(events.waiting.back()).held.shift);
}

TEST(Keys, have_names_that_lead_back_to_them) {
    for (int i = 1; i < static_cast<int>(Key::count); ++i)
        EXPECT_EQ(key_named(key_name(static_cast<Key>(i))), static_cast<Key>(i)) << i;
    EXPECT_EQ(key_named("pageup"), Key::page_up);
    EXPECT_EQ(key_named("anything"), Key::none);
}

}  // namespace
}  // namespace surefoot::view
