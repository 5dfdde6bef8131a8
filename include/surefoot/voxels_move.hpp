/// The axis-by-axis move: how block worlds move their players, done right; and the way it is often done wrong.
#pragma once

#include <cstdint>
#include <type_traits>

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>
#include <surefoot/voxels.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// In which order the axes have their turns. The order decides on which side of a corner a diagonal move comes out.
enum class AxisOrder : std::uint8_t { xyz, xzy, yxz, yzx, zxy, zyx };

/// What one axis of a move met.
struct AxisStop {
    bool blocked = false;        ///< the box touches a face ahead, and the displacement would have taken it further
    std::uint32_t triangle = 0;  ///< the first triangle of that face; of several faces, the lowest
    std::uint32_t surface = 0;   ///< what the block is made of
};

/// Where a box came to, and why not further.
struct BoxMove {
    dvec3 position{0, 0, 0};  ///< of the box's centre [m]
    AxisStop x;               ///< what stopped it along x
    AxisStop y;               ///< along y: standing on the ground is `y.blocked` after a displacement downwards
    AxisStop z;               ///< along z
    HitStatus status = HitStatus::ok;  ///< anything but `ok`: not moved at all, blocked on every axis
    bool started_inside = false;       ///< it overlapped a block at `from`; such blocks do not hold it, so it can leave
};

static_assert(std::is_trivially_copyable_v<BoxMove>);

/// Moves a box along one axis after the other, each from where the last one ended, each up to the first face ahead.
///
/// Solid is what is inside of a block's boxes; touching is free. The box is exactly position +- half_extents, and
/// whether it overlaps is decided without rounding. Guarantees: from a free start it never ends inside of solid and
/// passes through nothing, however fast; it ends touching, which is the last double before overlapping; at rest against
/// a face its coordinate keeps its bits, tick after tick. Allocates nothing. Along each axis it asks about the blocks
/// ahead, up to the first that stops it. Fails closed: an invalid box, NaN, or a coordinate beyond 1e9 m give status
/// `invalid`, and it stays at `from` (at 0 if `from` itself is at fault).
[[nodiscard]] BoxMove move_axis_by_axis(const Voxels& voxels, const Box& box, const dvec3& from,
                                        const dvec3& displacement, AxisOrder order = AxisOrder::yxz) noexcept;

/// WRONG ON PURPOSE, for teaching and for tests: all three axes are tested from the start position, and then the box is
/// moved along all of them together. Do not use it in a game.
///
/// What goes wrong, seen from above: the box B moves towards x and z at once. Along x alone its way is free, along z
/// alone its way is free, so neither is blocked; but the block # is where both together lead.
///
///      . . . .        . . . .
///      . . # .   ->   . . B .     it stands inside the block, and the next tick is anybody's guess
///      . B . .        . . . .
///
/// `move_axis_by_axis` moves along x first, finds the block ahead along z from there, and stops beside it.
[[nodiscard]] BoxMove incorrect_move_axes_together(const Voxels& voxels, const Box& box, const dvec3& from,
                                                   const dvec3& displacement) noexcept;

}  // namespace v0
}  // namespace surefoot
