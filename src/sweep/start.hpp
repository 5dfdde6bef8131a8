// The start of a motion that begins in touch: would the shape go deeper? Decided by the exact sign of g'(0+), g the
// signed distance between shape and triangle. g' is the largest of n . d over the normals n that attain the distance.
#pragma once

#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

namespace surefoot::internal {

enum class Approach {
    deeper,     ///< g'(0+) < 0
    no_closer,  ///< g'(0+) >= 0: leaving, sliding along, or standing still
    overflow,   ///< the numbers are further apart than exact arithmetic has room for
};

/// Requires: valid volume, motion and triangle. Exact for a shape that touches the triangle at `from`. For one that is
/// apart, `no_closer` means that the motion is proved to miss; box, cylinder and cone may say `deeper` without a proof.
[[nodiscard]] Approach approach_at_start(const Volume& volume, const Motion& motion, const Triangle& triangle) noexcept;

/// The sign of (to - from) . N, N the normal of the triangle.
[[nodiscard]] Approach approach_to_front(const Motion& motion, const Triangle& triangle) noexcept;

}  // namespace surefoot::internal
