/// A ray: the sweep of a point. For line of sight, picking and bullets.
#pragma once

#include <optional>

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/sweep.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// Where does the segment from `motion.from` to `motion.to` first meet `triangle`?
///
/// Watertight: whether the segment meets the closed triangle is decided exactly, so a ray cannot slip between two
/// triangles that share an edge. Edge-on and in-plane rays meet the edges of the triangle. A ray that starts on the
/// triangle hits it at t = 0, whichever way it goes (a point has no depth to go to, so this differs from `sweep`).
/// The normal faces the ray's start; for a ray within the triangle's plane it points back along the ray.
/// `started_inside` is true when the ray starts on the triangle. A ray of no length meets nothing.
[[nodiscard]] std::optional<Hit> ray(const Motion& motion, const Triangle& triangle,
                                     const SweepOptions& options = {}) noexcept;

}  // namespace v0
}  // namespace surefoot
