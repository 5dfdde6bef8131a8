// The line that a follower keeps to.
#pragma once

#include <surefoot/navigation_line.hpp>
#include <surefoot/navigation_query.hpp>

#include "frame.hpp"

namespace surefoot::navigation {

/// Goes on straight to a place, where a link may begin.
void append(NavigationLine& line, const dvec3& place, std::optional<std::uint32_t> link = {});

/// The pulled path.
[[nodiscard]] NavigationLine pulled_line(const NavigationPath& path);

/// The raw path, through the middles of portals: longer, but away from walls.
[[nodiscard]] NavigationLine middle_line(const NavigationPath& path);

/// From a place straight to where a line begins, and along it.
[[nodiscard]] NavigationLine line_from(const dvec3& place, const NavigationLine& line);

/// Cuts out what leads back to where the line was before, to within `cell` [m]: wanderings. Links are kept.
[[nodiscard]] NavigationLine without_loops(const NavigationLine& line, double cell);

[[nodiscard]] dvec3 place_on(const NavigationLine& line, double along);

struct NearestOnLine {
    double along = 0;
    double distance = 0;  ///< seen along `up` [m]
};

/// Of the part of the line from `begin` to `end`, the nearest to a place.
[[nodiscard]] NearestOnLine nearest_on(const NavigationLine& line, const dvec3& place, const dvec3& up, double begin,
                                       double end);

/// Where the first link at or after `along` begins, else the line's end.
[[nodiscard]] double next_stop(const NavigationLine& line, double along);

/// How fast to go here, so that with this deceleration every bend ahead is taken with at most `drift` of sliding on,
/// and the speed is zero at `stop`.
[[nodiscard]] double speed_here(const NavigationLine& line, const dvec3& up, double along, double stop,
                                double deceleration, double drift, double most);

[[nodiscard]] inline dvec3 level(const dvec3& v, const dvec3& up) {
    return v - up * dot(v, up);
}

}  // namespace surefoot::navigation
