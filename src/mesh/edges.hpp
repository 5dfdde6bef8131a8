// Which triangles share their edges, and how the surface bends there.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <surefoot/math.hpp>
#include <surefoot/query.hpp>

#include "vec.hpp"

namespace surefoot::internal {

/// The sides of triangles are numbered 3 * triangle + k, with k = 0, 1, 2 for ab, bc, ca.
struct EdgeMatches {
    static constexpr std::uint32_t none = 0xFFFFFFFF;  ///< no other triangle has this edge
    static constexpr std::uint32_t many = 0xFFFFFFFE;  ///< more than one other triangle has it
    static constexpr std::uint32_t gone = 0xFFFFFFFD;  ///< the triangle has less than three corners

    std::vector<std::uint32_t> partner;  ///< for each side the one other with the same two corners, or one of the above
};

/// Triangles with a repeated corner have no edges that others could share.
/// Requires: `corners` has three a triangle, each below `vertex_count`; corners at one place have one number; at most
/// 2^30 triangles.
[[nodiscard]] EdgeMatches match_edges(std::span<const std::uint32_t> corners, std::size_t vertex_count);

/// The kinds of the three edges of each triangle: two bits an edge, ab lowest. Corners belong together where their
/// positions are equal, whatever their indices.
///
/// Flat is what deviates from this triangle's plane by no more than `tolerance` [m, >= 0] and what float coordinates
/// cannot express anyway. A neighbour that is folded back onto the triangle is convex: the edge is a blade. An edge to
/// a triangle without area, or of one, is open. Requires: as for `match_edges`; finite vertices.
[[nodiscard]] std::vector<std::uint8_t> edge_kinds(std::span<const vec3> vertices,
                                                   std::span<const std::uint32_t> indices, double tolerance = 0);

/// The same for edges that are matched already.
[[nodiscard]] std::vector<std::uint8_t> edge_kinds(std::span<const Vec> vertices,
                                                   std::span<const std::uint32_t> indices, const EdgeMatches& matches,
                                                   double tolerance);

constexpr EdgeKind edge_kind(std::uint8_t kinds, unsigned edge) noexcept {
    return static_cast<EdgeKind>((kinds >> (2 * edge)) & 3U);
}

}  // namespace surefoot::internal
