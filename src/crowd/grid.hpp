// Boxes in a grid: which of them meet which. Each lies in one cell, that of its centre, of a grid as coarse as it is
// large: one giant among ants does not make the ants' cells larger.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "vec.hpp"

namespace surefoot::internal {

struct Block {
    Vec centre;
    Vec reach;  ///< half its extent; negative for one that meets nobody
};

inline bool meet(const Block& a, const Block& b) noexcept {
    const Vec between = a.centre - b.centre;
    return absolute(between.x) <= a.reach.x + b.reach.x && absolute(between.y) <= a.reach.y + b.reach.y &&
           absolute(between.z) <= a.reach.z + b.reach.z;
}

class Grid {
public:
    [[nodiscard]] bool reserve(std::size_t count) noexcept;

    /// Requires: room for so many.
    void build(std::span<const Block> blocks) noexcept;

    /// Calls `visit(index)` once for each that meets `block`, in an order of no meaning.
    template <typename Visit>
    void each_near(const Block& block, const Visit& visit) const noexcept;

private:
    static constexpr int most_levels = 64;

    struct Cell {
        std::int64_t x, y, z;
    };
    struct Entry {
        Block block;
        std::uint32_t index;
        std::int32_t level;
        std::uint32_t slot;
    };

    static std::int32_t level_of(double reach) noexcept;
    static double edge_of(std::int32_t level) noexcept;
    static std::int64_t cell_of(double place, double edge) noexcept;
    [[nodiscard]] std::uint32_t slot_of(const Cell& cell, std::int32_t level) const noexcept;
    template <typename Visit>
    void visit_slot(std::uint32_t slot, const Cell& cell, std::int32_t level, const Block& block,
                    const Visit& visit) const noexcept;
    template <typename Visit>
    void visit_all(std::int32_t level, const Block& block, const Visit& visit) const noexcept;

    std::size_t room_ = 0;
    std::size_t count_ = 0;
    std::uint32_t slots_ = 0;                  // a power of two
    std::uint64_t levels_ = 0;                 // which are in use, a bit for each
    std::array<Vec, most_levels> reaches_;     // none of a level reaches farther, along each axis
    std::unique_ptr<Entry[]> entries_;         // in the order of their slots
    std::unique_ptr<Entry[]> unsorted_;        // for `build`
    std::unique_ptr<std::uint32_t[]> begins_;  // where each slot's entries begin, and one more
};

template <typename Visit>
void Grid::visit_slot(std::uint32_t slot, const Cell& cell, std::int32_t level, const Block& block,
                      const Visit& visit) const noexcept {
    const double edge = edge_of(level);
    for (std::uint32_t i = begins_[slot]; i < begins_[slot + 1]; ++i) {
        const Entry& entry = entries_[i];
        if (entry.level != level) continue;
        if (!meet(entry.block, block)) continue;
        // Several cells may share a slot.
        const Vec& at = entry.block.centre;
        if (cell_of(at.x, edge) != cell.x || cell_of(at.y, edge) != cell.y || cell_of(at.z, edge) != cell.z) continue;
        visit(entry.index);
    }
}

template <typename Visit>
void Grid::visit_all(std::int32_t level, const Block& block, const Visit& visit) const noexcept {
    for (std::size_t i = 0; i < count_; ++i) {
        const Entry& entry = entries_[i];
        if (entry.level != level) continue;
        if (meet(entry.block, block)) visit(entry.index);
    }
}

template <typename Visit>
void Grid::each_near(const Block& block, const Visit& visit) const noexcept {
    if (!(block.reach.x >= 0)) return;
    for (std::int32_t level = 0; level < most_levels; ++level) {
        if ((levels_ >> level & 1) == 0) continue;
        const double edge = edge_of(level);
        const Vec reach = block.reach + reaches_[static_cast<std::size_t>(level)];
        const Vec low = block.centre - reach;
        const Vec high = block.centre + reach;
        const Cell first{cell_of(low.x, edge), cell_of(low.y, edge), cell_of(low.z, edge)};
        const Cell last{cell_of(high.x, edge), cell_of(high.y, edge), cell_of(high.z, edge)};
        // A giant among ants covers more cells than there are ants.
        const double cells = static_cast<double>(last.x - first.x + 1) * static_cast<double>(last.y - first.y + 1) *
                             static_cast<double>(last.z - first.z + 1);
        if (cells > static_cast<double>(count_)) {
            visit_all(level, block, visit);
            continue;
        }
        for (std::int64_t x = first.x; x <= last.x; ++x) {
            for (std::int64_t y = first.y; y <= last.y; ++y) {
                for (std::int64_t z = first.z; z <= last.z; ++z) {
                    visit_slot(slot_of({x, y, z}, level), {x, y, z}, level, block, visit);
                }
            }
        }
    }
}

}  // namespace surefoot::internal
