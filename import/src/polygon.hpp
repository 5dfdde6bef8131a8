/// A face with any number of corners becomes triangles.
#pragma once

#include <chrono>
#include <cstdint>
#include <span>
#include <vector>

#include <surefoot/math.hpp>

namespace surefoot::internal {

using Deadline = std::chrono::steady_clock::time_point;

enum class PolygonCut : std::uint8_t {
    fan,        ///< (0,1,2), (0,2,3), ...: every triangle faces the polygon's way
    ears,       ///< concave as seen from corner 0: ears were clipped
    crossed,    ///< no ear was left to clip: the rest is a fan
    timed_out,  ///< the deadline passed; the triangles are not complete
};

/// Writes n - 2 triangles, as positions in `corners`, into `triangles` (which is cleared first).
/// Requires: at least three corners. Takes O(n) for a fan, O(n^2) as a rule and O(n^3) at worst for ears.
[[nodiscard]] PolygonCut cut_polygon(std::span<const vec3> corners, Deadline deadline,
                                     std::vector<std::uint32_t>& triangles);

/// No area, as far as a double can tell: corners that coincide or lie in line.
[[nodiscard]] bool is_degenerate(const vec3& a, const vec3& b, const vec3& c) noexcept;

}  // namespace surefoot::internal
