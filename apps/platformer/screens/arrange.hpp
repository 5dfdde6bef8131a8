/// Where the entries of a menu stand. Drawing and the mouse's hand ask the same.
#pragma once

#include <vector>

#include "platformer/screens/menu.hpp"
#include "view/canvas.hpp"

namespace surefoot::platformer {

struct Arrangement {
    view::Rect page;                 ///< what is seen of the entries; the rest is scrolled to [layout units]
    std::vector<view::Rect> places;  ///< of each entry, scrolled
    double highest_scroll = 0;
};

[[nodiscard]] Arrangement arrange(const Menu& menu, const view::dvec2& size, double scroll);

/// The rail of a slider within its entry, and of a binding's row the place of its label.
[[nodiscard]] view::Rect rail_of(const view::Rect& entry);

/// How much of the page is above the entries, and below them.
inline constexpr double head_height = 108;
inline constexpr double foot_height = 64;

}  // namespace surefoot::platformer
