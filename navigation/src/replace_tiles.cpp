#include <algorithm>

#include "mesh_state.hpp"

namespace surefoot::navigation {
namespace {

bool is_among(std::span<const TileMesh> tiles, const MeshState& state, const dvec3& place) {
    const std::size_t at = state.tile_at(state.plan.frame.in(place));
    return std::any_of(tiles.begin(), tiles.end(),
                       [&](const TileMesh& tile) { return state.tile_index(tile.x, tile.z) == at; });
}

}  // namespace

std::optional<Error> replace_tiles(MeshState& state, std::vector<TileMesh> tiles) {
    const auto most = static_cast<std::size_t>(state.detour->getParams()->maxPolys);
    for (const TileMesh& tile : tiles)
        if (tile.areas.size() > most)
            return Error{.code = ErrorCode::limit,
                         .text = "navigation, tile " + std::to_string(tile.x) + ", " + std::to_string(tile.z) +
                                 ": has " + std::to_string(tile.areas.size()) + " polygons, and this mesh can name " +
                                 std::to_string(most) + "; build it anew",
                         .file = {}};
    // Connections know their links by number: a link that goes leaves its number to nobody, so that tiles which were
    // not built anew stay as they are.
    for (int i = 0; i < state.detour->getMaxTiles(); ++i) {
        const dtMeshTile* tile = static_cast<const dtNavMesh&>(*state.detour).getTile(i);
        if (tile->header == nullptr) continue;
        for (int c = 0; c < tile->header->offMeshConCount; ++c) {
            const NavigationLink& link = state.links[tile->offMeshCons[c].userId];
            if (is_among(tiles, state, link.to) || is_among(tiles, state, link.from))
                state.detour->setPolyFlags(state.detour->getPolyRefBase(tile) | tile->offMeshCons[c].poly, 0);
        }
    }
    ++state.changes;
    for (TileMesh& tile : tiles) {
        if (auto put = put_tile(state, tile, Connect::nothing); !put) return put.error();
        if (!state.tile_meshes.empty()) state.tile_meshes[state.tile_index(tile.x, tile.z)] = std::move(tile);
    }
    return std::nullopt;
}

}  // namespace surefoot::navigation
