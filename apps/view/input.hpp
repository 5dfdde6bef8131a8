/// One stream of input for everything: filled by a window or by a script, read by widgets, cameras and rooms.
/// Places are in window units with the origin at the upper left; a framebuffer may have more pixels than that.
#pragma once

#include <cstdint>
#include <glm/ext/vector_double2.hpp>
#include <glm/ext/vector_int2.hpp>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace surefoot::view {

using glm::dvec2;
using glm::ivec2;

// clang-format off
enum class Key : std::uint8_t {
    none,
    a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v, w, x, y, z,
    digit_0, digit_1, digit_2, digit_3, digit_4, digit_5, digit_6, digit_7, digit_8, digit_9,
    f1, f2, f3, f4, f5, f6, f7, f8, f9, f10, f11, f12,
    space, enter, escape, tab, backspace, del, insert, left, right, up, down, home, end, page_up, page_down,
    shift, control, alt, minus, equals, comma, period,
    count,
};
// clang-format on

/// "A", "7", "F1", "Left", "PageUp": as scripts and the help write it; empty for none.
[[nodiscard]] std::string_view key_name(Key key);

/// The key of this name, whatever the case; none if there is none.
[[nodiscard]] Key key_named(std::string_view name);

enum class MouseButton : std::uint8_t { left, right, middle };

struct Modifiers {
    bool shift = false;
    bool control = false;
    bool alt = false;
};

struct KeyPress {
    Key key = Key::none;
    bool down = true;
    bool repeat = false;  ///< the key is held and this is not its first press
    Modifiers held{};
};

struct ButtonPress {
    MouseButton button = MouseButton::left;
    bool down = true;
    dvec2 at{0, 0};
    Modifiers held{};
};

struct PointerMove {
    dvec2 at{0, 0};
    dvec2 by{0, 0};  ///< since the last move; all there is while the pointer is captured
    Modifiers held{};
};

struct WheelTurn {
    dvec2 by{0, 0};  ///< y > 0 turns away from the user
    dvec2 at{0, 0};
    Modifiers held{};
};

/// As on most gamepads: A is the lowest of the four, B the right, X the left, Y the upper one.
// clang-format off
enum class PadButton : std::uint8_t {
    a, b, x, y, left_bumper, right_bumper, back, start, guide, left_thumb, right_thumb, up, right, down, left,
    count,
};
// clang-format on

enum class PadAxis : std::uint8_t { left_x, left_y, right_x, right_y, left_trigger, right_trigger, count };

/// "a", "left_bumper", "left_x": as scripts write them.
[[nodiscard]] std::string_view button_name(PadButton button);
[[nodiscard]] std::string_view axis_name(PadAxis axis);

/// The one of this name, whatever the case; `count` if there is none.
[[nodiscard]] PadButton pad_button_named(std::string_view name);
[[nodiscard]] PadAxis pad_axis_named(std::string_view name);

struct GamepadButton {
    PadButton button = PadButton::a;
    bool down = true;
};

struct GamepadAxis {
    PadAxis axis = PadAxis::left_x;
    double value = 0;  ///< to the right and down [-1 to 1]; of a trigger that nobody touches -1
};

struct TextInput {
    std::string text;  ///< UTF-8
};

struct FileDrop {
    std::vector<std::string> files;
};

struct Resize {
    ivec2 size{0, 0};         ///< in window units
    ivec2 framebuffer{0, 0};  ///< in pixels
};

struct FocusChange {
    bool focused = true;
};

struct ScaleChange {
    double scale = 1;  ///< how many times as large as usual the user's system wants letters
};

struct CloseRequest {};

using InputEvent = std::variant<KeyPress, ButtonPress, PointerMove, WheelTurn, TextInput, FileDrop, Resize, FocusChange,
                                ScaleChange, CloseRequest, GamepadButton, GamepadAxis>;

/// Is it this key going down for the first time, with nothing but these modifiers?
[[nodiscard]] bool is_press(const InputEvent& event, Key key, const Modifiers& with = {});

}  // namespace surefoot::view
