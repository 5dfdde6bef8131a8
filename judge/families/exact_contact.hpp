/// Contacts whose every number is exact: a point on the surface of a shape, the outward normal there and two tangents,
/// all of small integers times a power of two, under rotations that keep them so (Pythagorean triples).
#pragma once

#include "draw.hpp"

namespace judge {

struct ExactContact {
    Query query;                   ///< shape, orientation and a triangle that touches it, the reference point at `here`
    Vec here;                      ///< where the reference point touches
    Vec at;                        ///< where they touch then
    Feature part = Feature::face;  ///< the part of the triangle that is there
    Vec out;         ///< outward normal of the shape at the contact: towards the triangle, of integers times `unit`
    Vec tangent[2];  ///< perpendicular to `out`, exactly
    /// On a rim or apex, where moving along `out` may also slide along another plane of the shape.
    bool sharp = false;
    double unit = 1;  ///< a power of two
};

[[nodiscard]] ExactContact draw_contact(Draw& draw, Kind kind);

}  // namespace judge
