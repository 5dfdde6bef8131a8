// Detour believes its tiles: it follows every index in them. So bytes that come from a file are looked at here first.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "plan.hpp"

namespace surefoot::navigation {

/// What a tile has to fit to.
struct TileFrame {
    const Plan& plan;
    std::int32_t x = 0;
    std::int32_t z = 0;
    std::span<const NavigationArea> areas{};
    std::size_t links = 0;
    std::size_t most_polygons = 0;
};

struct TileFault {
    std::size_t byte = 0;  ///< from where the tile begins
    std::string what;
};

/// What is wrong with a tile, if something is. Without a fault, Detour stays within the bytes whatever it is asked:
/// every count fits, every index names something, every number is finite and small enough to be squared, the tree of
/// boxes ends, and polygons are convex, turned alike, and beside each other where they say so.
/// Requires: the bytes begin at a multiple of 4.
[[nodiscard]] std::optional<TileFault> tile_fault(std::span<const std::byte> bytes, const TileFrame& frame);

}  // namespace surefoot::navigation
