// One shape of a pair, with its orientation: a core and a ball around it. Sphere and capsule are a point and a segment
// with a ball; the others are all core.
#pragma once

#include <surefoot/shapes.hpp>

#include "frame.hpp"
#include "vec.hpp"

namespace surefoot::internal {

class Placed {
public:
    explicit Placed(const Volume& volume) noexcept;

    [[nodiscard]] const Shape& shape() const noexcept { return shape_; }
    [[nodiscard]] const Frame& frame() const noexcept { return frame_; }
    [[nodiscard]] Vec axis() const noexcept { return frame_.to_world({0, 1, 0}); }

    /// Of the ball around the core; 0 for most shapes.
    [[nodiscard]] double radius() const noexcept { return radius_; }

    /// No point of the shape is farther from its reference point than this, nor less than half of it on its far side.
    [[nodiscard]] double size() const noexcept { return size_; }

    /// The core's point farthest along `n` (any length), relative to the reference point, in the world.
    [[nodiscard]] Vec farthest(const Vec& n) const noexcept;

    /// How far the whole shape reaches along a unit `n` from its reference point.
    [[nodiscard]] double reach(const Vec& n) const noexcept { return dot(n, farthest(n)) + radius_; }

    /// The core's point closest to `p`, relative to the reference point. Requires: not an ellipsoid, not a cone.
    [[nodiscard]] Vec closest_of_core(const Vec& p) const noexcept;

private:
    Shape shape_;
    Frame frame_;
    double radius_ = 0;
    double size_ = 0;
};

/// Two shapes, the second at the origin. `x` is where the first one's reference point is.
struct PlacedPair {
    Placed a;
    Placed b;

    /// The gap that a plane of unit normal `n` (from b to a) proves; negative if it cuts into them.
    [[nodiscard]] double gap_along(const Vec& n, const Vec& x) const noexcept {
        return dot(n, x) - b.reach(n) - a.reach(-n);
    }
};

/// What is known of the distance when the first shape is at some `x`: a plane that proves `least`, and a pair of points
/// that shows it to be no more than `most`. Negative inside.
struct Gap {
    double least = 0;
    double most = 0;
    Vec normal;            ///< unit, from b to a
    bool is_deep = false;  ///< the cores overlap and this family does not know how deep: least and most are too high
};

}  // namespace surefoot::internal
