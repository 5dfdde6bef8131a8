#include <DetourNode.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <new>

#include <surefoot/navigation_query.hpp>

#include "query_state.hpp"

namespace surefoot {

namespace navigation {

DetourQuery make_detour_query(const dtNavMesh& mesh, std::size_t most_nodes) {
    DetourQuery query(dtAllocNavMeshQuery());
    if (!query || dtStatusFailed(query->init(&mesh, static_cast<int>(most_nodes)))) throw std::bad_alloc();
    return query;
}

void QueryState::refresh_filter() {
    filter.setIncludeFlags(walkable);
    filter.setExcludeFlags(shut);
    const std::vector<NavigationArea>& areas = ground().areas;
    for (std::size_t i = 0; i < areas.size(); ++i)
        filter.setAreaCost(detour_area(static_cast<std::uint32_t>(i)), static_cast<float>(areas[i].cost));
}

bool QueryState::knows(NavigationPolygon polygon) const {
    return detour->isValidPolyRef(polygon.id, &filter);
}

NavigationPoint QueryState::point(dtPolyRef polygon, const float* place) const {
    return {frame().out(place), {polygon}};
}

bool QueryState::begin(const NavigationPoint& from, const NavigationPoint& to) {
    refresh_filter();
    search_from = from;
    search_to = to;
    if (!knows(from.polygon) || !knows(to.polygon) || !is_place(from.position) || !is_place(to.position)) return false;
    const vec3 start = frame().in(from.position);
    const vec3 end = frame().in(to.position);
    return !dtStatusFailed(detour->initSlicedFindPath(from.polygon.id, to.polygon.id, &start.x, &end.x, &filter));
}

bool QueryState::advance(std::size_t rounds) {
    int done = 0;
    return dtStatusInProgress(
        detour->updateSlicedFindPath(static_cast<int>(std::min<std::size_t>(rounds, 1U << 30)), &done));
}

std::optional<NavigationPath> QueryState::finish() {
    std::vector<dtPolyRef> polygons(most_nodes);
    int count = 0;
    const dtStatus status = detour->finalizeSlicedFindPath(polygons.data(), &count, static_cast<int>(polygons.size()));
    if (dtStatusFailed(status) || count == 0) return std::nullopt;
    polygons.resize(static_cast<std::size_t>(count));
    NavigationPoint to = search_to;
    const bool partial = polygons.back() != to.polygon.id;
    if (partial) {
        // As near to the goal as the last polygon lets it.
        const vec3 goal = frame().in(to.position);
        std::array<float, 3> nearest{};
        bool over = false;
        if (dtStatusSucceed(detour->closestPointOnPoly(polygons.back(), &goal.x, nearest.data(), &over)))
            to = point(polygons.back(), nearest.data());
    }
    NavigationPath path = path_along(*this, polygons, search_from, to);
    path.partial = partial;
    return path;
}

}  // namespace navigation

inline namespace v0 {

using navigation::QueryState;

NavigationQuery::NavigationQuery(const NavigationMesh& mesh, std::size_t most_nodes, NavigationDoors doors)
    : state_(std::make_unique<QueryState>()) {
    state_->mesh = &mesh;
    if (doors == NavigationDoors::open) state_->shut = navigation::taken_out;
    state_->most_nodes = std::clamp<std::size_t>(most_nodes, 16, 65535);
    state_->detour = navigation::make_detour_query(*mesh.state().detour, state_->most_nodes);
    state_->refresh_filter();
}
NavigationQuery::NavigationQuery(NavigationQuery&& other) noexcept = default;
NavigationQuery& NavigationQuery::operator=(NavigationQuery&& other) noexcept = default;
NavigationQuery::~NavigationQuery() = default;

const NavigationMesh& NavigationQuery::mesh() const noexcept {
    return *state_->mesh;
}

namespace {

/// Of all polygons that lie under or over a place, the one whose ground is nearest below it, else nearest above.
class Beneath : public dtPolyQuery {
public:
    Beneath(const dtNavMeshQuery& query, const vec3& place, double below, double above, double hair)
        : query_(query), place_(place), below_(below), above_(above), hair_(hair) {}

    void process(const dtMeshTile*, dtPoly** polygons, dtPolyRef* references, int count) override {
        for (int i = 0; i < count; ++i) {
            if (polygons[i]->getType() != DT_POLYTYPE_GROUND) continue;
            // A place on the side that two polygons share may lie in neither, to floats; a hair aside is under it, too.
            vec3 point{0, 0, 0};
            if (dtStatusFailed(query_.closestPointOnPoly(references[i], &place_.x, &point.x, nullptr)) ||
                !(std::abs(point.x - place_.x) <= hair_ && std::abs(point.z - place_.z) <= hair_))
                continue;
            const float height = point.y;
            const double drop = static_cast<double>(place_.y) - height;
            if (drop > below_ || -drop > above_) continue;
            // What lies above counts as farther than all that lies below.
            const double distance = drop >= 0 ? drop : below_ - drop;
            if (found && distance >= distance_) continue;
            found = references[i];
            distance_ = distance;
            ground = {place_.x, height, place_.z};
        }
    }

    dtPolyRef found = 0;
    vec3 ground{0, 0, 0};

private:
    const dtNavMeshQuery& query_;
    vec3 place_;
    double below_;
    double above_;
    double hair_;
    double distance_ = 0;
};

}  // namespace

std::optional<NavigationPoint> NavigationQuery::under(const dvec3& place, double below, double above) const {
    if (!navigation::is_place(place) || !(below >= 0) || !(above >= 0)) return std::nullopt;
    below = std::min(below, navigation::largest_coordinate);
    above = std::min(above, navigation::largest_coordinate);
    state_->refresh_filter();
    const vec3 inside = state_->frame().in(place);
    // What the height detail adds may lie outside of the box around a polygon's corners.
    const float slack = static_cast<float>(state_->mesh->agent().climb);
    const auto hair = static_cast<float>(state_->ground().plan.cell_size / 100);
    const std::array<float, 3> half{hair, static_cast<float>((below + above) / 2) + slack, hair};
    const std::array<float, 3> middle{inside.x, inside.y + static_cast<float>((above - below) / 2), inside.z};
    Beneath beneath(*state_->detour, inside, below, above, hair);
    if (dtStatusFailed(state_->detour->queryPolygons(middle.data(), half.data(), &state_->filter, &beneath)) ||
        !beneath.found)
        return std::nullopt;
    return state_->point(beneath.found, &beneath.ground.x);
}

namespace {

/// Of all polygons that are asked, the point that is nearest to a place.
class Nearest : public dtPolyQuery {
public:
    Nearest(const dtNavMeshQuery& query, const vec3& place) : query_(query), place_(place) {}

    void process(const dtMeshTile*, dtPoly** polygons, dtPolyRef* references, int count) override {
        for (int i = 0; i < count; ++i) {
            vec3 point{0, 0, 0};
            if (polygons[i]->getType() != DT_POLYTYPE_GROUND ||
                dtStatusFailed(query_.closestPointOnPoly(references[i], &place_.x, &point.x, nullptr)))
                continue;
            const dvec3 off = dvec3(point) - dvec3(place_);
            const double distance = navigation::dot(off, off);
            if (found != 0 && distance >= distance_) continue;
            found = references[i];
            distance_ = distance;
            ground = point;
        }
    }

    dtPolyRef found = 0;
    vec3 ground{0, 0, 0};

private:
    const dtNavMeshQuery& query_;
    vec3 place_;
    double distance_ = 0;
};

}  // namespace

std::optional<NavigationPoint> NavigationQuery::nearest(const dvec3& place, double aside, double vertical) const {
    if (!navigation::is_place(place) || !(aside >= 0) || !(vertical >= 0)) return std::nullopt;
    state_->refresh_filter();
    const navigation::Plan& plan = state_->ground().plan;
    const vec3 inside = state_->frame().in(place);
    // Detour goes from tile to tile through the whole box, so it gets no more of it than there are tiles.
    const dvec3 least = dvec3{0, plan.low, 0} - plan.tile_size;
    const dvec3 most = dvec3{plan.tiles_x * plan.tile_size, plan.high, plan.tiles_z * plan.tile_size} + plan.tile_size;
    vec3 middle{0, 0, 0};
    vec3 half{0, 0, 0};
    for (int axis = 0; axis < 3; ++axis) {
        const double reach = axis == 1 ? vertical : aside;
        const double low = std::max(least[axis], inside[axis] - reach);
        const double high = std::min(most[axis], inside[axis] + reach);
        if (low > high) return std::nullopt;
        middle[axis] = static_cast<float>((low + high) / 2);
        half[axis] = static_cast<float>((high - low) / 2);
    }
    Nearest nearest(*state_->detour, inside);
    if (dtStatusFailed(state_->detour->queryPolygons(&middle.x, &half.x, &state_->filter, &nearest)) ||
        nearest.found == 0)
        return std::nullopt;
    const dvec3 found = state_->frame().out(&nearest.ground.x);
    const dvec3 off = state_->frame().turned_in(found - place);
    // Detour looks for polygons that reach into the box; their nearest points may lie outside.
    if (std::abs(off.x) > aside + 1e-3 || std::abs(off.z) > aside + 1e-3 || std::abs(off.y) > vertical + 1e-3)
        return std::nullopt;
    return NavigationPoint{found, {nearest.found}};
}

bool NavigationQuery::begin_search(const NavigationPoint& from, const NavigationPoint& to) {
    return state_->begin(from, to);
}

bool NavigationQuery::advance_search(std::size_t rounds) {
    return state_->advance(rounds);
}

std::size_t NavigationQuery::search_nodes(std::span<NavigationSearchNode> found) const {
    dtNodePool& pool = *state_->detour->getNodePool();
    const auto count = static_cast<std::size_t>(pool.getNodeCount());
    for (std::size_t i = 0; i < std::min(count, found.size()); ++i) {
        const dtNode* node = pool.getNodeAtIdx(static_cast<unsigned int>(i + 1));
        found[i] = {.polygon = {node->id},
                    .position = state_->frame().out(node->pos),
                    .cost = node->cost,
                    .estimate = node->total,
                    .open = (node->flags & DT_NODE_OPEN) != 0};
    }
    return count;
}

std::optional<NavigationPath> NavigationQuery::finish_search() {
    return state_->finish();
}

std::optional<NavigationPath> NavigationQuery::path(const NavigationPoint& from, const NavigationPoint& to,
                                                    std::span<const NavigationPolygon> without) const {
    if (!state_->begin(from, to)) return std::nullopt;
    // Detour's filter knows kinds of polygons only. To the search, one that is done with at no cost is not worth a
    // look.
    for (const NavigationPolygon polygon : without) {
        if (polygon == from.polygon) continue;
        dtNode* const node = state_->detour->getNodePool()->getNode(polygon.id);
        if (node == nullptr) continue;
        node->cost = node->total = 0;
        node->flags = DT_NODE_CLOSED;
    }
    while (state_->advance(1024)) continue;
    return state_->finish();
}

}  // namespace v0
}  // namespace surefoot
