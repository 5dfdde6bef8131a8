#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>

#include "field_state.hpp"

namespace surefoot::navigation {
namespace {

constexpr int most_in_portal = 16;

dvec3 inside(const Frame& frame, const dvec3& place) {
    return frame.turned_in(place - frame.origin);
}

/// A way out with the polygon it belongs to and the one it leads to, while the search runs.
struct Door {
    WayOut way;
    dtPolyRef from = 0;
    dtPolyRef to = 0;
    bool done = false;
};

class Search {
public:
    Search(const QueryState& query, double spacing)
        : query_(query), detour_(*query.ground().detour), spacing_(spacing) {
        for (int i = 0; i < detour_.getMaxTiles(); ++i) {
            const dtMeshTile* tile = detour_.getTile(i);
            if (tile->header == nullptr) continue;
            const dtPolyRef first = detour_.getPolyRefBase(tile);
            for (int polygon = 0; polygon < tile->header->polyCount; ++polygon)
                add_doors(first | static_cast<dtPolyRef>(polygon), *tile, tile->polys[polygon]);
        }
    }

    /// From the goal outwards: the nearest door that is not done is final, and all doors into its polygon may lead
    /// through it.
    void run(dtPolyRef goal_polygon, const dvec3& goal) {
        relax_into(goal_polygon, goal, 0, no_way);
        while (!open_.empty()) {
            const auto [left, door] = open_.top();
            open_.pop();
            if (doors_[door].done) continue;
            doors_[door].done = true;
            relax_into(doors_[door].from, doors_[door].way.position, left, door);
        }
    }

    [[nodiscard]] Ways result() const {
        std::vector<std::uint32_t> order;
        for (std::uint32_t i = 0; i < doors_.size(); ++i)
            if (doors_[i].done) order.push_back(i);
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return doors_[a].from != doors_[b].from ? doors_[a].from < doors_[b].from : a < b;
        });
        std::vector<std::uint32_t> moved(doors_.size(), no_way);
        for (std::uint32_t i = 0; i < order.size(); ++i) moved[order[i]] = i;
        Ways ways;
        for (const std::uint32_t i : order) {
            const Door& door = doors_[i];
            const auto at = static_cast<std::uint32_t>(ways.all.size());
            if (ways.polygons.empty() || ways.polygons.back().polygon != door.from)
                ways.polygons.push_back({.polygon = door.from, .begin = at, .end = at, .cost = cost_of(door.from)});
            ways.all.push_back(door.way);
            if (door.way.next != no_way) ways.all.back().next = moved[door.way.next];
            ++ways.polygons.back().end;
        }
        return ways;
    }

private:
    void add_doors(dtPolyRef reference, const dtMeshTile& tile, const dtPoly& polygon) {
        if (!query_.is_open(polygon)) return;
        for (unsigned int i = polygon.firstLink; i != DT_NULL_LINK; i = tile.links[i].next) {
            const dtPolyRef to = tile.links[i].ref;
            const dtMeshTile* to_tile = nullptr;
            const dtPoly* to_polygon = nullptr;
            if (to == 0 || dtStatusFailed(detour_.getTileAndPolyByRef(to, &to_tile, &to_polygon)) ||
                !query_.is_open(*to_polygon))
                continue;
            const std::optional<Portal> portal = portal_between(detour_, reference, to);
            if (!portal) continue;
            std::optional<std::uint32_t> link;
            if (to_polygon->getType() == DT_POLYTYPE_OFFMESH_CONNECTION)
                link = detour_.getOffMeshConnectionByRef(to)->userId;
            const double size = length(portal->right - portal->left);
            const int pieces =
                std::clamp(static_cast<int>(std::ceil(size / spacing_)), size > 0 ? 1 : 0, most_in_portal);
            for (int k = 0; k <= pieces; ++k) {
                const double share = pieces > 0 ? static_cast<double>(k) / pieces : 0;
                into_[to].push_back(static_cast<std::uint32_t>(doors_.size()));
                doors_.push_back({.way = {.position = portal->left + (portal->right - portal->left) * share,
                                          .left = std::numeric_limits<double>::infinity(),
                                          .link = link},
                                  .from = reference,
                                  .to = to});
            }
        }
    }

    void relax_into(dtPolyRef polygon, const dvec3& place, double left, std::uint32_t next) {
        const auto doors = into_.find(polygon);
        if (doors == into_.end()) return;
        const double cost = cost_of(polygon);
        for (const std::uint32_t i : doors->second) {
            Door& door = doors_[i];
            if (door.done) continue;
            const double far = left + cost * length(place - door.way.position);
            if (!(far < door.way.left)) continue;
            door.way.left = far;
            door.way.next = next;
            open_.push({far, i});
        }
    }

    [[nodiscard]] float cost_of(dtPolyRef polygon) const {
        const dtMeshTile* tile = nullptr;
        const dtPoly* found = nullptr;
        detour_.getTileAndPolyByRefUnsafe(polygon, &tile, &found);
        return query_.filter.getAreaCost(found->getArea());
    }

    using Entry = std::pair<double, std::uint32_t>;

    const QueryState& query_;
    const dtNavMesh& detour_;
    double spacing_;
    std::vector<Door> doors_;
    std::unordered_map<dtPolyRef, std::vector<std::uint32_t>> into_;  ///< doors by the polygon that they lead to
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace

const WaysOut* Ways::of(dtPolyRef polygon) const {
    const auto found = std::lower_bound(polygons.begin(), polygons.end(), polygon,
                                        [](const WaysOut& ways, dtPolyRef other) { return ways.polygon < other; });
    return found != polygons.end() && found->polygon == polygon ? &*found : nullptr;
}

Ways find_ways(const QueryState& query, const NavigationPoint& goal, double spacing) {
    Search search(query, std::max(spacing, 1e-3));
    search.run(goal.polygon.id, inside(query.frame(), goal.position));
    return search.result();
}

Descend best_way(const Ways& ways, dtPolyRef polygon, const dvec3& place, dtPolyRef goal_polygon, const dvec3& goal) {
    Descend best{.first = no_way, .left = std::numeric_limits<double>::infinity()};
    const WaysOut* out = ways.of(polygon);
    const double cost = out != nullptr ? out->cost : 1;
    if (polygon == goal_polygon) best.left = cost * length(goal - place);
    if (out == nullptr) return best;
    for (std::uint32_t i = out->begin; i < out->end; ++i) {
        const double left = cost * length(ways.all[i].position - place) + ways.all[i].left;
        if (left < best.left) best = {.first = i, .left = left};
    }
    return best;
}

}  // namespace surefoot::navigation
