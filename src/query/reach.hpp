// Which part of space a query can have to do with, rounded outwards: sources look for triangles there.
#pragma once

#include <surefoot/shapes.hpp>

#include "vec.hpp"

namespace surefoot::internal {

struct Box3 {
    Vec min;
    Vec max;

    void include(const Vec& p) noexcept {
        min = {smaller(min.x, p.x), smaller(min.y, p.y), smaller(min.z, p.z)};
        max = {larger(max.x, p.x), larger(max.y, p.y), larger(max.z, p.z)};
    }
    void include(const Box3& box) noexcept {
        include(box.min);
        include(box.max);
    }
    /// Touching counts.
    [[nodiscard]] bool meets(const Box3& box) const noexcept {
        return min.x <= box.max.x && box.min.x <= max.x && min.y <= box.max.y && box.min.y <= max.y &&
               min.z <= box.max.z && box.min.z <= max.z;
    }
};

[[nodiscard]] inline Box3 box_of(const Triangle& triangle) noexcept {
    Box3 box{to_vec(triangle.a), to_vec(triangle.a)};
    box.include(to_vec(triangle.b));
    box.include(to_vec(triangle.c));
    return box;
}

/// How far the volume extends from its reference point along each axis of the world (min is negative or zero, max
/// positive or zero), and a margin that is a few thousand times the rounding of a sweep among coordinates of up to
/// `magnitude` [m]: a triangle may be asked for nothing, never be passed over.
/// Requires: a valid volume.
[[nodiscard]] Box3 extent_of(const Volume& volume, double magnitude) noexcept;

/// That margin [m].
[[nodiscard]] double margin_of(const Volume& volume, double magnitude) noexcept;

/// The same for a point.
[[nodiscard]] Box3 extent_of_point(double magnitude) noexcept;

/// The box around the whole of a motion.
/// Requires: `extent` from extent_of.
[[nodiscard]] Box3 swept_box(const Box3& extent, const Motion& motion) noexcept;

/// The largest of |x|, |y|, |z| of anything in the box.
[[nodiscard]] inline double magnitude_of(const Box3& box) noexcept {
    return larger(largest(box.min), largest(box.max));
}
[[nodiscard]] inline double magnitude_of(const Motion& motion) noexcept {
    return larger(largest(to_vec(motion.from)), largest(to_vec(motion.to)));
}

}  // namespace surefoot::internal
