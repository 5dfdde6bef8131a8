// From ground that is shut or was taken out back to ground that is open.
#include <algorithm>
#include <array>
#include <queue>
#include <unordered_map>

#include "query_state.hpp"

namespace surefoot {

namespace navigation {
namespace {

/// Nobody is led farther over what is no ground.
constexpr std::size_t most_polygons = 4096;

/// Where a polygon is entered, and from which.
struct Entry {
    dtPolyRef before = 0;
    dvec3 place{0, 0, 0};  ///< in the frame
    double cost = 0;
    bool done = false;
};

dvec3 middle_of(const dtMeshTile& tile, const dtPoly& polygon) {
    dvec3 sum{0, 0, 0};
    for (std::size_t i = 0; i < polygon.vertCount; ++i) {
        const float* corner = &tile.verts[3 * std::size_t{polygon.verts[i]}];
        sum += dvec3{corner[0], corner[1], corner[2]};
    }
    return sum / static_cast<double>(polygon.vertCount);
}

/// Dijkstra's search over ground of any kind, until some is open.
class Back {
public:
    explicit Back(const QueryState& query) : query_(query), detour_(*query.ground().detour) {}

    [[nodiscard]] std::vector<dvec3> from(dtPolyRef polygon, const dvec3& place) {
        reach(polygon, {.place = place});
        for (std::size_t looked = 0; !open_.empty() && looked < most_polygons; ++looked) {
            const dtPolyRef here = open_.top().second;
            open_.pop();
            if (entries_[here].done) continue;
            entries_[here].done = true;
            const dtMeshTile* tile = nullptr;
            const dtPoly* shape = nullptr;
            detour_.getTileAndPolyByRefUnsafe(here, &tile, &shape);
            if (query_.is_open(*shape)) return way_to(here, *tile, *shape);
            spread(here, *tile, *shape);
        }
        return {};
    }

private:
    void reach(dtPolyRef polygon, const Entry& entry) {
        const auto [known, is_new] = entries_.emplace(polygon, entry);
        if (!is_new) {
            if (known->second.done || known->second.cost <= entry.cost) return;
            known->second = entry;
        }
        open_.emplace(entry.cost, polygon);
    }

    void spread(dtPolyRef here, const dtMeshTile& tile, const dtPoly& shape) {
        const Entry entry = entries_[here];
        for (unsigned int i = shape.firstLink; i != DT_NULL_LINK; i = tile.links[i].next) {
            const dtMeshTile* next_tile = nullptr;
            const dtPoly* next = nullptr;
            if (dtStatusFailed(detour_.getTileAndPolyByRef(tile.links[i].ref, &next_tile, &next)) ||
                next->getType() != DT_POLYTYPE_GROUND)
                continue;
            const std::optional<Portal> portal = portal_between(detour_, here, tile.links[i].ref);
            if (!portal) continue;
            const dvec3 middle = (portal->left + portal->right) * 0.5;
            reach(tile.links[i].ref,
                  {.before = here, .place = middle, .cost = entry.cost + length(middle - entry.place)});
        }
    }

    /// Over the middles of portals, and a foot's breadth on.
    [[nodiscard]] std::vector<dvec3> way_to(dtPolyRef polygon, const dtMeshTile& tile, const dtPoly& shape) {
        const Frame& frame = query_.frame();
        const dvec3 last = entries_[polygon].place;
        const dvec3 inwards = middle_of(tile, shape) - last;
        const double size = length(inwards);
        std::vector<dvec3> way;
        if (entries_[polygon].before == 0) return {frame.out(last)};
        way.push_back(frame.out(last + inwards * std::min(1.0, query_.mesh->agent().radius / std::max(size, 1e-9))));
        for (dtPolyRef at = polygon; entries_[at].before != 0; at = entries_[at].before)
            way.push_back(frame.out(entries_[at].place));
        std::reverse(way.begin(), way.end());
        return way;
    }

    const QueryState& query_;
    const dtNavMesh& detour_;
    std::unordered_map<dtPolyRef, Entry> entries_;
    std::priority_queue<std::pair<double, dtPolyRef>, std::vector<std::pair<double, dtPolyRef>>, std::greater<>> open_;
};

}  // namespace
}  // namespace navigation

inline namespace v0 {

std::vector<dvec3> NavigationQuery::way_back(const dvec3& place) const {
    if (!navigation::is_place(place)) return {};
    // Whatever is ground at all, as long as it is under these feet.
    const NavigationAgent& agent = mesh().agent();
    const dtQueryFilter any;
    const vec3 inside = state_->frame().in(place);
    const std::array<float, 3> reach{static_cast<float>(agent.radius), static_cast<float>(agent.height),
                                     static_cast<float>(agent.radius)};
    dtPolyRef polygon = 0;
    vec3 ground{0, 0, 0};
    if (dtStatusFailed(state_->detour->findNearestPoly(&inside.x, reach.data(), &any, &polygon, &ground.x)) ||
        polygon == 0 || state_->ground().detour->getOffMeshConnectionByRef(polygon) != nullptr)
        return {};
    return navigation::Back(*state_).from(polygon, {ground.x, ground.y, ground.z});
}

}  // namespace v0
}  // namespace surefoot
