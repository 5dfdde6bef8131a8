// A ray along the ground. Detour's own goes on from polygon to polygon for as long as they send it on, which in a file
// made to harm, or where rounding has bent a corner, is for ever; this one comes to an end, and reckons in doubles.
#include <algorithm>
#include <array>
#include <limits>

#include "query_state.hpp"

namespace surefoot {

namespace navigation {
namespace {

/// No ray crosses more polygons.
constexpr int most_polygons = 1 << 16;

using Level = std::array<double, 2>;  ///< x and z

Level level(const float* v) {
    return {v[0], v[2]};
}

struct Way {
    Level from{};
    Level step{};
};

/// The side by which a line leaves a convex polygon, and when.
struct Exit {
    std::size_t side = 0;
    double t = std::numeric_limits<double>::infinity();
    Level out{};       ///< across the side, away from the polygon; not of unit length
    double along = 0;  ///< where on the side, from its first corner to its second [0, 1]
};

Exit exit_of(const dtMeshTile& tile, const dtPoly& polygon, const Way& way) {
    Exit exit;
    for (std::size_t i = 0; i < polygon.vertCount; ++i) {
        const Level a = level(&tile.verts[3 * std::size_t{polygon.verts[i]}]);
        const Level b = level(&tile.verts[3 * std::size_t{polygon.verts[(i + 1) % polygon.vertCount]}]);
        const Level side{b[0] - a[0], b[1] - a[1]};
        const Level out{-side[1], side[0]};
        const double speed = out[0] * way.step[0] + out[1] * way.step[1];
        if (!(speed > 0)) continue;
        const double t = (out[0] * (a[0] - way.from[0]) + out[1] * (a[1] - way.from[1])) / speed;
        if (!(t < exit.t)) continue;
        const double size = side[0] * side[0] + side[1] * side[1];
        const Level at{way.from[0] + t * way.step[0] - a[0], way.from[1] + t * way.step[1] - a[1]};
        exit = {.side = i, .t = t, .out = out, .along = (at[0] * side[0] + at[1] * side[1]) / size};
    }
    return exit;
}

/// The ground beyond a side, where the line crosses it; 0 if there is none.
dtPolyRef beyond(const QueryState& state, const dtMeshTile& tile, const dtPoly& polygon, const Exit& exit) {
    const dtNavMesh& detour = *state.ground().detour;
    for (unsigned int i = polygon.firstLink; i != DT_NULL_LINK; i = tile.links[i].next) {
        const dtLink& link = tile.links[i];
        if (link.edge != exit.side) continue;
        const dtMeshTile* next_tile = nullptr;
        const dtPoly* next = nullptr;
        if (dtStatusFailed(detour.getTileAndPolyByRef(link.ref, &next_tile, &next)) ||
            next->getType() != DT_POLYTYPE_GROUND || !state.is_open(*next))
            continue;
        // On a tile's border only a part of a side leads to each neighbour, in 255ths of it.
        const bool whole = link.side == 0xff || (link.bmin == 0 && link.bmax == 255);
        if (whole || (exit.along >= link.bmin / 255.0 && exit.along <= link.bmax / 255.0)) return link.ref;
    }
    return 0;
}

}  // namespace
}  // namespace navigation

inline namespace v0 {

std::optional<NavigationRay> NavigationQuery::ray(const NavigationPoint& from, const dvec3& to) const {
    using namespace navigation;
    state_->refresh_filter();
    if (!state_->knows(from.polygon) || !is_place(from.position) || !is_place(to)) return std::nullopt;
    const Frame& frame = state_->frame();
    const dvec3 start = frame.turned_in(from.position - frame.origin);
    const dvec3 step = frame.turned_in(to - from.position);
    const Way way{{start.x, start.z}, {step.x, step.z}};
    NavigationRay ray;
    dtPolyRef polygon = from.polygon.id;
    double t = 0;
    for (int crossed = 0;; ++crossed) {
        const dtMeshTile* tile = nullptr;
        const dtPoly* shape = nullptr;
        if (dtStatusFailed(state_->ground().detour->getTileAndPolyByRef(polygon, &tile, &shape)) ||
            shape->getType() != DT_POLYTYPE_GROUND)
            return std::nullopt;
        const Exit exit = exit_of(*tile, *shape, way);
        if (exit.t >= 1) break;
        t = std::max(t, exit.t);
        polygon = crossed < most_polygons ? beyond(*state_, *tile, *shape, exit) : 0;
        if (polygon != 0) continue;
        ray.hit = true;
        ray.t = t;
        ray.normal = frame.turned_out(dvec3{-exit.out[0], 0, -exit.out[1]});
        ray.normal /= length(ray.normal);
        break;
    }
    ray.position = from.position + (to - from.position) * ray.t;
    return ray;
}

}  // namespace v0
}  // namespace surefoot
