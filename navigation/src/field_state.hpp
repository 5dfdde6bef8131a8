// What a potential field is made of.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <surefoot/navigation_field.hpp>

#include "query_state.hpp"

namespace surefoot::navigation {

inline constexpr std::uint32_t no_way = ~std::uint32_t{0};

/// A place in a portal through which a polygon is left on the way to the goal.
struct WayOut {
    dvec3 position{0, 0, 0};              ///< in the frame
    double left = 0;                      ///< from here to the goal, by costs [m]
    std::uint32_t next = no_way;          ///< the way out of the polygon behind the portal; none if the goal lies in it
    std::optional<std::uint32_t> link{};  ///< that begins here
};

/// Those of one polygon: `begin` to `end` of all ways.
struct WaysOut {
    dtPolyRef polygon = 0;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    float cost = 1;  ///< of a metre in it
};

/// All ways out of all polygons from which the goal can be got to.
struct Ways {
    std::vector<WaysOut> polygons;  ///< by reference
    std::vector<WayOut> all;

    [[nodiscard]] const WaysOut* of(dtPolyRef polygon) const;
};

/// Dijkstra's search from the goal over places in portals, against the directions in which they are crossed.
[[nodiscard]] Ways find_ways(const QueryState& query, const NavigationPoint& goal, double spacing);

/// A place on the way down from another: which way out is taken first, and how far it is to the goal.
struct Descend {
    std::uint32_t first = no_way;
    double left = 0;  ///< infinite if there is no way
};

[[nodiscard]] Descend best_way(const Ways& ways, dtPolyRef polygon, const dvec3& place, dtPolyRef goal_polygon,
                               const dvec3& goal);

struct FieldState {
    NavigationFieldOptions options;
    NavigationPoint goal;
    dvec3 goal_inside{0, 0, 0};  ///< in the frame
    Frame frame;
    Ways ways;  ///< empty for `straight`
};

/// The place of a polygon that is nearest to the goal through the air.
[[nodiscard]] NavigationMinimum lowest_of(const FieldState& field, const QueryState& query, dtPolyRef polygon);

/// Down the straight potential, step by step.
[[nodiscard]] NavigationDescent climb_down(const FieldState& field, const NavigationQuery& query,
                                           const NavigationPoint& from, const NavigationDescendOptions& options);

}  // namespace surefoot::navigation
