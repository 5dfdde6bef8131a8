// The body of a character, turned to its `up` and measured.
#pragma once

#include <surefoot/shapes.hpp>

#include "frame.hpp"
#include "query/reach.hpp"
#include "vec.hpp"

namespace surefoot::internal {

/// An upright body as the questions of a step need it: the volume kept off by the skin, and the box around it.
struct Body {
    Volume volume;                   ///< as the user gave it, turned to `up`
    Volume kept_off;                 ///< grown by the skin
    Vec shift;                       ///< from the position to the reference point of `kept_off` [m]
    Box3 extent;                     ///< the box around `kept_off`, relative to the position [m]
    Frame frame{dquat(1, 0, 0, 0)};  ///< of both
    Vec middle;                      ///< from the position to the middle of the volume [m]
    bool is_sharp = false;           ///< has edges or corners: planes of many directions may touch it at one point
    double half_width;               ///< the largest horizontal reach of the volume from its axis [m]
    double foot;                     ///< how far the lowest point of `kept_off` is from the position, along -up [m]

    [[nodiscard]] double size() const noexcept { return largest(extent.max - extent.min); }

    /// The box around the body on its way from `from` by `motion`, and `margin` more on all sides [m].
    [[nodiscard]] Box3 around(const Vec& from, const Vec& motion, double margin) const noexcept;
};

/// `up` is of unit length. Requires: a valid volume.
[[nodiscard]] Body body_of(const Volume& volume, double skin, const Vec& up) noexcept;

/// A volume that is upright where up is +Y, turned to `up`, which is of unit length.
[[nodiscard]] Volume turned_to(const Volume& volume, const Vec& up) noexcept;

/// Two directions across `up` and each other, all of unit length.
struct Across {
    Vec one;
    Vec other;
};
[[nodiscard]] Across across(const Vec& up) noexcept;

/// How far a volume reaches from its reference point along `direction`, which is of unit length [m].
[[nodiscard]] double reach_along(const Volume& volume, const Vec& direction) noexcept;

/// The box around a volume, relative to its reference point, but for rounding.
[[nodiscard]] Box3 reach_box(const Volume& volume) noexcept;

/// The smallest dimension of a shape; the straight part of a capsule does not count [m].
[[nodiscard]] double smallest_of(const Shape& shape) noexcept;

}  // namespace surefoot::internal
