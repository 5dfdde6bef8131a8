#include "height_field/pyramid.hpp"

#include <algorithm>

namespace surefoot::internal {

HeightPyramid::HeightPyramid(std::int64_t quad_columns, std::int64_t quad_rows)
    : quad_columns_(quad_columns), quad_rows_(quad_rows) {
    const auto halved = [](std::int64_t cells, int shift) { return ((cells - 1) >> shift) + 1; };
    std::size_t nodes = 0;
    for (int shift = leaf_shift;; ++shift) {
        const Level level{halved(quad_columns, shift), halved(quad_rows, shift), nodes};
        levels_.push_back(level);
        nodes += static_cast<std::size_t>(level.columns * level.rows);
        if (level.columns == 1 && level.rows == 1) break;
    }
    ranges_.resize(nodes);
}

CellRange HeightPyramid::quads_of_leaf(std::int64_t column, std::int64_t row) const noexcept {
    return {column << leaf_shift, std::min(((column + 1) << leaf_shift), quad_columns_) - 1, row << leaf_shift,
            std::min(((row + 1) << leaf_shift), quad_rows_) - 1};
}

HeightRange HeightPyramid::of_children(int level, std::int64_t column, std::int64_t row) const noexcept {
    const Level& below = levels_[static_cast<std::size_t>(level - 1)];
    HeightRange range = at(level - 1, 2 * column, 2 * row);
    for (std::int64_t r = 2 * row; r < std::min(2 * row + 2, below.rows); ++r) {
        for (std::int64_t c = 2 * column; c < std::min(2 * column + 2, below.columns); ++c) {
            range.include(at(level - 1, c, r));
        }
    }
    return range;
}

}  // namespace surefoot::internal
