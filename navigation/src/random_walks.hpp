// Walks between random places of a mesh, by as many threads as may work.
#pragma once

#include <cstdint>
#include <vector>

#include <surefoot/navigation_check.hpp>
#include <surefoot/navigation_query.hpp>

namespace surefoot::navigation {

struct RandomWalk {
    NavigationPoint from;
    NavigationPoint to;
    WalkReport report;
};

/// Their ends are `2 * count` random places from `seed` on. Doors count as open. None for a mesh without ground.
[[nodiscard]] std::vector<RandomWalk> random_walks(const World& world, const CharacterSettings& settings,
                                                   const NavigationMesh& mesh, const WalkOptions& options, int threads,
                                                   std::size_t count, std::uint64_t seed,
                                                   const NavigationProgress& progress);

}  // namespace surefoot::navigation
