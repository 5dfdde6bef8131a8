/// How far a shape is from a triangle while they are apart.
#pragma once

#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

namespace surefoot::debugger {

/// The distance [m]; 0 if they touch or overlap. For sphere and ellipsoid that of the shape in the world, too.
///
/// By Gilbert, Johnson and Keerthi: the nearest point of the triangle minus the shape is looked for among ever nearer
/// simplices of its farthest points, at most 200 of them. Returned is the gap along the direction found, which is
/// never more than the distance, and less by the square of what the direction lacks.
[[nodiscard]] double distance(const Volume& volume, const dvec3& position, const Triangle& triangle);

}  // namespace surefoot::debugger
