#include "pair/general.hpp"

#include "exact/products.hpp"
#include "pair/simplex.hpp"

namespace surefoot::internal {

namespace {

constexpr int most_supports = 80;

// Far apart, a rough plane is as good a place to stop as an exact one; near a touch it is the distance that counts.
constexpr double rough_share = 0x1p-20;

// Closer than this share of the sizes, the difference of the closest points has too few digits left for a direction.
constexpr double step_back_share = 0x1p-14;

}  // namespace

Closest GeneralPair::closest_at(const Vec& x) const noexcept {
    const Placed& a = pair_.a;
    const Placed& b = pair_.b;
    const double balls = a.radius() + b.radius();
    Simplex simplex;
    Vec away = largest(x) > 0 ? x : Vec{0, 1, 0};  // from b to a
    simplex.add(x + a.farthest(-away), b.farthest(away));
    Vec v = simplex.reduce();
    Closest result;
    result.gap.least = -1e300;
    const double smallest = hair_ * 0x1p-6;
    for (int i = 0; i < most_supports; ++i) {
        const double distance = length(v);
        if (simplex.holds_origin || distance <= smallest) {
            result.gap.is_deep = true;
            break;
        }
        const Vec n = v / distance;
        const Vec on_a = x + a.farthest(-n);
        const Vec on_b = b.farthest(n);
        const double least = dot(n, on_a - on_b);
        if (least > result.gap.least) {
            result.gap.least = least;
            result.gap.normal = n;
        }
        result.gap.most = distance;
        if (distance - result.gap.least <= larger(hair_ / 8, rough_share * (distance - balls))) break;
        if (simplex.has(on_a - on_b)) break;
        const Simplex before = simplex;
        simplex.add(on_a, on_b);
        v = simplex.reduce();
        // A plane between the two outweighs a flat simplex that seems to hold the origin; and if it came no nearer,
        // rounding has the last word.
        const bool is_refuted = simplex.holds_origin ? result.gap.least > smallest : !(length(v) < distance);
        if (is_refuted) {
            simplex = before;
            break;
        }
    }
    for (int i = 0; i < simplex.count; ++i) {
        result.on_a = result.on_a + simplex.corner[i].on_a * simplex.corner[i].weight;
        result.on_b = result.on_b + simplex.corner[i].on_b * simplex.corner[i].weight;
    }
    if (result.gap.is_deep) {
        result.gap.least = result.gap.most = 0;
        if (result.gap.normal == Vec{}) result.gap.normal = unit(away);
    }
    result.gap.least -= balls;
    result.gap.most -= balls;
    return result;
}

Gap GeneralPair::gap_at(const Vec& x) const noexcept {
    Gap gap = closest_at(x).gap;
    const double balls = pair_.a.radius() + pair_.b.radius();
    const double step_back = step_back_share * (pair_.a.size() + pair_.b.size());
    if (gap.is_deep || gap.most + balls > step_back) return gap;
    // From a step back the same features are closest, and their normal has its digits.
    const Gap from_afar = closest_at(x + gap.normal * step_back).gap;
    const double least = pair_.gap_along(from_afar.normal, x);
    if (!from_afar.is_deep && least > gap.least) {
        gap.least = least;
        gap.normal = from_afar.normal;
    }
    return gap;
}

}  // namespace surefoot::internal
