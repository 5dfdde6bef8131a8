// A plane that keeps a triangle and a body apart: found once, it answers most questions about the two for a whole step.
#pragma once

#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

#include "frame.hpp"
#include "vec.hpp"

namespace surefoot::internal {

/// At the place for which it was found the body is `gap` in front of a plane with all of the triangle behind it.
/// Negative: this plane does not keep them apart there.
struct Separation {
    Vec normal;      ///< in the world, unit, from the triangle towards the body
    double gap = 0;  ///< [m]
};

/// The widest gap among a few likely planes: the triangle's own, the one at its point that is nearest in squashed
/// space, and for flat shapes the one of a flat side. `place` is the reference point's, `frame` that of the shape.
[[nodiscard]] Separation separation_of(const Shape& shape, const Frame& frame, const Vec& place,
                                       const Triangle& triangle) noexcept;

}  // namespace surefoot::internal
