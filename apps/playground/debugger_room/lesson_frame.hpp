/// Where a camera stands to look at a lesson: so that all of it is seen beside the panel that tells about it.
#pragma once

#include <utility>

#include <surefoot/math.hpp>

#include "view/display.hpp"

namespace surefoot::playground {

/// To the right, and towards the eye, as seen from where one stands when a lesson begins.
inline constexpr dvec3 rightwards{0.814, 0, -0.581};
inline constexpr dvec3 eyewards{0.581, 0, 0.814};

/// A ball for `Panel::scene_frame`, for a scene around `middle` that is so wide and high as seen from there [m].
[[nodiscard]] std::pair<dvec3, double> lesson_frame(const dvec3& middle, double width, double height,
                                                    const view::Display& display);

}  // namespace surefoot::playground
