// The float filter: eight triangles against a moving shape. Included once for each SIMD target.
//
// In the scaled space the shape lies in a box of half extent 1 about its centre. A direction n separates shape and
// triangle at a time x if
//
//     gap(n) = n . x - max over the triangle of n . v - max over the shape of -n . k  >  margin,
//
// whatever n is and however inexactly it was found; only this sum has to be bounded. With W the largest component of a
// corner, U that of the motion and 2 that of the shape, its products and sums err by less than 2^-20 |n|_1 (W + U + 2);
// the corners themselves by less than |rows of to_scaled| (2^-23 F + 2^-21 P), F the size of `from` and P that of the
// corner relative to it, both in the world. Overflow makes the margin infinite or the gap NaN: both keep the triangle.
#if defined(SUREFOOT_TRIANGLE_FILTER_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SUREFOOT_TRIANGLE_FILTER_INL_HPP
#undef SUREFOOT_TRIANGLE_FILTER_INL_HPP
#else
#define SUREFOOT_TRIANGLE_FILTER_INL_HPP
#endif

#include <hwy/highway.h>

#include "kernels/mesh_search.hpp"

HWY_BEFORE_NAMESPACE();
namespace surefoot::internal {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using FilterTag = hn::CappedTag<float, tree_width>;
using Floats = hn::Vec<FilterTag>;

struct Vec3 {
    Floats x;
    Floats y;
    Floats z;
};

HWY_INLINE Vec3 sub(const Vec3& a, const Vec3& b) noexcept {
    return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}
HWY_INLINE Vec3 opposite(const Vec3& a) noexcept {
    return {hn::Neg(a.x), hn::Neg(a.y), hn::Neg(a.z)};
}
HWY_INLINE Vec3 times(const Vec3& a, Floats s) noexcept {
    return {hn::Mul(a.x, s), hn::Mul(a.y, s), hn::Mul(a.z, s)};
}
HWY_INLINE Vec3 add_times(const Vec3& a, const Vec3& b, Floats s) noexcept {
    return {hn::MulAdd(b.x, s, a.x), hn::MulAdd(b.y, s, a.y), hn::MulAdd(b.z, s, a.z)};
}
HWY_INLINE Floats inner(const Vec3& a, const Vec3& b) noexcept {
    return hn::MulAdd(a.x, b.x, hn::MulAdd(a.y, b.y, hn::Mul(a.z, b.z)));
}
HWY_INLINE Vec3 outer(const Vec3& a, const Vec3& b) noexcept {
    return {hn::MulSub(a.y, b.z, hn::Mul(a.z, b.y)), hn::MulSub(a.z, b.x, hn::Mul(a.x, b.z)),
            hn::MulSub(a.x, b.y, hn::Mul(a.y, b.x))};
}
HWY_INLINE Floats size(const Vec3& a) noexcept {
    return hn::Max(hn::Abs(a.x), hn::Max(hn::Abs(a.y), hn::Abs(a.z)));
}
HWY_INLINE Vec3 choose(hn::Mask<FilterTag> first, const Vec3& a, const Vec3& b) noexcept {
    return {hn::IfThenElse(first, a.x, b.x), hn::IfThenElse(first, a.y, b.y), hn::IfThenElse(first, a.z, b.z)};
}
HWY_INLINE Vec3 all_lanes(const float (&v)[3]) noexcept {
    const FilterTag d;
    return {hn::Set(d, v[0]), hn::Set(d, v[1]), hn::Set(d, v[2])};
}

// A point of each triangle near the one that is nearest to the origin; how near does not matter. With p = a + v ab +
// w ac, the squared distance is a quadratic form in v and w: of its minimum, if that is inside, and those on the three
// edges, the least is taken.
HWY_INLINE Vec3 nearest_to_origin(const Vec3 (&v)[3]) noexcept {
    const FilterTag d;
    const auto zero = hn::Zero(d);
    const auto one = hn::Set(d, 1.0F);
    const auto least = hn::Set(d, 1e-30F);
    const auto clamped = [&](Floats share) HWY_ATTR { return hn::Min(one, hn::Max(zero, share)); };
    const Vec3 ab = sub(v[1], v[0]);
    const Vec3 ac = sub(v[2], v[0]);
    const auto bb = inner(ab, ab);
    const auto bc = inner(ab, ac);
    const auto cc = inner(ac, ac);
    const auto b = hn::Neg(inner(ab, v[0]));
    const auto c = hn::Neg(inner(ac, v[0]));
    // Along ab, along ac, and from b to c, less the squared distance of a.
    const auto on_ab = clamped(hn::Div(b, hn::Max(bb, least)));
    const auto on_ac = clamped(hn::Div(c, hn::Max(cc, least)));
    const auto across = hn::Sub(hn::Add(bb, cc), hn::Add(bc, bc));
    const auto onward = hn::Add(hn::Sub(c, b), hn::Sub(bb, bc));
    const auto on_bc = clamped(hn::Div(onward, hn::Max(across, least)));
    const auto square_ab = hn::Mul(on_ab, hn::NegMulAdd(hn::Set(d, 2.0F), b, hn::Mul(on_ab, bb)));
    const auto square_ac = hn::Mul(on_ac, hn::NegMulAdd(hn::Set(d, 2.0F), c, hn::Mul(on_ac, cc)));
    const auto square_b = hn::NegMulAdd(hn::Set(d, 2.0F), b, bb);
    const auto square_bc = hn::MulAdd(on_bc, hn::NegMulAdd(hn::Set(d, 2.0F), onward, hn::Mul(on_bc, across)), square_b);
    const auto ac_is_nearer = hn::Lt(square_ac, square_ab);
    const auto bc_is_nearest = hn::Lt(square_bc, hn::Min(square_ab, square_ac));
    auto to_b = hn::IfThenElse(ac_is_nearer, zero, on_ab);
    auto to_c = hn::IfThenElse(ac_is_nearer, on_ac, zero);
    to_b = hn::IfThenElse(bc_is_nearest, hn::Sub(one, on_bc), to_b);
    to_c = hn::IfThenElse(bc_is_nearest, on_bc, to_c);
    const auto determinant = hn::NegMulAdd(bc, bc, hn::Mul(bb, cc));
    const auto inside_b = hn::MulSub(cc, b, hn::Mul(bc, c));
    const auto inside_c = hn::MulSub(bb, c, hn::Mul(bc, b));
    // A sliver's determinant is noise.
    const auto inside = hn::And(hn::And(hn::Gt(inside_b, zero), hn::Gt(inside_c, zero)),
                                hn::And(hn::Lt(hn::Add(inside_b, inside_c), determinant),
                                        hn::Gt(determinant, hn::Mul(hn::Set(d, 1e-5F), hn::Mul(bb, cc)))));
    const auto per_determinant = hn::Div(one, hn::Max(determinant, least));
    to_b = hn::IfThenElse(inside, hn::Mul(inside_b, per_determinant), to_b);
    to_c = hn::IfThenElse(inside, hn::Mul(inside_c, per_determinant), to_c);
    return add_times(add_times(v[0], ab, to_b), ac, to_c);
}

// The largest -n . k over the scaled shape.
HWY_INLINE Floats reach(const ShapeFilter& filter, const Vec3& n) noexcept {
    const FilterTag d;
    switch (filter.kind) {
        case FilterKind::ball:
            return hn::Sqrt(inner(n, n));
        case FilterKind::box:
            return hn::Add(hn::Abs(n.x), hn::Add(hn::Abs(n.y), hn::Abs(n.z)));
        case FilterKind::capsule: {
            const Vec3 world = {hn::Mul(n.x, hn::Set(d, filter.per_extent[0])),
                                hn::Mul(n.y, hn::Set(d, filter.per_extent[1])),
                                hn::Mul(n.z, hn::Set(d, filter.per_extent[2]))};
            return hn::MulAdd(hn::Abs(world.y), hn::Set(d, filter.half_height),
                              hn::Mul(hn::Sqrt(inner(world, world)), hn::Set(d, filter.radius)));
        }
        case FilterKind::cylinder:
            return hn::Add(hn::Abs(n.y), hn::Sqrt(hn::MulAdd(n.x, n.x, hn::Mul(n.z, n.z))));
        case FilterKind::cone: {
            const auto rim = hn::Sub(hn::Sqrt(hn::MulAdd(n.x, n.x, hn::Mul(n.z, n.z))), hn::Add(n.y, n.y));
            return hn::Max(hn::Zero(d), rim);
        }
        case FilterKind::point:
            break;
    }
    return hn::Zero(d);
}

// What one direction says.
struct Gaps {
    hn::Mask<FilterTag> apart;  // over the whole motion
    Floats t;                   // before this there is a gap
};

struct Scaled {
    Vec3 corner[3];
    Vec3 motion;
    Floats margin;  // for each unit of |n|_1
};

HWY_INLINE Gaps ask(const ShapeFilter& filter, const Scaled& triangle, const Vec3& direction) noexcept {
    const FilterTag d;
    const auto zero = hn::Zero(d);
    const auto norm = hn::Add(hn::Abs(direction.x), hn::Add(hn::Abs(direction.y), hn::Abs(direction.z)));
    const auto top = hn::Max(inner(direction, triangle.corner[0]),
                             hn::Max(inner(direction, triangle.corner[1]), inner(direction, triangle.corner[2])));
    const auto taken = hn::MulAdd(norm, triangle.margin, hn::Add(top, reach(filter, direction)));
    const auto at_from = hn::Neg(taken);
    const auto at_to = hn::Sub(inner(direction, triangle.motion), taken);
    // Below this, products may vanish.
    const auto sound = hn::Gt(norm, hn::Set(d, 1e-18F));
    const auto apart_at_from = hn::And(sound, hn::Gt(at_from, zero));
    const auto apart = hn::And(apart_at_from, hn::Gt(at_to, zero));
    const auto t = hn::Mul(hn::Div(at_from, hn::Sub(at_from, at_to)), hn::Set(d, 1 - 0x1p-20F));
    return {apart, hn::IfThenElseZero(apart_at_from, hn::Max(zero, t))};
}

HWY_INLINE Vec3 scaled(const ShapeFilter& filter, const Vec3& p) noexcept {
    const FilterTag d;
    const auto entry = [&](int i, int j) HWY_ATTR { return hn::Set(d, filter.to_scaled[i][j]); };
    if (filter.is_diagonal) return {hn::Mul(p.x, entry(0, 0)), hn::Mul(p.y, entry(1, 1)), hn::Mul(p.z, entry(2, 2))};
    const auto row = [&](int i) HWY_ATTR { return inner(p, {entry(i, 0), entry(i, 1), entry(i, 2)}); };
    return {row(0), row(1), row(2)};
}

// Which of up to eight triangles may be met, a bit each, and a time for each before which it is not. `load(i, lane)`
// gives corner i of the triangles from `lane` on, relative to `from`, whose largest component is `from_size`.
template <bool long_motion, class Load>
HWY_INLINE std::uint32_t survivors(const ShapeFilter& filter, const Load& load, std::size_t count, float from_size,
                                   float limit, float (&times_out)[tree_width]) noexcept {
    const FilterTag d;
    const auto zero = hn::Zero(d);
    const Vec3 centre = all_lanes(filter.centre);
    std::uint32_t bits = 0;
    for (std::size_t lane = 0; lane < count; lane += hn::Lanes(d)) {
        const Vec3 world[3] = {load(0, lane), load(1, lane), load(2, lane)};
        const Vec3 corner[3] = {scaled(filter, world[0]), scaled(filter, world[1]), scaled(filter, world[2])};
        const auto far = hn::Max(size(world[0]), hn::Max(size(world[1]), size(world[2])));
        const auto far_scaled = hn::Max(size(corner[0]), hn::Max(size(corner[1]), size(corner[2])));
        const auto input = hn::Mul(hn::Set(d, filter.row_sum),
                                   hn::MulAdd(far, hn::Set(d, 0x1p-21F), hn::Set(d, from_size * 0x1p-23F)));
        const auto sums = hn::Add(far_scaled, hn::Set(d, filter.motion_size + 2));
        const Scaled triangle{
            {corner[0], corner[1], corner[2]}, all_lanes(filter.motion), hn::MulAdd(sums, hn::Set(d, 0x1p-20F), input)};

        // From the nearest point of the triangle to the shape: in the middle of its motion and then where that point is
        // nearest to the path or, where the motion is long, to its whole line as seen along it and then at its start.
        const auto towards = [&](const Vec3& place) HWY_ATTR {
            const Vec3 seen[3] = {sub(corner[0], place), sub(corner[1], place), sub(corner[2], place)};
            return nearest_to_origin(seen);
        };
        const auto squared = hn::Max(inner(triangle.motion, triangle.motion), hn::Set(d, 1e-30F));
        const auto towards_line = [&]() HWY_ATTR {
            const auto flat = [&](int i) HWY_ATTR {
                const Vec3 relative = sub(corner[i], centre);
                const auto share = hn::Neg(hn::Div(inner(relative, triangle.motion), squared));
                return add_times(relative, triangle.motion, share);
            };
            const Vec3 seen[3] = {flat(0), flat(1), flat(2)};
            return nearest_to_origin(seen);
        };
        const auto towards_path = [&](const Vec3& from_middle) HWY_ATTR {
            const auto past_middle = hn::Div(inner(from_middle, triangle.motion), squared);
            const auto share = hn::Min(hn::Set(d, 1.0F), hn::Max(zero, hn::Add(past_middle, hn::Set(d, 0.5F))));
            return towards(add_times(centre, triangle.motion, share));
        };
        // What is out by one direction need not be asked along the next, and often that is all of them.
        auto t = zero;
        auto out = hn::Not(hn::FirstN(d, count - lane));
        const auto are_all_out_by = [&](const Vec3& direction) HWY_ATTR {
            const Gaps gaps = ask(filter, triangle, direction);
            t = hn::Max(t, gaps.t);
            out = hn::Or(out, hn::Or(gaps.apart, hn::Gt(t, hn::Set(d, limit))));
            return hn::AllTrue(d, out);
        };
        const Vec3 first = long_motion ? towards_line() : towards(add_times(centre, triangle.motion, hn::Set(d, 0.5F)));
        if (are_all_out_by(opposite(first))) continue;
        // From the triangle's own plane, on the side where the shape begins.
        const Vec3 normal =
            outer(sub(triangle.corner[1], triangle.corner[0]), sub(triangle.corner[2], triangle.corner[0]));
        const auto behind = hn::Lt(inner(normal, sub(centre, triangle.corner[0])), zero);
        if (are_all_out_by(choose(behind, opposite(normal), normal))) continue;
        if (are_all_out_by(opposite(long_motion ? towards(centre) : towards_path(first)))) continue;
        hn::StoreU(t, d, times_out + lane);
        std::uint8_t mask[8] = {};
        hn::StoreMaskBits(d, out, mask);
        bits |= (~mask[0] & ((1U << hn::Lanes(d)) - 1)) << lane;
    }
    return bits;
}

}  // namespace HWY_NAMESPACE
}  // namespace surefoot::internal
HWY_AFTER_NAMESPACE();

#endif
