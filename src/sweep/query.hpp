// One sweep, ready to be decided: the triangle and the motion in the frame of the shape.
#pragma once

#include <cstdint>

#include <surefoot/shapes.hpp>
#include <surefoot/sweep.hpp>

#include "frame.hpp"
#include "vec.hpp"

namespace surefoot::internal {

/// Rounding, as a share of the numbers that were rounded [dimensionless]. Carrying a point into the frame and taking
/// its dot product with a unit normal costs at most 30 units of 2^-53 times |x|+|y|+|z|: a difference (1), a matrix
/// whose entries are good to 5, a dot product (3) twice, and sqrt(3) for each change between the 1-norm and the length.
/// 64 leaves room for the shape's own support function and the last rounding of t.
inline constexpr double rounding_share = 0x1p-47;

/// How much the closed forms inflate a feature before they solve for it, in hairs: so much that a motion that only
/// grazes meets the inflated feature at an angle that doubles can hold, and that no plane found this way is eaten up by
/// its own hair. The planes are then judged against the true shape.
inline constexpr double inflation = 4;

/// How much a feature is inflated, as lengths along the normal [m].
struct Hairs {
    double own = 0;       ///< the rounding in the feature's own numbers: two triangles that share it get one answer
    double triangle = 0;  ///< that in the whole triangle's: how far a plane through it may be off
};

struct SweepQuery {
    SweepQuery(const Volume& volume, const Motion& motion, const Triangle& triangle, std::uint32_t id) noexcept;

    Shape shape;
    Frame frame;
    Vec corners[3];             ///< relative to `from`, in the shape's frame, in canonical order
    double corner_slack[3];     ///< the rounding in each corner [m]
    std::uint8_t original[3];   ///< which corner of the caller's triangle each one is (0: a, 1: b, 2: c)
    Vec along;                  ///< the motion, in the shape's frame
    double shape_slack;         ///< the rounding in the shape's support function and in the motion [m]
    std::uint32_t triangle_id;  ///< for the trace

    /// Edge `i` runs from corner i to corner (i + 1) % 3 of the canonical order, always from the lesser to the greater.
    [[nodiscard]] Vec edge_start(int i) const noexcept { return corners[i == 2 ? 0 : i]; }
    [[nodiscard]] Vec edge_direction(int i) const noexcept {
        return i == 2 ? corners[2] - corners[0] : corners[i + 1] - corners[i];
    }
    [[nodiscard]] Vec face_normal() const noexcept;

    /// The rounding in a gap that this corner, or this edge, decides, and that in any gap of the triangle's.
    [[nodiscard]] Hairs corner_hairs(int i) const noexcept { return {corner_slack[i] + shape_slack, triangle_hair()}; }
    [[nodiscard]] Hairs edge_hairs(int i) const noexcept {
        return {larger(corner_slack[i == 2 ? 0 : i], corner_slack[i == 2 ? 2 : i + 1]) + shape_slack, triangle_hair()};
    }
    [[nodiscard]] double triangle_hair() const noexcept {
        return larger(corner_slack[0], larger(corner_slack[1], corner_slack[2])) + shape_slack;
    }
};

/// How far the shape reaches from its reference point against `normal`, which is in the shape's frame and of unit
/// length: the largest of -normal . k over its points k.
[[nodiscard]] double reach_against(const Shape& shape, const Vec& normal) noexcept;

/// An upper bound on |x|+|y|+|z| over the points of the shape.
[[nodiscard]] double size_of(const Shape& shape) noexcept;

}  // namespace surefoot::internal
