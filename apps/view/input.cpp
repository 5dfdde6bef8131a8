#include "view/input.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>

namespace surefoot::view {
namespace {

constexpr std::size_t key_count = static_cast<std::size_t>(Key::count);

constexpr std::array<std::string_view, key_count> names{
    "",     "A",     "B",      "C",        "D",     "E",         "F",      "G",      "H",      "I",     "J",     "K",
    "L",    "M",     "N",      "O",        "P",     "Q",         "R",      "S",      "T",      "U",     "V",     "W",
    "X",    "Y",     "Z",      "0",        "1",     "2",         "3",      "4",      "5",      "6",     "7",     "8",
    "9",    "F1",    "F2",     "F3",       "F4",    "F5",        "F6",     "F7",     "F8",     "F9",    "F10",   "F11",
    "F12",  "Space", "Enter",  "Escape",   "Tab",   "Backspace", "Delete", "Insert", "Left",   "Right", "Up",    "Down",
    "Home", "End",   "PageUp", "PageDown", "Shift", "Control",   "Alt",    "Minus",  "Equals", "Comma", "Period"};

constexpr std::array<std::string_view, static_cast<std::size_t>(PadButton::count)> pad_buttons{
    "a",     "b",          "x",           "y",  "left_bumper", "right_bumper", "back", "start",
    "guide", "left_thumb", "right_thumb", "up", "right",       "down",         "left"};

constexpr std::array<std::string_view, static_cast<std::size_t>(PadAxis::count)> pad_axes{
    "left_x", "left_y", "right_x", "right_y", "left_trigger", "right_trigger"};

bool same_word(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

/// The place of a word in a list; the length of the list if it is not there.
std::size_t place_of(std::string_view name, std::span<const std::string_view> all) {
    return static_cast<std::size_t>(
        std::find_if(all.begin(), all.end(), [&](std::string_view one) { return same_word(one, name); }) - all.begin());
}

}  // namespace

std::string_view button_name(PadButton button) {
    return pad_buttons[static_cast<std::size_t>(button)];
}

std::string_view axis_name(PadAxis axis) {
    return pad_axes[static_cast<std::size_t>(axis)];
}

PadButton pad_button_named(std::string_view name) {
    return static_cast<PadButton>(place_of(name, pad_buttons));
}

PadAxis pad_axis_named(std::string_view name) {
    return static_cast<PadAxis>(place_of(name, pad_axes));
}

std::string_view key_name(Key key) {
    return names[static_cast<std::size_t>(key)];
}

Key key_named(std::string_view name) {
    for (std::size_t i = 1; i < key_count; ++i)
        if (same_word(names[i], name)) return static_cast<Key>(i);
    return Key::none;
}

bool is_press(const InputEvent& event, Key key, const Modifiers& with) {
    const auto* const press = std::get_if<KeyPress>(&event);
    return press != nullptr && press->key == key && press->down && !press->repeat && press->held.shift == with.shift &&
           press->held.control == with.control && press->held.alt == with.alt;
}

}  // namespace surefoot::view
