// The lowest and the highest height of every block of 4 x 4 quads, of every 2 x 2 of those, and so on up to one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace surefoot::internal {

struct HeightRange {
    float low = 0;
    float high = 0;

    void include(float height) noexcept {
        if (height < low) low = height;
        if (height > high) high = height;
    }
    void include(const HeightRange& range) noexcept {
        include(range.low);
        include(range.high);
    }
};

/// Cells, by column and row, the last ones included.
struct CellRange {
    std::int64_t first_column = 0;
    std::int64_t last_column = -1;
    std::int64_t first_row = 0;
    std::int64_t last_row = -1;

    [[nodiscard]] bool is_empty() const noexcept { return last_column < first_column || last_row < first_row; }
    /// The nodes that hold these cells, each of which is 2^shift cells wide.
    [[nodiscard]] CellRange shifted(int shift) const noexcept {
        return {first_column >> shift, last_column >> shift, first_row >> shift, last_row >> shift};
    }
};

class HeightPyramid {
public:
    /// A node of level 0 is 2^leaf_shift quads wide; each level doubles that.
    static constexpr int leaf_shift = 2;
    /// 2^30 quads in one row.
    static constexpr int most_levels = 30;

    HeightPyramid() = default;
    HeightPyramid(std::int64_t quad_columns, std::int64_t quad_rows);

    [[nodiscard]] int levels() const noexcept { return static_cast<int>(levels_.size()); }
    [[nodiscard]] const HeightRange& at(int level, std::int64_t column, std::int64_t row) const noexcept {
        const Level& here = levels_[static_cast<std::size_t>(level)];
        return ranges_[here.first + static_cast<std::size_t>(row * here.columns + column)];
    }
    [[nodiscard]] const HeightRange& top() const noexcept { return ranges_.back(); }

    /// Brings all nodes that hold any of these quads up to date. `range_of(CellRange quads)` looks at the samples.
    template <typename RangeOf>
    void refit(const CellRange& quads, const RangeOf& range_of) noexcept {
        for (int level = 0; level < levels(); ++level) {
            const CellRange nodes = quads.shifted(leaf_shift + level);
            for (std::int64_t row = nodes.first_row; row <= nodes.last_row; ++row) {
                for (std::int64_t column = nodes.first_column; column <= nodes.last_column; ++column) {
                    const Level& here = levels_[static_cast<std::size_t>(level)];
                    HeightRange& range = ranges_[here.first + static_cast<std::size_t>(row * here.columns + column)];
                    range = level > 0 ? of_children(level, column, row) : range_of(quads_of_leaf(column, row));
                }
            }
        }
    }

    [[nodiscard]] std::size_t bytes() const noexcept {
        return ranges_.capacity() * sizeof(HeightRange) + levels_.capacity() * sizeof(Level);
    }

private:
    struct Level {
        std::int64_t columns;
        std::int64_t rows;
        std::size_t first;  // in ranges_
    };

    [[nodiscard]] CellRange quads_of_leaf(std::int64_t column, std::int64_t row) const noexcept;
    [[nodiscard]] HeightRange of_children(int level, std::int64_t column, std::int64_t row) const noexcept;

    std::int64_t quad_columns_ = 0;
    std::int64_t quad_rows_ = 0;
    std::vector<Level> levels_;
    std::vector<HeightRange> ranges_;
};

}  // namespace surefoot::internal
