// Which triangles of voxels a query may meet: layer of cells after layer, nearest first.
#pragma once

#include <algorithm>
#include <cstdint>

#include <surefoot/query.hpp>

#include "query/moving_reach.hpp"
#include "query/reach.hpp"
#include "voxels/blocks.hpp"

namespace surefoot::internal {

/// Cells, the last ones included.
struct CellBox {
    std::int64_t first[3];
    std::int64_t last[3];

    template <typename Look>
    void for_each(const Look& look) const noexcept {
        for (std::int64_t y = first[1]; y <= last[1]; ++y) {
            for (std::int64_t z = first[2]; z <= last[2]; ++z) {
                for (std::int64_t x = first[0]; x <= last[0]; ++x) {
                    look(
                        Cell{static_cast<std::int32_t>(x), static_cast<std::int32_t>(y), static_cast<std::int32_t>(z)});
                }
            }
        }
    }
};

/// See query/ask.hpp.
class VoxelFinder {
public:
    static constexpr bool trusted = true;

    explicit VoxelFinder(const Voxels& voxels) noexcept : grid_(voxels) {}

    [[nodiscard]] Box3 box() const noexcept { return grid_.box(); }

    template <typename Ask>
    void find_all(const Ask& ask) const noexcept {
        cells_in(grid_.box()).for_each([&](const Cell& cell) noexcept {
            look_at(
                cell, [](const Box3&) noexcept { return true; }, ask);
        });
    }

    /// Layers across the axis along which the motion passes most of them, and of each layer only the cells that the
    /// motion meets while it is in that layer.
    template <typename Ask, typename Limit>
    void find(const MovingReach& reach, const Ask& ask, const Limit& limit, QueryWork* work) const noexcept {
        double Vec::*const axes[3] = {&Vec::x, &Vec::y, &Vec::z};
        const auto cells_passed = [&](int a) { return absolute(reach.along().*axes[a]) / grid_.line(a).step(); };
        int axis = cells_passed(0) > cells_passed(1) ? 0 : 1;
        if (cells_passed(2) > cells_passed(axis)) axis = 2;

        const GridLine& line = grid_.line(axis);
        const CellBox all = cells_in(reach.whole());
        const bool up = reach.along().*axes[axis] >= 0;
        const std::int64_t layers = all.last[axis] - all.first[axis] + 1;
        for (std::int64_t i = 0; i < layers; ++i) {
            const std::int64_t layer = up ? all.first[axis] + i : all.last[axis] - i;
            const auto span = reach.span_in(axes[axis], line.at(layer), line.at(layer + 1));
            if (span.enter > limit()) return;
            if (span.enter > span.leave) continue;
            if (work != nullptr) ++work->nodes;
            CellBox cells = cells_in(reach.between(span.enter, span.leave));
            cells.first[axis] = cells.last[axis] = layer;
            look_at_cells(cells, reach, ask, limit);
        }
    }

    /// Shells of cells around the point's own.
    template <typename Ask, typename Limit>
    void find(const RoundReach& reach, const Ask& ask, const Limit& limit, QueryWork* work) const noexcept {
        const CellBox all = cells_in(reach.whole());
        const double at[3] = {reach.point().x, reach.point().y, reach.point().z};
        std::int64_t middle[3];
        for (int a = 0; a < 3; ++a) {
            if (all.first[a] > all.last[a]) return;
            middle[a] = std::clamp(grid_.line(a).first_reaching(at[a]), all.first[a], all.last[a]);
        }
        for (std::int64_t ring = 0;; ++ring) {
            if (work != nullptr) ++work->nodes;
            look_at_shell(middle, ring, all, reach, ask, limit);
            double nearest_beyond = never;  // of what is outside of all shells so far
            for (int a = 0; a < 3; ++a) {
                const GridLine& line = grid_.line(a);
                const std::int64_t low = middle[a] - ring;
                const std::int64_t high = middle[a] + ring;
                if (low > all.first[a]) nearest_beyond = smaller(nearest_beyond, larger(at[a] - line.at(low), 0));
                if (high < all.last[a]) nearest_beyond = smaller(nearest_beyond, larger(line.at(high + 1) - at[a], 0));
            }
            if (nearest_beyond * (1 - 0x1p-40) - reach.slack() > limit() || nearest_beyond == never) return;
        }
    }

private:
    [[nodiscard]] CellBox cells_in(const Box3& box) const noexcept {
        const GridLine& x = grid_.line(0);
        const GridLine& y = grid_.line(1);
        const GridLine& z = grid_.line(2);
        return {{x.first_reaching(box.min.x), y.first_reaching(box.min.y), z.first_reaching(box.min.z)},
                {x.last_reached(box.max.x), y.last_reached(box.max.y), z.last_reached(box.max.z)}};
    }

    template <typename Reach, typename Ask, typename Limit>
    void look_at_cells(const CellBox& cells, const Reach& reach, const Ask& ask, const Limit& limit) const noexcept {
        cells.for_each([&](const Cell& cell) noexcept {
            look_at(
                cell, [&](const Box3& near) noexcept { return reach.key(near) <= limit(); }, ask);
        });
    }

    /// The cells that are `ring` away from the middle along one axis at least, and no more along any.
    template <typename Reach, typename Ask, typename Limit>
    void look_at_shell(const std::int64_t (&middle)[3], std::int64_t ring, const CellBox& all, const Reach& reach,
                       const Ask& ask, const Limit& limit) const noexcept {
        CellBox inside{{middle[0] - ring, middle[1] - ring, middle[2] - ring},
                       {middle[0] + ring, middle[1] + ring, middle[2] + ring}};
        for (int a = 0; a < 3; ++a) {
            // The two sides across this axis, then without them for the next axis.
            for (const bool high : {false, true}) {
                const std::int64_t layer = high ? inside.last[a] : inside.first[a];
                if (layer < all.first[a] || layer > all.last[a] || (high && ring == 0)) continue;
                CellBox side = inside;
                side.first[a] = side.last[a] = layer;
                for (int b = 0; b < 3; ++b) {
                    side.first[b] = std::max(side.first[b], all.first[b]);
                    side.last[b] = std::min(side.last[b], all.last[b]);
                }
                look_at_cells(side, reach, ask, limit);
            }
            ++inside.first[a];
            --inside.last[a];
        }
    }

    /// Hands out the triangles of one block whose box and whose face may be met, the hidden ones excepted.
    template <typename MayMeet, typename Ask>
    void look_at(const Cell& cell, const MayMeet& may_meet, const Ask& ask) const noexcept {
        const Block block = grid_.block(cell);
        for (std::uint32_t i = 0; i < block.count; ++i) {
            const BlockBox& box = BlockGrid::usable(block.boxes[i]);
            const Box3 placed = grid_.placed(cell, box);
            if (!may_meet(placed)) continue;
            const std::uint32_t first_id = grid_.first_id(cell, i);
            for (std::uint32_t number = 0; number < 6; ++number) {
                const BlockFace face = BlockFace::numbered(number);
                if (!may_meet(face_of(placed, face)) || grid_.is_hidden(cell, box, face)) continue;
                for (std::uint32_t k = 0; k < 2; ++k) {
                    ask(SourceTriangle{.triangle = triangle_of(placed, face, k),
                                       .id = first_id + 2 * number + k,
                                       .surface = block.surface});
                }
            }
        }
    }

    BlockGrid grid_;
};

}  // namespace surefoot::internal
