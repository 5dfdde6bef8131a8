// Which point of a segment or of a triangle is deepest in a shape, or nearest to it. All in the shape's frame, with the
// reference point at the origin. Closed forms; where a shape is flat and many points are as deep, one in their middle.
#pragma once

#include <surefoot/shapes.hpp>

#include "vec.hpp"

namespace surefoot::internal {

/// `margin`: how far outside counts as in touch [m].
[[nodiscard]] Vec deepest_on_segment(const Shape& shape, const Vec& a, const Vec& b, double margin) noexcept;
[[nodiscard]] Vec deepest_on_triangle(const Shape& shape, const Vec (&corners)[3], double margin) noexcept;

/// The point of the cone that is nearest to p.
[[nodiscard]] Vec nearest_in_cone(const Cone& cone, const Vec& p) noexcept;

/// How far outside the shape a point is, by a measure that is 0 on its surface, at most the distance outside and
/// negative inside [m].
[[nodiscard]] double outside_by(const Shape& shape, const Vec& point) noexcept;

/// How far outside the shape a point is at most; 0 or less is inside. Very much larger than the truth for slender
/// shapes [m].
[[nodiscard]] double at_most_outside_by(const Shape& shape, const Vec& point) noexcept;

}  // namespace surefoot::internal
