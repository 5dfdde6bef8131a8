// A shape made a little larger, so that it covers what is not known exactly about its place.
#pragma once

#include <surefoot/shapes.hpp>

#include "vec.hpp"

namespace surefoot::internal {

struct GrownShape {
    Shape shape;          ///< contains every point within `by` of the shape it was made from
    double drop = 0;      ///< how far its reference point lies below the old one, along its own -Y [m]
    double overhang = 0;  ///< how far it reaches beyond the old one at most [m]
};

/// Requires: a valid shape, `by` >= 0. With 0 it is the shape itself, to the last bit.
[[nodiscard]] GrownShape grown(const Shape& shape, double by) noexcept;

/// How fast the surface of a shape that turns about an axis through its reference point moves along its own normals, at
/// most [m per radian]: 0 for a sphere, or for a capsule about its own axis. `axis` is in the shape's frame and of unit
/// length.
[[nodiscard]] double turning_reach(const Shape& shape, const Vec& axis) noexcept;

}  // namespace surefoot::internal
