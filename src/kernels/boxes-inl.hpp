// Boxes against boxes: a node's eight children, or the triangles of a leaf, against what a motion sweeps or against its
// path. Included once for each SIMD target.
#if defined(SUREFOOT_BOXES_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SUREFOOT_BOXES_INL_HPP
#undef SUREFOOT_BOXES_INL_HPP
#else
#define SUREFOOT_BOXES_INL_HPP
#endif

#include <cmath>
#include <hwy/highway.h>

#include "kernels/mesh_search.hpp"
#include "rounded.hpp"

HWY_BEFORE_NAMESPACE();
namespace surefoot::internal {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// The region, rounded outwards, relative to a tile.
struct FloatRegion {
    float min[3];
    float max[3];
};

HWY_INLINE FloatRegion region_about(const Box3& box, const Vec& origin) noexcept {
    // The difference with an origin other than zero is rounded once; the extent has a margin that is far larger.
    return {
        {float_at_most(box.min.x - origin.x), float_at_most(box.min.y - origin.y), float_at_most(box.min.z - origin.z)},
        {float_at_least(box.max.x - origin.x), float_at_least(box.max.y - origin.y),
         float_at_least(box.max.z - origin.z)}};
}

template <class D>
HWY_INLINE hn::Vec<D> decoded(D d, const WideNode& node, int axis, const std::uint8_t* q) noexcept {
    const hn::Rebind<std::uint8_t, D> bytes;
    const hn::Rebind<std::int32_t, D> ints;
    const auto steps = hn::ConvertTo(d, hn::PromoteTo(ints, hn::LoadU(bytes, q)));
    return hn::Add(hn::Set(d, node.origin[axis]), hn::Mul(steps, hn::Set(d, node.step(axis))));
}

// Which children's boxes meet the region: a bit each.
HWY_INLINE std::uint32_t children_in(const WideNode& node, const FloatRegion& region) noexcept {
    const hn::CappedTag<float, tree_width> d;
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < tree_width; i += hn::Lanes(d)) {
        auto meets = hn::FirstN(d, hn::Lanes(d));
        for (int axis = 0; axis < 3; ++axis) {
            const auto low = decoded(d, node, axis, node.low[axis] + i);
            const auto high = decoded(d, node, axis, node.high[axis] + i);
            meets = hn::And(
                meets, hn::And(hn::Le(low, hn::Set(d, region.max[axis])), hn::Ge(high, hn::Set(d, region.min[axis]))));
        }
        std::uint8_t mask[8] = {};
        hn::StoreMaskBits(d, meets, mask);
        bits |= (mask[0] & ((1U << hn::Lanes(d)) - 1)) << i;
    }
    return bits & ((1U << (node.count < tree_width ? node.count : tree_width)) - 1);
}

// Which triangles have no side that all three corners are beyond, a bit each.
HWY_INLINE std::uint32_t unbound(const LeafBlock& block, const std::uint8_t (&beyond)[32]) noexcept {
    std::uint32_t bits = 0;
#if HWY_TARGET == HWY_SCALAR
    for (std::uint32_t slot = 0; slot < block.count; ++slot) {
        std::uint8_t all = 0xff;
        for (int i = 0; i < 3; ++i) all &= beyond[block.corner(i)[slot] & 31];
        bits |= static_cast<std::uint32_t>(all == 0) << slot;
    }
#else
    const hn::FixedTag<std::uint8_t, 16> d;
    const auto first = hn::Load(d, beyond);
    const auto second = hn::Load(d, beyond + 16);
    const auto fifteen = hn::Set(d, std::uint8_t{15});
    const auto beyond_of = [&](int corner) HWY_ATTR {
        const auto index = hn::LoadU(d, block.corner(corner));
        const auto low = hn::And(index, fifteen);
        return hn::IfThenElse(hn::Gt(index, fifteen), hn::TableLookupBytes(second, low),
                              hn::TableLookupBytes(first, low));
    };
    const auto all = hn::And(beyond_of(0), hn::And(beyond_of(1), beyond_of(2)));
    std::uint8_t mask[8] = {};
    hn::StoreMaskBits(d, hn::Eq(all, hn::Zero(d)), mask);
    bits = mask[0] & ((1U << block.count) - 1);
#endif
    return bits;
}

// Which triangles of a leaf have a box that meets the region, a bit each: those whose three vertices are not all beyond
// the same side of it.
HWY_INLINE std::uint32_t triangles_in(const LeafBlock& block, const FloatRegion& region) noexcept {
    const hn::CappedTag<float, tree_width> d;
    const hn::Rebind<std::int32_t, decltype(d)> ints;
    const hn::Rebind<std::uint8_t, decltype(d)> bytes;
    alignas(16) std::uint8_t beyond[32] = {};  // bytes that nobody wrote may name any of them
    for (std::size_t i = 0; i < block.vertices; i += hn::Lanes(d)) {
        auto sides = hn::Zero(ints);
        for (int axis = 0; axis < 3; ++axis) {
            const auto at = hn::LoadU(d, block.axis(axis) + i);
            const auto below = hn::RebindMask(ints, hn::Lt(at, hn::Set(d, region.min[axis])));
            const auto above = hn::RebindMask(ints, hn::Gt(at, hn::Set(d, region.max[axis])));
            sides = hn::Or(sides, hn::Or(hn::IfThenElseZero(below, hn::Set(ints, 1 << (2 * axis))),
                                         hn::IfThenElseZero(above, hn::Set(ints, 2 << (2 * axis)))));
        }
        hn::StoreU(hn::DemoteTo(bytes, sides), bytes, beyond + i);
    }
    return unbound(block, beyond);
}

// A motion as the slab test wants it: a box is entered at (low - reach_high - from) / along, and so on.
struct Slabs {
    float below[3];  // from + the shape's high side, to be taken from a box's low side
    float above[3];  // from + the shape's low side
    float per_along[3];
};

HWY_INLINE Slabs slabs_of(const MeshSearch& search) noexcept {
    Slabs slabs;
    for (int axis = 0; axis < 3; ++axis) {
        const auto i = static_cast<glm::length_t>(axis);
        const double from = search.motion.from[i];
        const double along = search.motion.to[i] - from;
        const Vec& low = search.extent.min;
        const Vec& high = search.extent.max;
        const double low_side = axis == 0 ? low.x : (axis == 1 ? low.y : low.z);
        const double high_side = axis == 0 ? high.x : (axis == 1 ? high.y : high.z);
        const double least = 1e-30;  // less is standing still
        // Rounding in what follows: of three sums, a product and a quotient. Never so little that a box around who
        // stands still is left before the motion ends, or that floats lose it.
        const double margin =
            0x1p-20 * (absolute(from) + absolute(along) + magnitude_of(search.view->bounds)) + 100 * least;
        slabs.below[axis] = float_at_least(from + high_side + margin);
        slabs.above[axis] = float_at_most(from + low_side - margin);
        slabs.per_along[axis] = static_cast<float>(absolute(along) < least ? 1e30 : 1 / along);
    }
    return slabs;
}

// Which children's boxes the motion may enter before the limit, a bit each, and when.
HWY_INLINE std::uint32_t children_along(const WideNode& node, const Slabs& slabs, float limit,
                                        float (&times)[tree_width]) noexcept {
    const hn::CappedTag<float, tree_width> d;
    std::uint32_t bits = 0;
    for (std::size_t i = 0; i < tree_width; i += hn::Lanes(d)) {
        auto enter = hn::Zero(d);
        auto leave = hn::Set(d, limit);
        for (int axis = 0; axis < 3; ++axis) {
            const auto per_along = hn::Set(d, slabs.per_along[axis]);
            const auto low =
                hn::Mul(hn::Sub(decoded(d, node, axis, node.low[axis] + i), hn::Set(d, slabs.below[axis])), per_along);
            const auto high =
                hn::Mul(hn::Sub(decoded(d, node, axis, node.high[axis] + i), hn::Set(d, slabs.above[axis])), per_along);
            enter = hn::Max(enter, hn::Min(low, high));
            leave = hn::Min(leave, hn::Max(low, high));
        }
        hn::StoreU(enter, d, times + i);
        std::uint8_t mask[8] = {};
        hn::StoreMaskBits(d, hn::Le(enter, leave), mask);
        bits |= (mask[0] & ((1U << hn::Lanes(d)) - 1)) << i;
    }
    return bits & ((1U << (node.count < tree_width ? node.count : tree_width)) - 1);
}

}  // namespace HWY_NAMESPACE
}  // namespace surefoot::internal
HWY_AFTER_NAMESPACE();

#endif
