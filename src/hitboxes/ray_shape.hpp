// A ray against each of the six shapes, in closed form.
#pragma once

#include <optional>

#include <surefoot/shapes.hpp>

#include "vec.hpp"

namespace surefoot::internal {

struct RayTouch {
    double t = 0;         ///< [0, 1]
    Vec normal;           ///< unit, out of the shape; zero if it began inside
    bool inside = false;  ///< it began inside or on the surface; t is 0
};

/// Where the segment from `from` by `along`, both in the shape's frame, first meets the solid shape. Requires: a valid
/// shape. Right to a few roundings of the numbers that go in: a ray that grazes may be told either way within that.
[[nodiscard]] std::optional<RayTouch> ray_shape(const Shape& shape, const Vec& from, const Vec& along) noexcept;

}  // namespace surefoot::internal
