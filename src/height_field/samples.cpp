#include "height_field/samples.hpp"

namespace surefoot::internal {

HeightRange HeightSamples::range_of(const CellRange& cells) const noexcept {
    const auto height_at = [this](std::int64_t column, std::int64_t row) {
        return static_cast<float>(height(column, row));  // it is one
    };
    const float any = height_at(cells.first_column, cells.first_row);
    HeightRange range{any, any};
    for (std::int64_t row = cells.first_row; row <= cells.last_row + 1; ++row) {
        for (std::int64_t column = cells.first_column; column <= cells.last_column + 1; ++column) {
            range.include(height_at(column, row));
        }
    }
    return range;
}

}  // namespace surefoot::internal
