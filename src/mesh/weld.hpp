// Vertices that are at the same place.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <surefoot/math.hpp>

namespace surefoot::internal {

/// For each vertex the lowest index of a vertex at exactly its place; 0 and -0 are one place. O(n log n) at worst.
/// Requires: no NaN, fewer than 2^32 vertices.
[[nodiscard]] std::vector<std::uint32_t> same_places(std::span<const vec3> vertices);
[[nodiscard]] std::vector<std::uint32_t> same_places(std::span<const dvec3> vertices);

}  // namespace surefoot::internal
