// One axis at a time. With c the centre, h half the extent, and w the face of a block ahead towards +, the box is free
// as long as c + h <= w. That is decided on the exact sum, and the farthest free centre is the largest double for which
// it holds; so resting is a fixed point and not a matter of rounding. Moves towards - are the mirror image.
#include <bit>

#include <surefoot/voxels_move.hpp>

#include "ieee_guard.hpp"
#include "limits.hpp"
#include "voxels/blocks.hpp"
#include "voxels/finder.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

/// Is a + b > c, without rounding? The error of a sum is itself a double (Knuth; Moller, 1965).
bool sum_exceeds(double a, double b, double c) noexcept {
    const double sum = a + b;
    if (sum != c) return sum > c;
    const double b_part = sum - a;
    return (a - (sum - b_part)) + (b - b_part) > 0;
}

/// The next double towards plus infinity. Requires: finite.
double next_up(double value) noexcept {
    if (value == 0) return std::bit_cast<double>(std::uint64_t{1});
    const auto bits = std::bit_cast<std::uint64_t>(value);
    return std::bit_cast<double>(value > 0 ? bits + 1 : bits - 1);
}
double next_down(double value) noexcept {
    return -next_up(-value);
}

/// The farthest centre at which a box of half extent `half` does not reach beyond `wall`.
double farthest_before(double wall, double half) noexcept {
    const double centre = wall - half;
    return sum_exceeds(centre, half, wall) ? next_down(centre) : centre;
}

struct Standing {
    double centre[3];
    double half[3];
};

/// Does the box overlap [low, high] along this axis? Touching does not count.
bool overlaps(const Standing& box, int axis, double low, double high) noexcept {
    return sum_exceeds(box.centre[axis], box.half[axis], low) && sum_exceeds(-box.centre[axis], box.half[axis], -high);
}

class AxisWalk {
public:
    explicit AxisWalk(const Voxels& voxels) noexcept : grid_(voxels) {}

    [[nodiscard]] bool is_inside(const Standing& box) const noexcept {
        bool inside = false;
        cells_of(box).for_each([&](const Cell& cell) noexcept {
            for_each_box(cell, [&](const Box3& solid, std::uint32_t, std::uint32_t) noexcept {
                inside = inside ||
                         (overlaps(box, 0, solid.min.x, solid.max.x) && overlaps(box, 1, solid.min.y, solid.max.y) &&
                          overlaps(box, 2, solid.min.z, solid.max.z));
            });
        });
        return inside;
    }

    /// Where `box` comes to along `axis`, and what stops it.
    [[nodiscard]] double advance(const Standing& box, int axis, double displacement, AxisStop& stop) const noexcept {
        if (displacement == 0) return box.centre[axis];
        const GridLine& line = grid_.line(axis);
        // Mirrored, if need be, so that it moves towards plus.
        const bool up = displacement > 0;
        const double sign = up ? 1 : -1;
        const double centre = sign * box.centre[axis];
        const double half = box.half[axis];
        const double way = sign * displacement;
        const double target = centre + way;
        const double reach = next_up(next_up(target) + half);  // rounding can only have made it too small

        CellBox cells = cells_of(box);
        const std::int64_t first = up ? line.first_reaching(centre + half) : line.last_reached(-(centre + half));
        const std::int64_t last = up ? line.last_reached(reach) : line.first_reaching(-reach);
        const std::int64_t step = up ? 1 : -1;
        double wall = never;
        for (std::int64_t layer = first; (last - layer) * step >= 0 && wall == never; layer += step) {
            cells.first[axis] = cells.last[axis] = layer;
            cells.for_each([&](const Cell& cell) noexcept {
                for_each_box(cell, [&](const Box3& solid, std::uint32_t id, std::uint32_t surface) noexcept {
                    const double face = sign * component(up ? solid.min : solid.max, axis);
                    if (face > wall || sum_exceeds(centre, half, face)) return;
                    for (int across = 0; across < 3; ++across) {
                        if (across == axis) continue;
                        if (!overlaps(box, across, component(solid.min, across), component(solid.max, across))) return;
                    }
                    const std::uint32_t triangle = id + 4 * static_cast<std::uint32_t>(axis) + (up ? 0 : 2);
                    if (face == wall && triangle > stop.triangle) return;
                    wall = face;
                    stop.triangle = triangle;
                    stop.surface = surface;
                });
            });
        }
        if (wall != never) {
            const double farthest = farthest_before(wall, half);
            if (sum_exceeds(centre, way, farthest)) {
                stop.blocked = true;
                return farthest == centre ? box.centre[axis] : sign * farthest;  // at rest, -0 stays -0
            }
        }
        stop = {};
        return sign * target;
    }

private:
    /// All cells that the box overlaps or touches. Rounding the sums changes nothing: the sides of cells are doubles,
    /// and what is beyond one of them is not rounded to before it.
    [[nodiscard]] CellBox cells_of(const Standing& box) const noexcept {
        CellBox cells{};
        for (int a = 0; a < 3; ++a) {
            cells.first[a] = grid_.line(a).first_reaching(box.centre[a] - box.half[a]);
            cells.last[a] = grid_.line(a).last_reached(box.centre[a] + box.half[a]);
        }
        return cells;
    }

    template <typename Look>
    void for_each_box(const Cell& cell, const Look& look) const noexcept {
        const Block block = grid_.block(cell);
        for (std::uint32_t i = 0; i < block.count; ++i) {
            look(grid_.placed(cell, BlockGrid::usable(block.boxes[i])), grid_.first_id(cell, i), block.surface);
        }
    }

    BlockGrid grid_;
};

BoxMove refuse(const dvec3& from) noexcept {
    BoxMove refused;
    if (is_valid_point(from)) refused.position = from;
    refused.x.blocked = refused.y.blocked = refused.z.blocked = true;
    refused.status = HitStatus::invalid;
    return refused;
}

enum class Tested { from_where_the_last_axis_ended, from_the_start };

BoxMove move(const Voxels& voxels, const Box& box, const dvec3& from, const dvec3& displacement, AxisOrder order,
             Tested tested) noexcept {
    const IeeeGuard guard;
    const Vec target = to_vec(from) + to_vec(displacement);
    if (!is_valid(box) || !is_valid_point(from) || !is_valid_point(to_dvec3(target))) return refuse(from);

    static constexpr int orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    const AxisWalk walk(voxels);
    const Standing start{{from.x, from.y, from.z}, {box.half_extents.x, box.half_extents.y, box.half_extents.z}};
    const double ways[3] = {displacement.x, displacement.y, displacement.z};
    Standing end = start;
    AxisStop stops[3];
    for (const int axis : orders[static_cast<int>(order)]) {
        const Standing& at = tested == Tested::from_the_start ? start : end;
        end.centre[axis] = walk.advance(at, axis, ways[axis], stops[axis]);
    }
    return {.position = {end.centre[0], end.centre[1], end.centre[2]},
            .x = stops[0],
            .y = stops[1],
            .z = stops[2],
            .started_inside = walk.is_inside(start)};
}

}  // namespace

BoxMove move_axis_by_axis(const Voxels& voxels, const Box& box, const dvec3& from, const dvec3& displacement,
                          AxisOrder order) noexcept {
    return move(voxels, box, from, displacement, order, Tested::from_where_the_last_axis_ended);
}

BoxMove incorrect_move_axes_together(const Voxels& voxels, const Box& box, const dvec3& from,
                                     const dvec3& displacement) noexcept {
    return move(voxels, box, from, displacement, AxisOrder::xyz, Tested::from_the_start);
}

}  // namespace v0
}  // namespace surefoot
