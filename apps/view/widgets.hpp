/// Widgets that scripts can find by their label. Those of Dear ImGui may be used too; say `ui::item` after one that a
/// script should be able to press.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "view/camera.hpp"
#include "view/colour.hpp"

namespace surefoot::view::ui {

/// A panel with a title in a corner or at a place; the panel's height follows from what is in it.
struct Panel {
    enum class Corner { upper_left, upper_right, lower_left, lower_right };
    Corner corner = Corner::upper_left;
    double width = 300;      ///< [window units, for usual letters]
    double most_height = 0;  ///< [window units]; 0 for what the window has
    dvec2 margin{14, 14};    ///< from the corner
};

/// Draw the widgets between `begin` and `end`; if it is false, the panel is folded up, and `end` is due all the same.
[[nodiscard]] bool begin(const char* title, const Panel& panel);
void end();

[[nodiscard]] bool button(const char* label, double width = 0);
[[nodiscard]] bool primary_button(const char* label, double width = 0);
bool checkbox(const char* label, bool& value);
bool slider(const char* label, double& value, double low, double high, const char* format = "%.2f",
            bool logarithmic = false);
bool number(const char* label, double& value, const char* format = "%.4g");
bool choice(const char* label, int& value, std::span<const char* const> names);
bool radio(const char* label, bool chosen);
[[nodiscard]] bool row(const char* label, bool chosen);  ///< a line of a list that can be chosen
[[nodiscard]] bool section(const char* title, bool open = true);

/// A title within a panel, a quiet line of text, and a line with a colour before it.
void heading(std::string_view text);
void wrapped(std::string_view text);  ///< as many lines as the panel's width makes of it
void note(std::string_view text);
void key_colour(Colour colour, std::string_view text);

/// A quiet text at the right border, in the line of the last widget.
void at_right(std::string_view text);

/// What is told of the last widget when the pointer rests on it.
void hint(std::string_view text);

/// Remembers where the last widget is, under its label without what follows "##".
void item(const char* label);

/// The middle of the widget with this label, as it was in the last frame that had it.
[[nodiscard]] std::optional<dvec2> find_item(std::string_view label);

/// All labels of the last frame, for messages.
[[nodiscard]] std::string known_items();

/// Says that the window that is being drawn covers its part of the picture; `begin` does so by itself.
void covers();

/// The part of a picture of this size that no panel of the last frame covers and that has most room for something to
/// look at; all of it if there is none.
[[nodiscard]] Area uncovered(const ivec2& size);

/// Called by the adapter when a frame begins.
void forget_items();

}  // namespace surefoot::view::ui
