#include "crowd/grid.hpp"

#include <algorithm>
#include <new>

namespace surefoot::internal {

namespace {

// Of the finest grid [m]. The coarsest is 2^63 times as coarse.
constexpr double finest_edge = 0x1p-20;

// Beyond these cells places are not told apart: a share of a grid that is far finer than the place is far.
constexpr double farthest_cell = 0x1p60;

}  // namespace

bool Grid::reserve(std::size_t count) noexcept {
    if (count <= room_) return true;
    if (count > 0x40000000) return false;
    std::uint32_t slots = 16;
    while (slots < 2 * count) slots *= 2;
    std::unique_ptr<Entry[]> entries(new (std::nothrow) Entry[count]);
    std::unique_ptr<Entry[]> unsorted(new (std::nothrow) Entry[count]);
    std::unique_ptr<std::uint32_t[]> begins(new (std::nothrow) std::uint32_t[std::size_t{slots} + 1]);
    if (!entries || !unsorted || !begins) return false;
    room_ = count;
    slots_ = slots;
    entries_ = std::move(entries);
    unsorted_ = std::move(unsorted);
    begins_ = std::move(begins);
    count_ = 0;
    levels_ = 0;
    std::fill_n(begins_.get(), slots_ + 1, 0U);
    return true;
}

// The edge is at least twice the reach, and less than four times.
std::int32_t Grid::level_of(double reach) noexcept {
    std::int32_t level = 0;
    for (double edge = finest_edge; edge < 2 * reach && level < most_levels - 1; edge *= 2) ++level;
    return level;
}

double Grid::edge_of(std::int32_t level) noexcept {
    return finest_edge * static_cast<double>(std::uint64_t{1} << level);
}

std::int64_t Grid::cell_of(double place, double edge) noexcept {
    const double cell = place / edge;
    if (cell > farthest_cell) return static_cast<std::int64_t>(farthest_cell);
    if (cell < -farthest_cell) return static_cast<std::int64_t>(-farthest_cell);
    const auto truncated = static_cast<std::int64_t>(cell);
    return static_cast<double>(truncated) > cell ? truncated - 1 : truncated;
}

std::uint32_t Grid::slot_of(const Cell& cell, std::int32_t level) const noexcept {
    std::uint64_t hash = static_cast<std::uint64_t>(level) * 0x9e3779b97f4a7c15;
    for (const std::int64_t part : {cell.x, cell.y, cell.z}) {
        hash = (hash ^ static_cast<std::uint64_t>(part)) * 0xbf58476d1ce4e5b9;
        hash ^= hash >> 29;
    }
    return static_cast<std::uint32_t>(hash & (slots_ - 1));
}

void Grid::build(std::span<const Block> blocks) noexcept {
    levels_ = 0;
    count_ = 0;
    reaches_ = {};
    if (slots_ == 0) return;
    std::fill_n(begins_.get(), slots_ + 1, 0U);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        if (!(blocks[i].reach.x >= 0)) continue;
        Entry& entry = unsorted_[count_++];
        entry = {blocks[i], static_cast<std::uint32_t>(i), level_of(largest(blocks[i].reach)), 0};
        const double edge = edge_of(entry.level);
        const Vec& at = entry.block.centre;
        entry.slot = slot_of({cell_of(at.x, edge), cell_of(at.y, edge), cell_of(at.z, edge)}, entry.level);
        levels_ |= std::uint64_t{1} << entry.level;
        Vec& most = reaches_[static_cast<std::size_t>(entry.level)];
        const Vec& reach = entry.block.reach;
        most = {larger(most.x, reach.x), larger(most.y, reach.y), larger(most.z, reach.z)};
        ++begins_[entry.slot + 1];
    }
    for (std::uint32_t slot = 0; slot < slots_; ++slot) begins_[slot + 1] += begins_[slot];
    // Each slot's begin counts up while it is filled, and is put back afterwards.
    for (std::size_t i = 0; i < count_; ++i) entries_[begins_[unsorted_[i].slot]++] = unsorted_[i];
    for (std::uint32_t slot = slots_; slot > 0; --slot) begins_[slot] = begins_[slot - 1];
    begins_[0] = 0;
}

}  // namespace surefoot::internal
