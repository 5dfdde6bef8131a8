// Where a shape and a triangle touch, once the plane between them is known.
#pragma once

#include "sweep/planes.hpp"

namespace surefoot::internal {

struct Contact {
    Vec point;             ///< in the shape's frame, relative to `from`
    unsigned corners = 7;  ///< which corners of the triangle span the part that holds the point (bits, canonical order)
};

/// A point of the triangle where the shape touches it at `t`, and the part of the triangle it is on: where the plane
/// touches the triangle, or, for a shape so deep in the triangle that this is outside the shape, the deepest point.
[[nodiscard]] Contact contact_of(const SweepQuery& query, const Planes& planes, const Plane& plane, double t) noexcept;

}  // namespace surefoot::internal
