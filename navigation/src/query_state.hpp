// What a query keeps: Detour's search, and room for its answers.
#pragma once

#include <DetourNavMeshQuery.h>
#include <cmath>
#include <memory>
#include <vector>

#include <surefoot/navigation_query.hpp>

#include "funnel.hpp"
#include "mesh_state.hpp"
#include "pieces.hpp"

namespace surefoot::navigation {

struct NavQueryFreed {
    void operator()(dtNavMeshQuery* query) const { dtFreeNavMeshQuery(query); }
};

using DetourQuery = std::unique_ptr<dtNavMeshQuery, NavQueryFreed>;

/// Throws `std::bad_alloc`.
[[nodiscard]] DetourQuery make_detour_query(const dtNavMesh& mesh, std::size_t most_nodes);
/// Is it a place that floats can square?
[[nodiscard]] inline bool is_place(const dvec3& v) {
    return std::abs(v.x) <= largest_coordinate && std::abs(v.y) <= largest_coordinate &&
           std::abs(v.z) <= largest_coordinate;
}

struct QueryState {
    const NavigationMesh* mesh = nullptr;
    DetourQuery detour;
    dtQueryFilter filter;
    std::size_t most_nodes = 0;
    std::uint16_t shut = closed | taken_out;  ///< flags of polygons that are no ground to it
    Pieces pieces;                            ///< what `random` draws from,
    std::uint64_t pieces_of = 0;              ///< as it was at this number of `MeshState::changes`
    NavigationPoint search_from;
    NavigationPoint search_to;

    [[nodiscard]] const MeshState& ground() const { return mesh->state(); }
    [[nodiscard]] const Frame& frame() const { return mesh->state().plan.frame; }
    /// Costs and doors as they are now.
    void refresh_filter();
    [[nodiscard]] bool is_open(const dtPoly& polygon) const { return navigation::is_open(polygon, shut); }
    [[nodiscard]] bool knows(NavigationPolygon polygon) const;
    /// A search, as `NavigationQuery::begin_search` and what follows it.
    [[nodiscard]] bool begin(const NavigationPoint& from, const NavigationPoint& to);
    bool advance(std::size_t rounds);
    [[nodiscard]] std::optional<NavigationPath> finish();
    [[nodiscard]] NavigationPoint point(dtPolyRef polygon, const float* place) const;
};

/// What lies between two polygons that follow each other, in the frame; for a link the point where it is stepped on or
/// off. Nothing if they do not touch.
[[nodiscard]] std::optional<Portal> portal_between(const dtNavMesh& detour, dtPolyRef from, dtPolyRef to);

/// All polygons that can be got to from one, itself first; links among them. `shut`: flags over which no way leads.
[[nodiscard]] std::vector<dtPolyRef> reachable(const dtNavMesh& detour, dtPolyRef from, std::uint16_t shut);

/// The path along these polygons, pulled tight.
[[nodiscard]] NavigationPath path_along(const QueryState& state, std::span<const dtPolyRef> polygons,
                                        const NavigationPoint& from, const NavigationPoint& to);

}  // namespace surefoot::navigation
