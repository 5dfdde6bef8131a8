// On which side of a triangle's plane is a point? Decided exactly.
#pragma once

#include <surefoot/math.hpp>

namespace surefoot::internal {

/// The sign of (p - a) . (b - a) x (c - a): 1 in front, -1 behind, 0 on the plane and for a triangle without area.
/// Requires: all coordinates are finite.
int side_of_plane(const Triangle& triangle, const dvec3& p) noexcept;

}  // namespace surefoot::internal
