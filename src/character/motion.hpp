// Velocity and way over a tick in closed form, so that they do not depend on how time is cut into ticks.
#pragma once

#include <surefoot/math.hpp>

#include "vec.hpp"

namespace surefoot::internal {

struct Travel {
    Vec velocity;  ///< at the end [m/s]
    Vec way;       ///< gone in between [m]
};

/// From `velocity` towards `wish` at a constant acceleration until it is reached, then at that [s, m/s, m/s^2].
[[nodiscard]] Travel accelerate(const Vec& velocity, const Vec& wish, double acceleration, double seconds) noexcept;

struct Flight {
    double speed;  ///< upwards, at the end [m/s]
    double rise;   ///< [m]
};

/// Straight up or down under gravity: `rising` while the speed is upwards, `falling` after that, until `terminal`.
[[nodiscard]] Flight fly(double speed, double rising, double falling, double terminal, double seconds) noexcept;

/// A user's own vector, if all its numbers are some; else zero.
[[nodiscard]] Vec finite_or_none(const dvec3& v) noexcept;

}  // namespace surefoot::internal
