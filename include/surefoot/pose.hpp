/// Where a body stands and how it is turned, and the way that it takes from one pose to the next.
#pragma once

#include <type_traits>

#include <surefoot/math.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// A place and an orientation. A point v of the body is at `position` + q v q* / |q|^2 in the world.
struct Pose {
    dvec3 position{0, 0, 0};        ///< of the body's own origin [m, each within +-1e9]
    dquat orientation{1, 0, 0, 0};  ///< w, x, y, z; of any length but zero, as that of a `Volume`
};

static_assert(std::is_trivially_copyable_v<Pose> && sizeof(Pose) == 56);

/// Is every number finite and within the limits above?
[[nodiscard]] bool is_valid(const Pose& pose) noexcept;

/// The pose at a time of a tick in which a body goes from `start` to `end`: straight, and turning by the shorter way
/// about one fixed axis. The orientation is the mix of the two unit quaternions, (1 - at) * start + at * end, so the
/// rate of turning is even to 0.1% in a tick of 6 degrees and to 3% in one of 40.
/// Requires: valid poses, `at` in [0, 1]. Guarantees: at 0 and 1 the very bits of `start` and `end`.
[[nodiscard]] Pose pose_between(const Pose& start, const Pose& end, double at) noexcept;

/// Where a point of the body is in the world [m], to rounding. Requires: a valid pose.
[[nodiscard]] dvec3 to_world(const Pose& pose, const dvec3& point) noexcept;

/// Which point of the body is at this place of the world [m], to rounding. Requires: a valid pose.
[[nodiscard]] dvec3 to_body(const Pose& pose, const dvec3& place) noexcept;

}  // namespace v0
}  // namespace surefoot
