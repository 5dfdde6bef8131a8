/// The farthest point of a shape in a direction: all that is needed to find its box, a plane that touches it, or its
/// distance to a triangle.
#pragma once

#include <surefoot/bounds.hpp>
#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

namespace surefoot::debugger {

/// The point of the shape that lies farthest along `direction`, from its reference point, in the world [m].
/// Requires: `direction` is not zero.
[[nodiscard]] dvec3 farthest_point(const Volume& volume, const dvec3& direction);

/// The box around a shape at a place.
[[nodiscard]] Bounds bounds_of(const Volume& volume, const dvec3& position);

}  // namespace surefoot::debugger
