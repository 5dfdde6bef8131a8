/// From where a lesson is seen when it begins.
#pragma once

#include <surefoot/math.hpp>

namespace surefoot::playground {

inline constexpr double lesson_yaw = 0.62;    ///< [rad]
inline constexpr double lesson_pitch = 0.36;  ///< [rad]

/// To the right, and towards the eye, as seen from there.
inline constexpr dvec3 rightwards{0.814, 0, -0.581};
inline constexpr dvec3 eyewards{0.581, 0, 0.814};

}  // namespace surefoot::playground
