// Where a shape and a triangle touch, once the plane between them is known.
#pragma once

#include "sweep/planes.hpp"

namespace surefoot::internal {

/// A point of the triangle where it touches the shape, in the shape's frame relative to `from`. `moved` is where the
/// reference point is at the touch, in the same frame; `normal` the plane between them.
[[nodiscard]] Vec contact_point(const SweepQuery& query, const Vec& moved, const Vec& normal) noexcept;

}  // namespace surefoot::internal
