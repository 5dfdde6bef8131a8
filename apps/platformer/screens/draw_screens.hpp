/// Draws the screen on top, over whatever is behind it.
#pragma once

#include "platformer/screens/screens.hpp"
#include "view/canvas.hpp"

namespace surefoot::platformer {

/// `seconds` run on while the program does; with less motion nothing depends on them.
void draw_screens(view::Canvas& canvas, const Screens& screens, double seconds);

/// What is written on a key, as the key. Returns how wide it is; `left` is in the middle of its height.
double draw_key_cap(view::Canvas& canvas, std::string_view name, const view::dvec2& left, double size,
                    double opacity = 1);
[[nodiscard]] double key_cap_width(const view::Canvas& canvas, std::string_view name, double size);

}  // namespace surefoot::platformer
