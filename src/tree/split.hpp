// Where a set of boxes is best divided into two.
#pragma once

#include <cstdint>
#include <span>

#include "tree/binary_tree.hpp"

namespace surefoot::internal {

struct ItemSummary {
    FloatBox box;
    FloatBox middles;  ///< of the items' middles, doubled
    float lowest_tile;
    float highest_tile;
};

/// Requires: at least one item.
[[nodiscard]] ItemSummary summarise(std::span<const TreeItem> items) noexcept;

/// Two sides of what was divided.
struct Division {
    std::uint32_t left = 0;  ///< how many items are on the left; 0: it could not be divided
    ItemSummary sides[2];    ///< of the left, of the right
};

/// Few enough to try every split there is.
inline constexpr std::size_t most_to_sort = 8;

/// Puts the items on their sides of the split with the least surface area, unless all have one middle. Both sides keep
/// their order. Requires: more than `most_to_sort` items; `scratch` has room for as many.
[[nodiscard]] Division divide_by_area(std::span<TreeItem> items, const FloatBox& middles, TreeItem* scratch) noexcept;

/// The same for few items, which it may sort. Requires: 2 to `most_to_sort` of them.
[[nodiscard]] Division divide_few_by_area(std::span<TreeItem> items) noexcept;

/// Puts items of tiles up to `highest` on the left. Requires: items on both sides.
[[nodiscard]] Division divide_by_tile(std::span<TreeItem> items, float highest, TreeItem* scratch) noexcept;

}  // namespace surefoot::internal
