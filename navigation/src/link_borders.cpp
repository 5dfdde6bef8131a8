#include "link_borders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include "query_state.hpp"
#include "spots.hpp"

namespace surefoot::navigation {
namespace {

bool is_ground(const dtNavMesh& detour, dtPolyRef reference) {
    const dtMeshTile* tile = nullptr;
    const dtPoly* polygon = nullptr;
    return dtStatusSucceed(detour.getTileAndPolyByRef(reference, &tile, &polygon)) &&
           polygon->getType() == DT_POLYTYPE_GROUND && (polygon->flags & taken_out) == 0;
}

/// The parts of a side, as shares of it, over which there is ground.
std::vector<std::pair<double, double>> covered(const dtNavMesh& detour, const dtMeshTile& tile, const dtPoly& polygon,
                                               unsigned int side) {
    std::vector<std::pair<double, double>> parts;
    for (unsigned int i = polygon.firstLink; i != DT_NULL_LINK; i = tile.links[i].next) {
        const dtLink& link = tile.links[i];
        if (link.edge != side || !is_ground(detour, link.ref)) continue;
        if (link.side == 0xff)
            parts.emplace_back(0.0, 1.0);
        else
            parts.emplace_back(link.bmin / 255.0, link.bmax / 255.0);
    }
    std::sort(parts.begin(), parts.end());
    return parts;
}

dvec3 wide(const dtMeshTile& tile, const dtPoly& polygon, unsigned int corner) {
    const float* at = &tile.verts[3 * static_cast<std::size_t>(polygon.verts[corner % polygon.vertCount])];
    return {at[0], at[1], at[2]};
}

/// Level and unit, to the side of a way on which `inside` is not.
dvec3 away_from(const dvec3& inside, const dvec3& a, const dvec3& b) {
    dvec3 out{b.z - a.z, 0, a.x - b.x};
    const double size = length(out);
    if (!(size > 0)) return {0, 0, 0};
    out /= size;
    return dot(out, a - inside) < 0 ? -out : out;
}

/// A place on a side is so far inside of the polygon [m].
constexpr double hair = 1e-3;

/// Between its corners a side may lie far from the ground; the finer heights of the polygon follow it.
dvec3 on_ground(const dtNavMeshQuery& query, dtPolyRef polygon, const dvec3& place) {
    const vec3 at(place);
    std::array<float, 3> found{};
    bool is_over = false;
    if (dtStatusFailed(query.closestPointOnPoly(polygon, &at.x, found.data(), &is_over))) return place;
    return {found[0], found[1], found[2]};
}

}  // namespace

Islands::Islands(const dtNavMesh& detour) {
    std::vector<dtPolyRef> found;
    std::uint32_t count = 0;
    each_polygon(detour, [&](dtPolyRef first, const dtMeshTile&, const dtPoly& start) {
        if ((start.flags & taken_out) != 0 || islands_.contains(first)) return;
        const std::uint32_t island = ++count;
        islands_.emplace(first, island);
        found.assign(1, first);
        while (!found.empty()) {
            const dtMeshTile* tile = nullptr;
            const dtPoly* polygon = nullptr;
            detour.getTileAndPolyByRefUnsafe(found.back(), &tile, &polygon);
            found.pop_back();
            for (unsigned int i = polygon->firstLink; i != DT_NULL_LINK; i = tile->links[i].next) {
                const dtPolyRef next = tile->links[i].ref;
                if (is_ground(detour, next) && islands_.emplace(next, island).second) found.push_back(next);
            }
        }
    });
}

std::uint32_t Islands::of(dtPolyRef polygon) const {
    const auto found = islands_.find(polygon);
    return found != islands_.end() ? found->second : 0;
}

std::vector<BorderPlace> border_places(const MeshState& state, const Islands& islands, double spacing) {
    std::vector<BorderPlace> places;
    Spots spots(spacing);
    const std::unique_ptr<dtNavMeshQuery, NavQueryFreed> query(dtAllocNavMeshQuery());
    if (!query || dtStatusFailed(query->init(state.detour.get(), 16))) throw std::bad_alloc();
    const auto add = [&](const BorderPlace& place) {
        const auto is_alike = [&](std::uint32_t other) {
            const BorderPlace& there = places[other];
            return there.island == place.island && length(there.place - place.place) < 0.7 * spacing &&
                   dot(there.out, place.out) > 0.8;
        };
        if (spots.any_near(place.place, is_alike)) return;
        spots.add(place.place, static_cast<std::uint32_t>(places.size()));
        places.push_back(place);
    };
    each_polygon(*state.detour, [&](dtPolyRef reference, const dtMeshTile& tile, const dtPoly& polygon) {
        if ((polygon.flags & taken_out) != 0) return;
        dvec3 middle{0, 0, 0};
        for (unsigned int i = 0; i < polygon.vertCount; ++i)
            middle += wide(tile, polygon, i) / static_cast<double>(polygon.vertCount);
        const auto add_part = [&](const dvec3& a, const dvec3& b) {
            const dvec3 out = away_from(middle, a, b);
            if (out == dvec3{0, 0, 0}) return;
            const int count = std::max(1, static_cast<int>(std::ceil(length(b - a) / spacing)));
            for (int i = 0; i < count; ++i)
                add({.place = state.plan.frame.out(
                         on_ground(*query, reference, a + (b - a) * ((i + 0.5) / count) - out * hair)),
                     .out = state.plan.frame.turned_out(out),
                     .island = islands.of(reference),
                     .polygon = reference});
        };
        for (unsigned int side = 0; side < polygon.vertCount; ++side) {
            const dvec3 a = wide(tile, polygon, side);
            const dvec3 b = wide(tile, polygon, side + 1);
            double done = 0;
            const auto add_until = [&](double end) {
                // What is left over between two roundings of a tile's border is no border.
                if ((end - done) * length(b - a) > state.plan.cell_size)
                    add_part(a + (b - a) * done, a + (b - a) * end);
            };
            for (const auto& [begin, end] : covered(*state.detour, tile, polygon, side)) {
                add_until(begin);
                done = std::max(done, end);
            }
            add_until(1);
        }
    });
    return places;
}

}  // namespace surefoot::navigation
