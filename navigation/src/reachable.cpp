#include <algorithm>
#include <unordered_set>

#include "query_state.hpp"

namespace surefoot::navigation {

std::vector<dtPolyRef> reachable(const dtNavMesh& detour, dtPolyRef from, std::uint16_t shut) {
    std::vector<dtPolyRef> found{from};
    std::unordered_set<dtPolyRef> known{from};
    for (std::size_t i = 0; i < found.size(); ++i) {
        const dtMeshTile* tile = nullptr;
        const dtPoly* polygon = nullptr;
        detour.getTileAndPolyByRefUnsafe(found[i], &tile, &polygon);
        for (unsigned int link = polygon->firstLink; link != DT_NULL_LINK; link = tile->links[link].next) {
            const dtPolyRef next = tile->links[link].ref;
            const dtMeshTile* next_tile = nullptr;
            const dtPoly* next_polygon = nullptr;
            if (next == 0 || dtStatusFailed(detour.getTileAndPolyByRef(next, &next_tile, &next_polygon))) continue;
            if (!is_open(*next_polygon, shut) || !known.insert(next).second) continue;
            found.push_back(next);
        }
    }
    return found;
}

}  // namespace surefoot::navigation
