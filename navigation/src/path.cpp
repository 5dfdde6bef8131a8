#include <algorithm>

#include "query_state.hpp"

namespace surefoot::navigation {
namespace {

dvec3 wide(const float* place) {
    return {place[0], place[1], place[2]};
}

/// The link from a polygon to another in Detour's lists.
const dtLink* link_to(const dtMeshTile& tile, const dtPoly& polygon, dtPolyRef to) {
    for (unsigned int i = polygon.firstLink; i != DT_NULL_LINK; i = tile.links[i].next)
        if (tile.links[i].ref == to) return &tile.links[i];
    return nullptr;
}

dvec3 middle_of(const dtMeshTile& tile, const dtPoly& polygon) {
    dvec3 sum{0, 0, 0};
    for (int i = 0; i < polygon.vertCount; ++i)
        sum += wide(&tile.verts[3 * static_cast<std::size_t>(polygon.verts[i])]);
    return sum / static_cast<double>(polygon.vertCount);
}

/// A run of polygons of ground, between links.
struct Leg {
    std::size_t first = 0;
    std::size_t last = 0;
    dvec3 from{0, 0, 0};
    dvec3 to{0, 0, 0};
};

}  // namespace

std::optional<Portal> portal_between(const dtNavMesh& detour, dtPolyRef from, dtPolyRef to) {
    const dtMeshTile* from_tile = nullptr;
    const dtMeshTile* to_tile = nullptr;
    const dtPoly* from_polygon = nullptr;
    const dtPoly* to_polygon = nullptr;
    if (dtStatusFailed(detour.getTileAndPolyByRef(from, &from_tile, &from_polygon)) ||
        dtStatusFailed(detour.getTileAndPolyByRef(to, &to_tile, &to_polygon)))
        return std::nullopt;
    const dtLink* link = link_to(*from_tile, *from_polygon, to);
    if (link == nullptr) return std::nullopt;
    if (from_polygon->getType() == DT_POLYTYPE_OFFMESH_CONNECTION) {
        const dvec3 end = wide(&from_tile->verts[3 * static_cast<std::size_t>(from_polygon->verts[link->edge])]);
        return Portal{end, end};
    }
    if (to_polygon->getType() == DT_POLYTYPE_OFFMESH_CONNECTION) {
        const dtLink* back = link_to(*to_tile, *to_polygon, from);
        // One-way links are entered at their first corner.
        const std::size_t corner = back != nullptr ? back->edge : 0;
        const dvec3 begin = wide(&to_tile->verts[3 * static_cast<std::size_t>(to_polygon->verts[corner])]);
        return Portal{begin, begin};
    }
    const auto corner = [&](int i) {
        return wide(&from_tile->verts[3 * static_cast<std::size_t>(from_polygon->verts[i % from_polygon->vertCount])]);
    };
    dvec3 a = corner(link->edge);
    dvec3 b = corner(link->edge + 1);
    if (link->side != 0xff && (link->bmin != 0 || link->bmax != 255)) {
        // On a tile's border only a part of the side is shared.
        const dvec3 way = b - a;
        b = a + way * (link->bmax / 255.0);
        a = a + way * (link->bmin / 255.0);
    }
    return left_of(middle_of(*from_tile, *from_polygon), (a + b) * 0.5, a) >= 0 ? Portal{a, b} : Portal{b, a};
}

NavigationPath path_along(const QueryState& state, std::span<const dtPolyRef> polygons, const NavigationPoint& from,
                          const NavigationPoint& to) {
    const dtNavMesh& detour = *state.ground().detour;
    const Frame& frame = state.frame();
    NavigationPath path;
    std::vector<Portal> portals;
    for (const dtPolyRef polygon : polygons) path.polygons.push_back({polygon});
    for (std::size_t i = 0; i + 1 < polygons.size(); ++i) {
        const std::optional<Portal> portal = portal_between(detour, polygons[i], polygons[i + 1]);
        portals.push_back(portal.value_or(Portal{}));
    }
    const auto inside = [&](const dvec3& place) { return frame.turned_in(place - frame.origin); };
    const auto add_leg = [&](const Leg& leg) {
        path.corners.push_back({frame.out(leg.from), {polygons[leg.first]}, {}});
        const std::span<const Portal> crossed(portals.data() + leg.first, leg.last - leg.first);
        for (const FunnelCorner& bend : bends(leg.from, crossed, leg.to))
            path.corners.push_back({frame.out(bend.position), {polygons[leg.first + bend.portals_before]}, {}});
    };
    Leg leg{.first = 0, .last = 0, .from = inside(from.position), .to = {}};
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const dtOffMeshConnection* connection = detour.getOffMeshConnectionByRef(polygons[i]);
        if (connection == nullptr) continue;
        leg.last = i == 0 ? 0 : i - 1;
        leg.to = wide(connection->pos);
        add_leg(leg);
        path.corners.push_back({frame.out(leg.to), {polygons[i]}, connection->userId});
        leg = {.first = std::min(i + 1, polygons.size() - 1), .last = 0, .from = wide(connection->pos + 3), .to = {}};
    }
    leg.last = polygons.size() - 1;
    leg.to = inside(to.position);
    add_leg(leg);
    path.corners.push_back({frame.out(leg.to), {polygons.back()}, {}});

    path.midpoints.push_back(from.position);
    for (const Portal& portal : portals) {
        path.portals.push_back({frame.out(portal.left), frame.out(portal.right)});
        path.midpoints.push_back(frame.out((portal.left + portal.right) * 0.5));
    }
    path.midpoints.push_back(to.position);
    for (std::size_t i = 0; i + 1 < path.corners.size(); ++i)
        path.length += length(path.corners[i + 1].position - path.corners[i].position);
    return path;
}

}  // namespace surefoot::navigation
