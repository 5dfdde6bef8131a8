// Where on the mesh somebody is who was there a tick ago, and what lies straight ahead.
#pragma once

#include <optional>

#include "query_state.hpp"

namespace surefoot::navigation {

/// From a place of the mesh along the ground towards `to`, as far as the mesh goes; none if the polygon is not there
/// any more.
[[nodiscard]] std::optional<NavigationPoint> moved_along(const QueryState& state, const NavigationPoint& from,
                                                         const dvec3& to);

/// Does the straight way lie on the mesh, all of it, and end on the ground that is meant (and not on a floor above or
/// below it)? Two centimetres short of it count as there: corners of paths lie on the mesh's border.
[[nodiscard]] bool sees(const QueryState& state, const NavigationPoint& from, const dvec3& to);

/// The same as a place, if it is so.
[[nodiscard]] std::optional<NavigationPoint> seen(const QueryState& state, const NavigationPoint& from,
                                                  const dvec3& to);

}  // namespace surefoot::navigation
