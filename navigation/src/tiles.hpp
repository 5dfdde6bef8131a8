// Many tiles at once, by as many threads as wanted; the result does not depend on how many.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <surefoot/error.hpp>
#include <surefoot/navigation_build.hpp>

#include "plan.hpp"
#include "tile_mesh.hpp"

namespace surefoot::navigation {

/// Builds the tiles at these places (x, z), in their order. Fails with the first tile's error.
[[nodiscard]] Expected<std::vector<TileMesh>> build_tiles(const World& world, const CharacterSettings& settings,
                                                          const NavigationOptions& options, const Plan& plan,
                                                          std::span<const std::pair<int, int>> places);

}  // namespace surefoot::navigation
