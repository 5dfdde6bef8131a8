// From the triangles of a tile to convex polygons: Recast's way, with a rule of our own for what an agent's width
// keeps it away from.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <surefoot/error.hpp>
#include <surefoot/navigation_build.hpp>

#include "plan.hpp"

namespace surefoot::navigation {

/// A tile as Recast leaves it and as Detour takes it, before links are put into it. Empty without ground.
struct TileMesh {
    std::int32_t x = 0;
    std::int32_t z = 0;
    vec3 min{0, 0, 0};  ///< of the tile, in the frame [m]
    vec3 max{0, 0, 0};
    std::vector<std::uint16_t> vertices{};  ///< three a vertex [cells]
    std::vector<std::uint16_t> polygons{};  ///< `corners_per_polygon` vertices and as many neighbours each
    std::vector<std::uint8_t> areas{};      ///< one a polygon
    std::vector<std::uint32_t> detail_meshes{};
    std::vector<float> detail_vertices{};
    std::vector<std::uint8_t> detail_triangles{};

    [[nodiscard]] bool is_empty() const { return areas.empty(); }
};

inline constexpr int corners_per_polygon = 6;

/// Fails with `limit` if the tile is too high for its cells, and with `out_of_memory`.
[[nodiscard]] Expected<TileMesh> build_tile(std::span<const GroundTriangle> ground,
                                            std::span<const NavigationRegion> regions, const Plan& plan, int tile_x,
                                            int tile_z);

}  // namespace surefoot::navigation
