#include "playground/debugger_room/lesson_frame.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::playground {

std::pair<dvec3, double> lesson_frame(const dvec3& middle, double width, double height, const view::Display& display) {
    constexpr double half_view = 0.87 / 2;  // of the camera's height [rad]
    constexpr double panel = 460;           // with its margins, in window units for usual letters
    constexpr double filled = 0.94;
    const double all = display.size().x;
    const double high = display.size().y;
    // Where letters are large or the window is small, the panel lies over a part of it whatever one does.
    const double free = std::max(all - panel * display.scale(), all * 0.4);
    const double metre = std::min(free / width, high / height) * filled;  // in window units
    const double distance = high / (2 * std::tan(half_view) * metre);
    return {middle + rightwards * ((all - free) / 2 / metre), distance * std::sin(half_view)};
}

}  // namespace surefoot::playground
