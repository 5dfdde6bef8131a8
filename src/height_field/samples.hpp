// The samples of a height field, and the corners and triangles that they mean.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <surefoot/height_field.hpp>
#include <surefoot/math.hpp>

#include "grid_line.hpp"
#include "height_field/pyramid.hpp"
#include "query/reach.hpp"
#include "rounded.hpp"

namespace surefoot::internal {

/// Two triangles share a quad. Rising: 2q is (00, 01, 11), 2q + 1 is (00, 11, 10), named by column and row of the
/// corner; falling: 2q is (00, 01, 10), 2q + 1 is (10, 01, 11). All are counter-clockwise from above.
struct HeightSamples {
    GridLine x;  ///< cells are quads
    GridLine z;
    double scale = 1;
    double offset = 0;
    Diagonal diagonal = Diagonal::rising;
    std::vector<float> heights;  ///< empty for 16-bit samples
    std::vector<std::uint16_t> levels;
    std::vector<std::uint8_t> quads;      ///< empty for no flags
    std::vector<std::uint8_t> materials;  ///< empty for none
    std::vector<std::uint32_t> surfaces;

    [[nodiscard]] double height_of(double sample) const noexcept { return rounded_to_float(offset + scale * sample); }
    [[nodiscard]] double height(std::int64_t column, std::int64_t row) const noexcept {
        const auto place = static_cast<std::size_t>(row * (x.count() + 1) + column);
        return height_of(heights.empty() ? static_cast<double>(levels[place]) : static_cast<double>(heights[place]));
    }

    [[nodiscard]] std::size_t quad_at(std::int64_t column, std::int64_t row) const noexcept {
        return static_cast<std::size_t>(row * x.count() + column);
    }
    [[nodiscard]] std::uint8_t flags(std::size_t quad) const noexcept { return quads.empty() ? 0 : quads[quad]; }
    [[nodiscard]] bool is_hole(std::size_t quad) const noexcept { return (flags(quad) & quad_hole) != 0; }
    [[nodiscard]] std::uint32_t surface(std::size_t triangle) const noexcept {
        if (materials.empty()) return surfaces.empty() ? 0 : surfaces[0];
        return surfaces.empty() ? materials[triangle] : surfaces[materials[triangle]];
    }
    [[nodiscard]] bool is_rising(std::int64_t column, std::int64_t row) const noexcept {
        const bool by_field =
            diagonal == Diagonal::rising || (diagonal == Diagonal::alternating && ((column + row) & 1) == 0);
        return by_field != ((flags(quad_at(column, row)) & quad_flipped) != 0);
    }

    /// The lowest and the highest corner of some quads.
    [[nodiscard]] HeightRange range_of(const CellRange& cells) const noexcept;
};

/// A quad with its corners; [column][row] of the corner.
struct HeightQuad {
    HeightQuad(const HeightSamples& samples, std::int64_t column, std::int64_t row) noexcept
        : low_x(samples.x.at(column)),
          high_x(samples.x.at(column + 1)),
          low_z(samples.z.at(row)),
          high_z(samples.z.at(row + 1)),
          y{{samples.height(column, row), samples.height(column, row + 1)},
            {samples.height(column + 1, row), samples.height(column + 1, row + 1)}} {}

    [[nodiscard]] Box3 box() const noexcept {
        return {{low_x, smaller(smaller(y[0][0], y[0][1]), smaller(y[1][0], y[1][1])), low_z},
                {high_x, larger(larger(y[0][0], y[0][1]), larger(y[1][0], y[1][1])), high_z}};
    }
    [[nodiscard]] dvec3 corner(int column, int row) const noexcept {
        return {column == 0 ? low_x : high_x, y[column][row], row == 0 ? low_z : high_z};
    }
    [[nodiscard]] Triangle first(bool rising) const noexcept {
        return {corner(0, 0), corner(0, 1), rising ? corner(1, 1) : corner(1, 0)};
    }
    [[nodiscard]] Triangle second(bool rising) const noexcept {
        if (rising) return {corner(0, 0), corner(1, 1), corner(1, 0)};
        return {corner(1, 0), corner(0, 1), corner(1, 1)};
    }

    double low_x, high_x, low_z, high_z;
    double y[2][2];
};

}  // namespace surefoot::internal
