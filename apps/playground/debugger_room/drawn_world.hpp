/// Two worlds side by side: the real one, and the one that is on its way to squashed space.
#pragma once

#include <optional>
#include <span>

#include <surefoot/bounds.hpp>

#include "debugger/squash.hpp"

namespace surefoot::playground {

/// A world to draw into.
struct DrawnWorld {
    debugger::Squash squash{};  ///< changes nothing in the real one
    dvec3 offset{0, 0, 0};      ///< where it stands, seen from the real one [m]
    Volume volume{};            ///< the shape as it is there

    [[nodiscard]] dvec3 point(const dvec3& p) const { return squash.point(p) + offset; }
};

[[nodiscard]] DrawnWorld real_world(const Volume& volume);

/// At `s`, 0 the world and 1 squashed space, about START. Requires: a sphere or an ellipsoid, 0 <= s <= 1.
[[nodiscard]] DrawnWorld world_beside(const Volume& volume, const Motion& motion, double s, const dvec3& offset);

/// Everything of the question in a world: the shape at START and at END, the triangles, and what is lit around them,
/// which reaches as far as the shape would at each corner.
[[nodiscard]] Bounds bounds_in(const DrawnWorld& world, const Motion& motion, std::span<const Triangle> triangles);

/// Where the world beside has to stand so that at no `s` it meets the real one: beneath it, or above a level. The same
/// for every `s`, so that what moves is the squashing alone.
[[nodiscard]] dvec3 offset_beside(const Volume& volume, const Motion& motion, std::span<const Triangle> triangles,
                                  const std::optional<Bounds>& level = std::nullopt);

}  // namespace surefoot::playground
