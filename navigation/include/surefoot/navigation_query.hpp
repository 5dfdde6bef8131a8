/// Questions to a navigation mesh: which polygon is under me, how do I get there, what do I see along the ground?
///
/// Places are places of feet, in the world. "There is no way" and "there is no ground" are answers, not errors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <surefoot/math.hpp>
#include <surefoot/navigation_mesh.hpp>

namespace surefoot::navigation {
struct QueryState;
}

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// A place on the mesh.
struct NavigationPoint {
    dvec3 position{0, 0, 0};  ///< on the ground, as finely as the mesh follows it [m]
    NavigationPolygon polygon;
};

/// Between two polygons that follow each other on a path: what has to be crossed, as seen by whoever goes there.
struct NavigationPortal {
    dvec3 left{0, 0, 0};
    dvec3 right{0, 0, 0};
};

/// A corner of the shortest way through the polygons.
struct NavigationCorner {
    dvec3 position{0, 0, 0};
    NavigationPolygon polygon;  ///< that begins here
    std::optional<std::uint32_t>
        link{};  ///< of `NavigationMesh::links`: here it begins, and it ends at the next corner
};

struct NavigationPath {
    std::vector<NavigationPolygon> polygons;  ///< from the first to the last; links among them
    std::vector<NavigationPortal> portals;    ///< one fewer; a link's is a point
    std::vector<dvec3> midpoints;             ///< the raw path: from, the middle of each portal, to
    std::vector<NavigationCorner> corners;    ///< the pulled path: from, where it bends, to
    double length = 0;                        ///< of the pulled path [m]
    /// It does not reach the goal, but ends as near to it as it could get (or as far as there was room to search).
    bool partial = false;
};

/// One round of the search, for those who want to see it.
struct NavigationSearchNode {
    NavigationPolygon polygon;
    dvec3 position{0, 0, 0};
    double cost = 0;      ///< from the start [m]
    double estimate = 0;  ///< with what is expected to come [m]
    bool open = false;    ///< waits; else it is done with
};

/// What a ray along the ground met.
struct NavigationRay {
    double t = 1;             ///< how far it got, as a share of the way [0, 1]
    dvec3 position{0, 0, 0};  ///< where that is
    dvec3 normal{0, 0, 0};    ///< of the border it met, level; zero if it met none
    bool hit = false;
};

/// What shut areas are to a query.
enum class NavigationDoors : std::uint8_t {
    as_they_are,  ///< no ground, as long as they are shut
    open,         ///< ground: would there be a way if somebody opened every door?
};

/// Asks a mesh, with memory of its own: make one for each thread. Non-owning: the mesh must outlive it and may not
/// change while it is asked; between questions it may.
class NavigationQuery {
public:
    /// `most_nodes`: how many polygons a search may look at [16 to 65535]; beyond it, paths are partial.
    explicit NavigationQuery(const NavigationMesh& mesh, std::size_t most_nodes = 16384,
                             NavigationDoors doors = NavigationDoors::as_they_are);
    NavigationQuery(NavigationQuery&& other) noexcept;
    NavigationQuery& operator=(NavigationQuery&& other) noexcept;
    ~NavigationQuery();

    /// The ground under a place, or the nearest above it, within these distances [m, >= 0]. Ground that is shut or was
    /// taken out is none, to this as to `nearest`: no path begins there. Whoever stands on it is led off by `way_back`.
    [[nodiscard]] std::optional<NavigationPoint> under(const dvec3& place, double below, double above) const;

    /// The nearest point of the mesh that is at most `aside` away to each side and `vertical` up and down.
    [[nodiscard]] std::optional<NavigationPoint> nearest(const dvec3& place, double aside, double vertical) const;

    /// For feet on ground that is shut or was taken out: places to walk over, along such ground, the shortest way back
    /// to ground that is open; the last one lies on that. One place for feet that are on open ground. Empty where there
    /// is no ground under the feet, or none that leads back.
    [[nodiscard]] std::vector<dvec3> way_back(const dvec3& place) const;

    /// The shortest way by area costs: A* over polygons, then the simple stupid funnel. None if a point is not on the
    /// mesh. It goes over none of `without`: polygons, or links as they stand in `NavigationPath::polygons`.
    [[nodiscard]] std::optional<NavigationPath> path(const NavigationPoint& from, const NavigationPoint& to,
                                                     std::span<const NavigationPolygon> without = {}) const;

    /// The same search, to be watched: begin, advance until there is nothing left to do, finish. Asking anything else
    /// in between ends it. `begin_search` says false if a point is not on the mesh.
    [[nodiscard]] bool begin_search(const NavigationPoint& from, const NavigationPoint& to);
    /// Looks at up to `rounds` more polygons; false when the search has ended.
    bool advance_search(std::size_t rounds);
    /// Fills `found` with all that the search has come upon and returns how many they are.
    std::size_t search_nodes(std::span<NavigationSearchNode> found) const;
    [[nodiscard]] std::optional<NavigationPath> finish_search();

    /// Straight along the ground, until the mesh ends.
    [[nodiscard]] std::optional<NavigationRay> ray(const NavigationPoint& from, const dvec3& to) const;

    /// Any place of the mesh, each square metre as likely as any other. The same seed gives the same place. None if
    /// there is no ground.
    [[nodiscard]] std::optional<NavigationPoint> random(std::uint64_t seed) const;

    /// A place that can be got to from `from`, otherwise the same.
    [[nodiscard]] std::optional<NavigationPoint> random_reachable(const NavigationPoint& from,
                                                                  std::uint64_t seed) const;

    /// All ground that can be got to from a place, by walking and by links.
    [[nodiscard]] std::vector<NavigationPolygon> reachable(const NavigationPoint& from) const;

    [[nodiscard]] const NavigationMesh& mesh() const noexcept;

    /// For the parts of the wing.
    [[nodiscard]] const navigation::QueryState& state() const noexcept { return *state_; }

private:
    std::unique_ptr<navigation::QueryState> state_;
};

}  // namespace v0
}  // namespace surefoot
