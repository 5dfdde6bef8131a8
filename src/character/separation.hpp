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

/// Finds planes between one body and many triangles: the widest gap among a few likely ones, the triangle's own, the
/// one at its point that is nearest in squashed space, and for flat shapes the one of a flat side. For a ball, squashed
/// or not, the nearest point's is the widest of all as that space measures it, and the only one.
class Separator {
public:
    /// `place` is the reference point's, `frame` that of the shape.
    Separator(const Shape& shape, const Frame& frame, const Vec& place) noexcept;

    [[nodiscard]] Separation from(const Triangle& triangle) const noexcept;

private:
    [[nodiscard]] Separation from_ball(const Triangle& triangle) const noexcept;

    const Shape& shape_;
    const Frame& frame_;
    Vec place_;
    Vec half_;        // half the extents along the shape's own axes [m]
    Vec per_half_;    // one over them
    double middle_;   // where the middle of them is, along the shape's own y [m]
    bool has_sides_;  // flat sides across its own axes
    bool is_ball_;
};

}  // namespace surefoot::internal
