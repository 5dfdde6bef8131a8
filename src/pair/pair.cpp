
#include <surefoot/pair.hpp>

#include "exact/products.hpp"
#include "ieee_guard.hpp"
#include "limits.hpp"
#include "overloaded.hpp"
#include "pair/advance.hpp"
#include "pair/boxes.hpp"
#include "pair/capsules.hpp"
#include "pair/ellipsoids.hpp"
#include "pair/general.hpp"
#include "pair/upright.hpp"
#include "pair/way_out.hpp"

namespace surefoot {
inline namespace v0 {

namespace {

using namespace internal;

bool is_before(double a, double b, bool& decided) noexcept {
    decided = a != b;
    return a < b;
}

// An order of two shapes that does not depend on which the caller named first, so that swapping them changes no bit.
// Equal shapes are ordered by where they are: `x` is the first one's place, seen from the second.
bool is_swapped(const Volume& a, const Volume& b, const Vec& x, const Vec& motion) noexcept {
    if (a.shape.index() != b.shape.index()) return b.shape.index() < a.shape.index();
    const auto numbers = [](const Volume& volume, double(&to)[7]) noexcept {
        std::visit(Overloaded{
                       [&](const Sphere& s) noexcept { to[0] = s.radius; },
                       [&](const Ellipsoid& s) noexcept { to[0] = s.radii.x, to[1] = s.radii.y, to[2] = s.radii.z; },
                       [&](const Capsule& s) noexcept { to[0] = s.radius, to[1] = s.half_height; },
                       [&](const Box& s) noexcept {
                           to[0] = s.half_extents.x, to[1] = s.half_extents.y, to[2] = s.half_extents.z;
                       },
                       [&](const Cylinder& s) noexcept { to[0] = s.radius, to[1] = s.half_height; },
                       [&](const Cone& s) noexcept { to[0] = s.radius, to[1] = s.height; },
                   },
                   volume.shape);
        to[3] = volume.orientation.w;
        to[4] = volume.orientation.x;
        to[5] = volume.orientation.y;
        to[6] = volume.orientation.z;
    };
    double of_a[7] = {};
    double of_b[7] = {};
    numbers(a, of_a);
    numbers(b, of_b);
    bool decided = false;
    for (int i = 0; i < 7; ++i) {
        const bool less = is_before(of_b[i], of_a[i], decided);
        if (decided) return less;
    }
    for (const Vec& v : {x, motion}) {
        if (!(v == Vec{})) return lexicographically_less(v, -v);
    }
    return false;
}

// Of the distance and the motion, where they dwarf the shapes [dimensionless].
constexpr double rounding_share = 0x1p-44;

// The relative question: the second shape stands at the origin.
struct Relative {
    PlacedPair pair;
    Vec x;       ///< where the first one is
    Vec motion;  ///< how it moves, seen from the second
    double hair = 0;
    bool swapped = false;
};

Relative relative(const Volume& a, const Vec& x, const Volume& b, const Vec& motion) noexcept {
    const bool swapped = is_swapped(a, b, x, motion);
    return {.pair = {Placed(swapped ? b : a), Placed(swapped ? a : b)},
            .x = swapped ? -x : x,
            .motion = swapped ? -motion : motion,
            .swapped = swapped};
}

// The family that knows these two best. Its hair goes into `r`.
template <typename Use>
auto with_family(Relative& r, const Use& use) noexcept {
    const double sizes = r.pair.a.size() + r.pair.b.size();
    const double rounding = rounding_share * larger(largest(r.x), largest(r.motion));
    r.hair = larger(pair_tolerance * sizes, rounding);
    if (const auto upright = UprightPair::of(r.pair)) return use(*upright);
    if (const auto boxes = BoxPair::of(r.pair)) return use(*boxes);
    if (const auto capsules = CapsulePair::of(r.pair)) return use(*capsules);
    if (const auto ellipsoids = SimilarEllipsoids::of(r.pair)) return use(*ellipsoids);
    r.hair = larger(pair_search_tolerance * sizes, rounding);
    return use(GeneralPair(r.pair, r.hair));
}

// Out of two cores that overlap deeper than their family can tell. This is a search, whatever the family.
std::optional<Gap> deep_way_out(const Relative& r) noexcept {
    const double hair = larger(r.hair, pair_search_tolerance * (r.pair.a.size() + r.pair.b.size()));
    return way_out(GeneralPair(r.pair, hair), r.pair, r.x, hair);
}

bool has_closest(const Shape& shape) noexcept {
    return !std::holds_alternative<Ellipsoid>(shape) && !std::holds_alternative<Cone>(shape);
}

// Where two shapes touch that are all but touching, relative to the second. Alternating projections, from a middle: for
// faces that lie on each other that finds the point below it and not some corner. Where two round sides make that slow,
// and for shapes without a closed projection, GJK.
Vec touching_point(const Relative& r, const Vec& x) noexcept {
    const Placed& a = r.pair.a;
    const Placed& b = r.pair.b;
    // Balls keep the cores apart, so that the way from one to the other is known well.
    const auto on_ball = [&](const Vec& on_a, const Vec& on_b) noexcept {
        return b.radius() > 0 ? on_b + unit(on_a - on_b) * b.radius() : on_b;
    };
    if (has_closest(a.shape()) && has_closest(b.shape())) {
        const double touching = a.radius() + b.radius() + 4 * r.hair;
        const bool from_b = std::holds_alternative<Box>(a.shape()) && !std::holds_alternative<Box>(b.shape());
        Vec on_b = b.closest_of_core(from_b ? x + a.closest_of_core(-x) : x);
        for (int i = 0; i < 8; ++i) {
            const Vec on_a = x + a.closest_of_core(on_b - x);
            on_b = b.closest_of_core(on_a);
            if (length(on_a - on_b) <= touching) return on_ball(on_a, on_b);
        }
    }
    const Closest closest = GeneralPair(r.pair, r.hair).closest_at(x);
    return on_ball(closest.on_a, closest.on_b);
}

// `at` is where the caller's second shape is.
dvec3 to_caller(const Relative& r, const Vec& x, const Vec& point, const Vec& at) noexcept {
    // Seen from the caller's second shape, which after a swap is the one at x.
    return to_dvec3(at + (r.swapped ? point - x : point));
}

dvec3 normal_to_caller(const Relative& r, const Vec& normal) noexcept {
    return to_dvec3(r.swapped ? -normal : normal);
}

bool is_valid_motion(const Motion& motion) noexcept {
    return is_valid_point(motion.from) && is_valid_point(motion.to);
}

PairHit blocked_pair(HitStatus status) noexcept {
    PairHit hit;
    hit.status = status;
    return hit;
}

}  // namespace

std::optional<PairOverlap> pair_overlap(const Volume& a, const dvec3& position_a, const Volume& b,
                                        const dvec3& position_b) noexcept {
    const IeeeGuard guard;
    PairOverlap result;
    if (!is_valid(a) || !is_valid(b) || !is_valid_point(position_a) || !is_valid_point(position_b)) {
        result.status = HitStatus::invalid;
        return result;
    }
    Relative r = relative(a, to_vec(position_a) - to_vec(position_b), b, {});
    Gap gap = with_family(r, [&](const auto& pairing) noexcept { return pairing.gap_at(r.x); });
    if (gap.is_deep) {
        const auto way = deep_way_out(r);
        if (!way) {
            result.status = HitStatus::overflow;
            return result;
        }
        gap = *way;
    }
    if (gap.most > r.hair) return std::nullopt;
    result.depth = larger(0, -gap.least);
    result.normal = normal_to_caller(r, gap.normal);
    // Parted, seen from the one that stays: for the caller that is his second shape.
    const Vec parted = r.x + gap.normal * result.depth;
    result.point = to_caller(r, parted, touching_point(r, parted), to_vec(position_b));
    return result;
}

std::optional<PairHit> pair_sweep(const Volume& a, const Motion& motion_a, const Volume& b,
                                  const Motion& motion_b) noexcept {
    const IeeeGuard guard;
    if (!is_valid(a) || !is_valid(b) || !is_valid_motion(motion_a) || !is_valid_motion(motion_b)) {
        return blocked_pair(HitStatus::invalid);
    }
    const Vec motion_of_b = to_vec(motion_b.to) - to_vec(motion_b.from);
    Relative r = relative(a, to_vec(motion_a.from) - to_vec(motion_b.from), b,
                          (to_vec(motion_a.to) - to_vec(motion_a.from)) - motion_of_b);
    if (r.motion == Vec{}) return std::nullopt;

    bool is_free = false;
    const Advance advanced = with_family(r, [&](const auto& pairing) noexcept {
        Advance way = advance(pairing, r.pair, r.x, r.motion, r.hair);
        if (way.outcome == Advance::Outcome::starts_touching) {
            if (way.gap.is_deep) {
                const auto out = deep_way_out(r);
                if (!out) {
                    way.outcome = Advance::Outcome::overflows;
                    return way;
                }
                way.gap = *out;
            }
            is_free = !goes_deeper(pairing, r.pair, r.x, r.motion, way.gap, r.hair);
        }
        return way;
    });
    if (advanced.outcome == Advance::Outcome::overflows) return blocked_pair(HitStatus::overflow);
    if (advanced.outcome == Advance::Outcome::free || is_free) return std::nullopt;

    PairHit hit;
    hit.t = advanced.t;
    hit.normal = normal_to_caller(r, advanced.gap.normal);
    hit.started_inside = advanced.outcome == Advance::Outcome::starts_touching;
    const Vec x = r.x + r.motion * hit.t;
    hit.point = to_caller(r, x, touching_point(r, x), to_vec(motion_b.from) + motion_of_b * hit.t);
    return hit;
}

std::optional<PairHit> pair_sweep(const Volume& a, const Motion& motion_a, const Volume& b,
                                  const dvec3& position_b) noexcept {
    return pair_sweep(a, motion_a, b, Motion{.from = position_b, .to = position_b});
}

}  // namespace v0
}  // namespace surefoot
