// What a navigation mesh is made of: Detour's tiles, what they were made from, and ours beside them.
#pragma once

#include <DetourNavMesh.h>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <surefoot/navigation_mesh.hpp>
#include <surefoot/private_section.hpp>

#include "plan.hpp"
#include "tile_mesh.hpp"

namespace surefoot::navigation {

struct NavMeshFreed {
    void operator()(dtNavMesh* mesh) const { dtFreeNavMesh(mesh); }
};

using DetourMesh = std::unique_ptr<dtNavMesh, NavMeshFreed>;

/// Flags of Detour's polygons: a filter wants the first and none of the others.
inline constexpr std::uint16_t walkable = 1;
inline constexpr std::uint16_t closed = 2;     ///< of an area that is closed
inline constexpr std::uint16_t taken_out = 4;  ///< by `NavigationMesh::take_out`

/// Does a path go over it, for which these flags are what shuts?
[[nodiscard]] inline bool is_open(const dtPoly& polygon, std::uint16_t shut = closed | taken_out) {
    return (polygon.flags & walkable) != 0 && (polygon.flags & shut) == 0;
}

struct MeshState {
    Plan plan;
    std::vector<NavigationArea> areas;
    std::vector<NavigationLink> links;
    /// By tile, x first. Empty for a mesh that was opened; Detour's tiles alone serve queries.
    std::vector<TileMesh> tile_meshes;
    /// What Detour's tiles lie in where a file was mapped, and where bytes were read; else Detour owns them.
    std::optional<PrivateSection> section;
    std::vector<std::byte> bytes;
    DetourMesh detour;
    double seconds = 0;
    std::uint64_t changes = 1;       ///< counts whatever changes what queries answer
    std::uint64_t link_changes = 1;  ///< counts what gives other numbers to links

    [[nodiscard]] std::size_t tile_index(int x, int z) const {
        return static_cast<std::size_t>(z) * static_cast<std::size_t>(plan.tiles_x) + static_cast<std::size_t>(x);
    }
    /// Which tile a place of the frame lies in, clamped to the grid.
    [[nodiscard]] std::size_t tile_at(const vec3& place) const;
    /// Do two places of the world lie in one tile, or in tiles that touch? Detour joins no others by a link.
    [[nodiscard]] bool are_near(const dvec3& from, const dvec3& to) const;
};

/// An empty Detour mesh for the plan. Fails with `limit` when references of 32 bits cannot name what it needs.
[[nodiscard]] Expected<DetourMesh> make_detour(const Plan& plan, std::size_t most_polygons);

/// Are all numbers of a link some that a body can have?
[[nodiscard]] bool is_sound(const NavigationLink& link);

/// Which links a tile is put in with.
enum class Connect : std::uint8_t { links, nothing };

/// Puts a tile and the links that begin in it into Detour's mesh, in place of what was there; a tile without ground
/// just goes. Detour's user id of a connection is the link's place in `MeshState::links`.
[[nodiscard]] Expected<void> put_tile(MeshState& state, const TileMesh& tile, Connect connect = Connect::links);

/// Puts tiles in place of those that were there, without the links that begin or end in them. Should one not fit, all
/// is as it was.
[[nodiscard]] std::optional<Error> replace_tiles(MeshState& state, std::vector<TileMesh> tiles);

/// Of a polygon seen from above [m^2].
[[nodiscard]] double area_of(const dtMeshTile& tile, const dtPoly& polygon);

/// The same by its name; 0 if there is no such polygon.
[[nodiscard]] double area_of(const MeshState& state, NavigationPolygon polygon);

/// Why there is no ground in a region that requires some, if it does and there is none.
[[nodiscard]] std::optional<Error> missing_ground(const MeshState& state, const NavigationRegion& region);

/// Tells every polygon, links included, its new flags.
template <typename NewFlags>
void change_flags(dtNavMesh& detour, const NewFlags& new_flags) {
    for (int i = 0; i < detour.getMaxTiles(); ++i) {
        const dtMeshTile* tile = static_cast<const dtNavMesh&>(detour).getTile(i);
        if (tile->header == nullptr) continue;
        const dtPolyRef first = detour.getPolyRefBase(tile);
        for (int polygon = 0; polygon < tile->header->polyCount; ++polygon)
            detour.setPolyFlags(first | static_cast<dtPolyRef>(polygon), new_flags(tile->polys[polygon]));
    }
}

/// Calls `visit(reference, tile, polygon)` for every polygon of ground.
template <typename Visit>
void each_polygon(const dtNavMesh& detour, const Visit& visit) {
    for (int i = 0; i < detour.getMaxTiles(); ++i) {
        const dtMeshTile* tile = detour.getTile(i);
        if (tile->header == nullptr) continue;
        const dtPolyRef first = detour.getPolyRefBase(tile);
        for (int polygon = 0; polygon < tile->header->offMeshBase; ++polygon)
            visit(first | static_cast<dtPolyRef>(polygon), *tile, tile->polys[polygon]);
    }
}

}  // namespace surefoot::navigation
