// Blocks as boxes and triangles in space.
#pragma once

#include <cstdint>

#include <surefoot/voxels.hpp>

#include "grid_line.hpp"
#include "query/reach.hpp"

namespace surefoot::internal {

/// The three coordinates of anything, by the number of the axis.
template <typename Vector>
constexpr auto component(const Vector& v, int axis) noexcept {
    return axis == 0 ? v.x : (axis == 1 ? v.y : v.z);
}

/// Faces are numbered 2 * axis for the low side, 2 * axis + 1 for the high one.
struct BlockFace {
    int axis;
    bool high;
    [[nodiscard]] static BlockFace numbered(std::uint32_t number) noexcept {
        return {static_cast<int>(number / 2), number % 2 != 0};
    }
};

class BlockGrid {
public:
    explicit BlockGrid(const Voxels& voxels) noexcept;

    [[nodiscard]] const GridLine& line(int axis) const noexcept { return lines_[axis]; }
    [[nodiscard]] Box3 box() const noexcept;

    /// What the callable says, made usable; nothing outside the window.
    [[nodiscard]] Block block(const Cell& cell) const noexcept {
        if (!lines_[0].holds(cell.x) || !lines_[1].holds(cell.y) || !lines_[2].holds(cell.z)) return Block::empty();
        const Block said = blocks_(cell);
        return said.count <= boxes_per_block_ ? said : Block::full(said.surface);
    }
    /// A box of a block, made usable.
    [[nodiscard]] static const BlockBox& usable(const BlockBox& box) noexcept;

    /// A box of the block at `cell`, in space.
    [[nodiscard]] Box3 placed(const Cell& cell, const BlockBox& box) const noexcept {
        const auto at = [&](int axis, double share) {
            return lines_[axis].at(static_cast<double>(component(cell, axis)) + share);
        };
        return {{at(0, box.min.x), at(1, box.min.y), at(2, box.min.z)},
                {at(0, box.max.x), at(1, box.max.y), at(2, box.max.z)}};
    }

    /// Is this face of this box in the side of its cell, and wholly covered by one box of the block beyond?
    [[nodiscard]] bool is_hidden(const Cell& cell, const BlockBox& box, const BlockFace& face) const noexcept;

    [[nodiscard]] std::uint32_t first_id(const Cell& cell, std::uint32_t box) const noexcept {
        const std::int64_t x = cell.x - lines_[0].first();
        const std::int64_t y = cell.y - lines_[1].first();
        const std::int64_t z = cell.z - lines_[2].first();
        const std::int64_t index = (y * lines_[2].count() + z) * lines_[0].count() + x;
        return static_cast<std::uint32_t>((index * boxes_per_block_ + box) * triangles_per_box);
    }
    [[nodiscard]] Cell cell(std::uint32_t id) const noexcept;
    [[nodiscard]] std::uint32_t box_number(std::uint32_t id) const noexcept {
        return id / triangles_per_box % boxes_per_block_;
    }

    static constexpr std::uint32_t triangles_per_box = 12;

private:
    BlockAt blocks_;
    GridLine lines_[3];
    std::uint32_t boxes_per_block_;
};

/// The flat box that is this face of a box.
[[nodiscard]] Box3 face_of(const Box3& box, const BlockFace& face) noexcept;

/// Triangle 0 or 1 of this face of a box, counter-clockwise from outside.
[[nodiscard]] Triangle triangle_of(const Box3& box, const BlockFace& face, std::uint32_t number) noexcept;

}  // namespace surefoot::internal
