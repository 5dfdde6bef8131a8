/// A scarf's end: a chain of points that is pulled along and falls.
#pragma once

#include <array>
#include <cstddef>

#include <surefoot/math.hpp>

namespace surefoot::platformer {

inline constexpr std::size_t scarf_points = 7;

/// Places in the world [m]; the first is where it is tied.
struct Scarf {
    std::array<dvec3, scarf_points> now{};
    std::array<dvec3, scarf_points> before{};
};

/// Hangs down from `knot`, at rest.
[[nodiscard]] Scarf hanging_scarf(const dvec3& knot, const dvec3& backward);

/// On by `dt` [s]: the knot goes to `knot`; what hangs on it stays out of the ball about `middle`, and above `floor`.
/// `clock` lets it flutter. `drag` is how thick what it moves through is [1/s]: more under water.
[[nodiscard]] Scarf advance(const Scarf& scarf, const dvec3& knot, const dvec3& middle, double radius, double floor,
                            double drag, double clock, double dt);

}  // namespace surefoot::platformer
