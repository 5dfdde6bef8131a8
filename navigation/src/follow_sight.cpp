#include "follow_sight.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace surefoot::navigation {
namespace {

constexpr int most_crossed = 64;

/// The ground of a polygon under or over a place.
vec3 on_ground(const QueryState& state, dtPolyRef polygon, vec3 place) {
    float height = place.y;
    if (dtStatusFailed(state.detour->getPolyHeight(polygon, &place.x, &height))) {
        std::array<float, 3> nearest{place.x, place.y, place.z};
        bool over = false;
        state.detour->closestPointOnPoly(polygon, &place.x, nearest.data(), &over);
        return {nearest[0], nearest[1], nearest[2]};
    }
    return {place.x, height, place.z};
}

}  // namespace

std::optional<NavigationPoint> moved_along(const QueryState& state, const NavigationPoint& from, const dvec3& to) {
    if (!state.knows(from.polygon)) return std::nullopt;
    const vec3 start = state.frame().in(from.position);
    const vec3 end = state.frame().in(to);
    vec3 result{};
    std::array<dtPolyRef, 16> visited{};
    int count = 0;
    const dtStatus status = state.detour->moveAlongSurface(from.polygon.id, &start.x, &end.x, &state.filter, &result.x,
                                                           visited.data(), &count, static_cast<int>(visited.size()));
    if (dtStatusFailed(status) || dtStatusDetail(status, DT_BUFFER_TOO_SMALL)) return std::nullopt;
    const dtPolyRef polygon = count > 0 ? visited[static_cast<std::size_t>(count - 1)] : from.polygon.id;
    const vec3 ground = on_ground(state, polygon, result);
    return state.point(polygon, &ground.x);
}

std::optional<NavigationPoint> seen(const QueryState& state, const NavigationPoint& from, const dvec3& to) {
    if (!state.knows(from.polygon)) return std::nullopt;
    const vec3 start = state.frame().in(from.position);
    const vec3 end = state.frame().in(to);
    std::array<dtPolyRef, most_crossed> crossed{};
    dtRaycastHit hit{};
    hit.path = crossed.data();
    hit.maxPath = most_crossed;
    if (dtStatusFailed(state.detour->raycast(from.polygon.id, &start.x, &end.x, &state.filter, 0, &hit, 0)) ||
        hit.pathCount == 0 || hit.pathCount >= most_crossed)
        return std::nullopt;
    const float distance = std::hypot(end.x - start.x, end.z - start.z);
    if (hit.t < 1 && (1 - hit.t) * distance > 0.02F) return std::nullopt;
    const dtPolyRef polygon = crossed[static_cast<std::size_t>(hit.pathCount - 1)];
    const vec3 ground = on_ground(state, polygon, end);
    const double slack = std::max(state.mesh->agent().climb, 4 * state.ground().plan.cell_height);
    if (std::abs(ground.y - end.y) > slack) return std::nullopt;
    return state.point(polygon, &ground.x);
}

bool sees(const QueryState& state, const NavigationPoint& from, const dvec3& to) {
    return seen(state, from, to).has_value();
}

}  // namespace surefoot::navigation
