#include "agreement.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <unordered_set>

#include <surefoot/navigation_flood.hpp>
#include <surefoot/navigation_query.hpp>

#include "mesh_state.hpp"
#include "query_state.hpp"

namespace surefoot {
inline namespace v0 {
namespace {

using navigation::MeshState;

/// Cells of a flood by where they are.
class CellMap {
public:
    CellMap(const MeshState& state, const NavigationFlood& flood) : state_(state), side_(flood.cell) {
        for (const NavigationFloodCell& cell : flood.cells) {
            const dvec3 feet = inside(cell.feet);
            columns_[key(whole(feet.x), whole(feet.z))].push_back(feet);
        }
    }

    /// Is there a cell no farther away than its own side?
    [[nodiscard]] bool is_near(const dvec3& place) const {
        const std::int64_t x = whole(place.x);
        const std::int64_t z = whole(place.z);
        for (std::int64_t dz = -1; dz <= 1; ++dz) {
            for (std::int64_t dx = -1; dx <= 1; ++dx) {
                const auto column = columns_.find(key(x + dx, z + dz));
                if (column == columns_.end()) continue;
                for (const dvec3& feet : column->second)
                    if (std::hypot(feet.x - place.x, feet.z - place.z) <= side_ &&
                        std::abs(feet.y - place.y) < state_.plan.agent.height / 2)
                        return true;
            }
        }
        return false;
    }

private:
    [[nodiscard]] dvec3 inside(const dvec3& place) const {
        return state_.plan.frame.turned_in(place - state_.plan.frame.origin);
    }
    [[nodiscard]] std::int64_t whole(double at) const { return static_cast<std::int64_t>(std::floor(at / side_)); }
    [[nodiscard]] static std::int64_t key(std::int64_t x, std::int64_t z) { return x * 0x100000000 + z; }

    const MeshState& state_;
    double side_;
    std::unordered_map<std::int64_t, std::vector<dvec3>> columns_;
};

/// Did feet get to a polygon: near its middle, or near half-way from there to a corner?
bool is_reached(const CellMap& cells, const dtNavMeshQuery& query, dtPolyRef reference, const dtMeshTile& tile,
                const dtPoly& polygon) {
    dvec3 middle{0, 0, 0};
    const auto corner = [&](int i) {
        const float* at = &tile.verts[3 * static_cast<std::size_t>(polygon.verts[i])];
        return dvec3{at[0], at[1], at[2]};
    };
    for (int i = 0; i < polygon.vertCount; ++i) middle += corner(i) / static_cast<double>(polygon.vertCount);
    // A polygon is flat and the ground is not: its height is that of the detail.
    const auto is_near = [&](dvec3 place) {
        const vec3 asked(place);
        float height = 0;
        if (dtStatusSucceed(query.getPolyHeight(reference, &asked.x, &height))) place.y = height;
        return cells.is_near(place);
    };
    if (is_near(middle)) return true;
    for (int i = 0; i < polygon.vertCount; ++i)
        if (is_near((middle + corner(i)) * 0.5)) return true;
    return false;
}

/// All polygons from which `to` can be got to, itself among them.
std::unordered_set<dtPolyRef> leading_to(const dtNavMesh& detour, dtPolyRef to, std::uint16_t shut) {
    std::unordered_map<dtPolyRef, std::vector<dtPolyRef>> before;
    for (int i = 0; i < detour.getMaxTiles(); ++i) {
        const dtMeshTile* tile = detour.getTile(i);
        if (tile->header == nullptr) continue;
        const dtPolyRef first = detour.getPolyRefBase(tile);
        for (int p = 0; p < tile->header->polyCount; ++p) {
            if (!navigation::is_open(tile->polys[p], shut)) continue;
            for (unsigned int link = tile->polys[p].firstLink; link != DT_NULL_LINK; link = tile->links[link].next)
                before[tile->links[link].ref].push_back(first | static_cast<dtPolyRef>(p));
        }
    }
    std::unordered_set<dtPolyRef> found{to};
    std::vector<dtPolyRef> waiting{to};
    while (!waiting.empty()) {
        const dtPolyRef here = waiting.back();
        waiting.pop_back();
        for (const dtPolyRef next : before[here])
            if (found.insert(next).second) waiting.push_back(next);
    }
    return found;
}

/// Doors count as open: behind them is ground, too.
constexpr std::uint16_t shut = navigation::taken_out;

}  // namespace
}  // namespace v0

namespace navigation {

void keep_joined(NavigationMesh& mesh, const NavigationFlood& flood, const dvec3& seed,
                 NavigationAgreement& agreement) {
    const MeshState& state = mesh.state();
    const NavigationQuery query(mesh, 16, NavigationDoors::open);
    const double vertical = std::max(mesh.agent().climb, 4 * state.plan.cell_height) + mesh.agent().radius;
    const auto start = query.nearest(seed, 4 * mesh.agent().radius, mesh.agent().height);
    std::vector<NavigationPolygon> out;
    std::unordered_set<dtPolyRef> there;
    std::unordered_set<dtPolyRef> back;
    if (start) {
        for (const dtPolyRef polygon : reachable(*state.detour, start->polygon.id, shut)) there.insert(polygon);
        back = leading_to(*state.detour, start->polygon.id, shut);
    }
    agreement.kept = 0;
    each_polygon(*state.detour, [&](dtPolyRef reference, const dtMeshTile& tile, const dtPoly& polygon) {
        if (!is_open(polygon, shut)) return;
        const double area = area_of(tile, polygon);
        if (there.contains(reference) && back.contains(reference)) {
            agreement.kept += area;
            return;
        }
        agreement.no_return += area;
        out.push_back({reference});
    });
    mesh.take_out(out);

    // The mesh knows what it comes into, half a cell of the flood from the middle, or would but for the cell of its own
    // that it keeps from every edge. A mesh for a wider body has wider cells and is granted no more: else it would know
    // all the ground along walls.
    const double cell_for_feet = state.plan.cell_size * std::min(1.0, flood.radius / mesh.agent().radius);
    const double aside = flood.cell / 2 + cell_for_feet;
    constexpr std::size_t most_missing = 1000;
    agreement.flood_covered = 0;
    agreement.missing.clear();
    for (const NavigationFloodCell& cell : flood.cells) {
        if (!cell.returns) continue;
        if (query.nearest(cell.feet, aside, vertical)) {
            agreement.flood_covered += flood.cell * flood.cell;
        } else if (agreement.missing.size() < most_missing) {
            agreement.missing.push_back(cell.feet);
        }
    }
}

}  // namespace navigation

inline namespace v0 {

NavigationAgreement keep_reached(NavigationMesh& mesh, const NavigationFlood& flood, const dvec3& seed) {
    NavigationAgreement agreement{.flood = flood.area()};
    const MeshState& state = mesh.state();
    const CellMap cells(state, flood);
    const navigation::DetourQuery heights = navigation::make_detour_query(*state.detour, 16);
    std::vector<NavigationPolygon> out;
    navigation::each_polygon(*state.detour, [&](dtPolyRef reference, const dtMeshTile& tile, const dtPoly& polygon) {
        if (!navigation::is_open(polygon, shut) || is_reached(cells, *heights, reference, tile, polygon)) return;
        agreement.unreached += navigation::area_of(tile, polygon);
        out.push_back({reference});
    });
    mesh.take_out(out);
    navigation::keep_joined(mesh, flood, seed, agreement);
    return agreement;
}

}  // namespace v0
}  // namespace surefoot
