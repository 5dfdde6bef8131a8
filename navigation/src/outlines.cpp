#include <cmath>

#include "mesh_state.hpp"

namespace surefoot {
inline namespace v0 {
namespace {

using navigation::MeshState;

const float* corner_of(const dtMeshTile& tile, const dtPoly& polygon, int corner) {
    return &tile.verts[3 * static_cast<std::size_t>(polygon.verts[corner])];
}

NavigationOutline outline_of(const MeshState& state, dtPolyRef reference, const dtMeshTile& tile,
                             const dtPoly& polygon) {
    NavigationOutline outline{.polygon = {reference},
                              .area = polygon.getArea() - 1U,
                              .taken_out = (polygon.flags & navigation::taken_out) != 0,
                              .corners = polygon.vertCount,
                              .corner = {},
                              .beside = {}};
    for (int i = 0; i < polygon.vertCount; ++i) outline.corner[i] = state.plan.frame.out(corner_of(tile, polygon, i));
    for (unsigned int link = polygon.firstLink; link != DT_NULL_LINK; link = tile.links[link].next) {
        const unsigned int edge = tile.links[link].edge;
        if (edge < polygon.vertCount && !outline.beside[edge]) outline.beside[edge] = {tile.links[link].ref};
    }
    return outline;
}

}  // namespace

std::size_t NavigationMesh::outlines(std::span<NavigationOutline> found) const noexcept {
    std::size_t count = 0;
    navigation::each_polygon(*state_->detour, [&](dtPolyRef reference, const dtMeshTile& tile, const dtPoly& polygon) {
        if (count < found.size()) found[count] = outline_of(*state_, reference, tile, polygon);
        ++count;
    });
    return count;
}

NavigationOutline NavigationMesh::outline(NavigationPolygon polygon) const noexcept {
    const dtMeshTile* tile = nullptr;
    const dtPoly* found = nullptr;
    if (dtStatusFailed(state_->detour->getTileAndPolyByRef(polygon.id, &tile, &found)) ||
        found->getType() != DT_POLYTYPE_GROUND)
        return {};
    return outline_of(*state_, polygon.id, *tile, *found);
}

NavigationReport NavigationMesh::report() const noexcept {
    NavigationReport report{.seconds = state_->seconds};
    const dtMeshTile* last = nullptr;
    navigation::each_polygon(*state_->detour, [&](dtPolyRef, const dtMeshTile& tile, const dtPoly& polygon) {
        if (&tile != last) ++report.tiles;
        last = &tile;
        ++report.polygons;
        report.area += navigation::area_of(tile, polygon);
    });
    return report;
}

}  // namespace v0

namespace navigation {

double area_of(const dtMeshTile& tile, const dtPoly& polygon) {
    double twice = 0;
    const float* a = corner_of(tile, polygon, 0);
    for (int i = 2; i < polygon.vertCount; ++i) {
        const float* b = corner_of(tile, polygon, i - 1);
        const float* c = corner_of(tile, polygon, i);
        twice += (double{b[0]} - a[0]) * (double{c[2]} - a[2]) - (double{b[2]} - a[2]) * (double{c[0]} - a[0]);
    }
    return std::abs(twice) / 2;
}

double area_of(const MeshState& state, NavigationPolygon polygon) {
    const dtMeshTile* tile = nullptr;
    const dtPoly* found = nullptr;
    return dtStatusSucceed(state.detour->getTileAndPolyByRef(polygon.id, &tile, &found)) ? area_of(*tile, *found) : 0;
}

std::optional<Error> missing_ground(const MeshState& state, const NavigationRegion& region) {
    if (region.kind != NavigationRegion::Kind::require) return std::nullopt;
    bool found = false;
    each_polygon(*state.detour, [&](dtPolyRef, const dtMeshTile& tile, const dtPoly& polygon) {
        dvec3 middle{0, 0, 0};
        for (int i = 0; i < polygon.vertCount && !found; ++i) {
            const dvec3 corner = state.plan.frame.out(corner_of(tile, polygon, i));
            middle += corner / static_cast<double>(polygon.vertCount);
            const dvec3 inside = to_body(region.pose, corner);
            found = std::abs(inside.x) <= region.half_extents.x && std::abs(inside.y) <= region.half_extents.y &&
                    std::abs(inside.z) <= region.half_extents.z;
        }
        const dvec3 inside = to_body(region.pose, middle);
        found = found || (std::abs(inside.x) <= region.half_extents.x && std::abs(inside.y) <= region.half_extents.y &&
                          std::abs(inside.z) <= region.half_extents.z);
    });
    if (found) return std::nullopt;
    return Error{.code = ErrorCode::invalid,
                 .text = "navigation: nobody can stand in '" + region.name +
                         "', which requires ground; look at the settings' radius, slope limit and step height there",
                 .file = {}};
}

}  // namespace navigation
}  // namespace surefoot
