#include <DetourNavMeshBuilder.h>
#include <algorithm>
#include <bit>
#include <cmath>

#include "mesh_state.hpp"

namespace surefoot::navigation {
namespace {

// Detour keeps so many bits of a reference for telling an old tile from the one that took its place.
constexpr int salt_bits = 10;
constexpr int name_bits = 32 - salt_bits;

int bits_for(std::size_t count) {
    return static_cast<int>(std::bit_width(std::max<std::size_t>(count, 2) - 1));
}

/// Links that begin in a tile, as Detour takes them.
struct Connections {
    std::vector<float> ends;
    std::vector<float> radii;
    std::vector<unsigned short> flags;
    std::vector<unsigned char> areas;
    std::vector<unsigned char> directions;
    std::vector<unsigned int> ids;
};

Connections connections_from(const MeshState& state, std::size_t tile) {
    Connections all;
    for (std::size_t i = 0; i < state.links.size(); ++i) {
        const NavigationLink& link = state.links[i];
        const vec3 from = state.plan.frame.in(link.from);
        if (state.tile_at(from) != tile) continue;
        const vec3 to = state.plan.frame.in(link.to);
        all.ends.insert(all.ends.end(), {from.x, from.y, from.z, to.x, to.y, to.z});
        all.radii.push_back(static_cast<float>(state.plan.agent.radius));
        all.flags.push_back(walkable);
        all.areas.push_back(detour_area(0));
        all.directions.push_back(0);
        all.ids.push_back(static_cast<unsigned int>(i));
    }
    return all;
}

void set_ground(dtNavMeshCreateParams& params, const TileMesh& tile, const std::vector<std::uint16_t>& flags) {
    params.verts = tile.vertices.data();
    params.vertCount = static_cast<int>(tile.vertices.size() / 3);
    params.polys = tile.polygons.data();
    params.polyFlags = flags.data();
    params.polyAreas = tile.areas.data();
    params.polyCount = static_cast<int>(tile.areas.size());
    params.nvp = corners_per_polygon;
    params.detailMeshes = tile.detail_meshes.data();
    params.detailVerts = tile.detail_vertices.data();
    params.detailVertsCount = static_cast<int>(tile.detail_vertices.size() / 3);
    params.detailTris = tile.detail_triangles.data();
    params.detailTriCount = static_cast<int>(tile.detail_triangles.size() / 4);
    params.tileX = tile.x;
    params.tileY = tile.z;
    for (int axis = 0; axis < 3; ++axis) {
        params.bmin[axis] = tile.min[axis];
        params.bmax[axis] = tile.max[axis];
    }
    params.buildBvTree = true;
}

void set_connections(dtNavMeshCreateParams& params, const Connections& connections) {
    params.offMeshConVerts = connections.ends.data();
    params.offMeshConRad = connections.radii.data();
    params.offMeshConFlags = connections.flags.data();
    params.offMeshConAreas = connections.areas.data();
    params.offMeshConDir = connections.directions.data();
    params.offMeshConUserID = connections.ids.data();
    params.offMeshConCount = static_cast<int>(connections.ids.size());
}

}  // namespace

std::size_t MeshState::tile_at(const vec3& place) const {
    const auto along = [&](float at, std::int32_t count) {
        const int tile = static_cast<int>(std::floor(at / static_cast<float>(plan.tile_size)));
        return std::clamp(tile, 0, count - 1);
    };
    return tile_index(along(place.x, plan.tiles_x), along(place.z, plan.tiles_z));
}

bool MeshState::are_near(const dvec3& from, const dvec3& to) const {
    const auto a = static_cast<std::int64_t>(tile_at(plan.frame.in(from)));
    const auto b = static_cast<std::int64_t>(tile_at(plan.frame.in(to)));
    return std::abs(a % plan.tiles_x - b % plan.tiles_x) <= 1 && std::abs(a / plan.tiles_x - b / plan.tiles_x) <= 1;
}

Expected<DetourMesh> make_detour(const Plan& plan, std::size_t most_polygons) {
    const int tile_bits = bits_for(static_cast<std::size_t>(plan.tiles_x) * static_cast<std::size_t>(plan.tiles_z));
    const int polygon_bits = name_bits - tile_bits;
    if (bits_for(most_polygons) > polygon_bits)
        return tl::unexpected(Error{.code = ErrorCode::limit,
                                    .text = "navigation: a tile has " + std::to_string(most_polygons) +
                                            " polygons and links, and with " + std::to_string(plan.tiles_x) + " x " +
                                            std::to_string(plan.tiles_z) + " tiles a reference of 32 bits can name " +
                                            std::to_string(1 << polygon_bits) + " in each; take other `tile_cells`",
                                    .file = {}});
    dtNavMeshParams params{};
    params.tileWidth = params.tileHeight = static_cast<float>(plan.tile_size);
    params.maxTiles = 1 << tile_bits;
    params.maxPolys = 1 << polygon_bits;
    DetourMesh detour(dtAllocNavMesh());
    if (!detour || dtStatusFailed(detour->init(&params)))
        return tl::unexpected(Error{.code = ErrorCode::out_of_memory, .text = "navigation: out of memory", .file = {}});
    return detour;
}

Expected<void> put_tile(MeshState& state, const TileMesh& tile, Connect connect) {
    dtNavMesh& detour = *state.detour;
    ++state.changes;
    if (const dtTileRef old = detour.getTileRefAt(tile.x, tile.z, 0)) detour.removeTile(old, nullptr, nullptr);
    if (tile.is_empty()) return {};

    std::vector<std::uint16_t> flags;
    for (const std::uint8_t area : tile.areas)
        flags.push_back(state.areas[area - 1U].closed ? walkable | closed : walkable);
    const Connections connections =
        connect == Connect::links ? connections_from(state, state.tile_index(tile.x, tile.z)) : Connections{};
    dtNavMeshCreateParams params{};
    set_ground(params, tile, flags);
    set_connections(params, connections);
    params.walkableHeight = static_cast<float>(state.plan.agent.height);
    params.walkableRadius = static_cast<float>(state.plan.agent.radius);
    params.walkableClimb = static_cast<float>(state.plan.agent.climb);
    params.cs = static_cast<float>(state.plan.cell_size);
    params.ch = static_cast<float>(state.plan.cell_height);
    unsigned char* data = nullptr;
    int size = 0;
    const auto failed = [&](const char* what) {
        return tl::unexpected(Error{.code = ErrorCode::limit,
                                    .text = "navigation, tile " + std::to_string(tile.x) + ", " +
                                            std::to_string(tile.z) + ": " + what +
                                            "; take smaller tiles or larger cells",
                                    .file = {}});
    };
    if (tile.areas.size() + connections.ids.size() > static_cast<std::size_t>(detour.getParams()->maxPolys))
        return failed("has more polygons and links than a reference can name");
    if (!dtCreateNavMeshData(&params, &data, &size)) return failed("has more corners than 16 bits can name");
    if (dtStatusFailed(detour.addTile(data, size, DT_TILE_FREE_DATA, 0, nullptr))) {
        dtFree(data);
        return failed("does not fit into memory");
    }
    return {};
}

}  // namespace surefoot::navigation
