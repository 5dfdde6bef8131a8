// Vertices that belong together become one.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <surefoot/cook.hpp>

#include "cook/soup.hpp"

namespace surefoot::internal {

/// Corners at one place get one index; with a tolerance, so do corners near an earlier one, and move there. Vertices of
/// no triangle are left out. Counts into the report.
[[nodiscard]] Soup weld(std::span<const dvec3> vertices, std::span<const std::uint32_t> indices, double tolerance,
                        CookReport& report);

/// The same for corners that have been moved onto each other since. Keeps the number of triangles.
void weld_again(Soup& soup);

}  // namespace surefoot::internal
