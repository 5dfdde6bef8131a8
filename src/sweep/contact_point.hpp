// Where a shape and a triangle touch, once the plane between them is known.
#pragma once

#include "sweep/planes.hpp"

namespace surefoot::internal {

struct Contact {
    Vec point;               ///< in the shape's frame, relative to `from`
    unsigned corners = 7;    ///< the corners of the part of the triangle that the plane touches (bits, canonical order)
    bool is_on_part = true;  ///< is the point on that part?
};

/// Where the shape touches the triangle at `t`: a point of the part that the plane touches or, for a shape deeper in
/// the triangle than `allowed` where this part is outside the shape, the deepest point of the triangle.
[[nodiscard]] Contact contact_of(const SweepQuery& query, const Planes& planes, const Plane& plane, double t,
                                 double allowed) noexcept;

}  // namespace surefoot::internal
