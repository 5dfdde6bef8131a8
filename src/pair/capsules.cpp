#include "pair/capsules.hpp"

#include "exact/products.hpp"

namespace surefoot::internal {

std::optional<CapsulePair> CapsulePair::of(const PlacedPair& pair) noexcept {
    const auto* a = std::get_if<Capsule>(&pair.a.shape());
    const auto* b = std::get_if<Capsule>(&pair.b.shape());
    if (a == nullptr || b == nullptr) return std::nullopt;
    CapsulePair capsules;
    capsules.half_a_ = pair.a.axis() * a->half_height;
    capsules.half_b_ = pair.b.axis() * b->half_height;
    capsules.radius_ = a->radius + b->radius;
    return capsules;
}

// x + s half_a - u half_b over -1 <= s, u <= 1: a convex quadratic in (s, u), whose least value is inside, by the 2 by
// 2 system, or on one of four sides, each a clamped quotient. All five are looked at; the smallest wins.
Gap CapsulePair::gap_at(const Vec& x) const noexcept {
    const double ss = dot(half_a_, half_a_);
    const double uu = dot(half_b_, half_b_);
    const auto clamped = [](double s) noexcept { return smaller(1, larger(-1, s)); };
    Vec best;
    double best_length = 1e300;
    const auto look = [&](double s, double u) noexcept {
        const Vec between = x + half_a_ * s - half_b_ * u;
        const double size = length(between);
        if (size < best_length) {
            best = between;
            best_length = size;
        }
    };
    for (const double end : {-1.0, 1.0}) {
        look(end, clamped(dot(x + half_a_ * end, half_b_) / uu));
        look(clamped(-dot(x - half_b_ * end, half_a_) / ss), end);
    }
    const Vec normal = accurate_cross(half_a_, half_b_);
    const double determinant = dot(normal, normal);
    const Vec across = unit(normal);
    Gap gap;
    if (determinant > 0) {
        const double s = -dot(normal, accurate_cross(x, half_b_)) / determinant;
        const double u = -dot(normal, accurate_cross(x, half_a_)) / determinant;
        if (absolute(s) <= 1 && absolute(u) <= 1) {
            // Axis over axis: their common normal keeps its digits when they cross.
            const double over = dot(across, x);
            gap.normal = over < 0 ? -across : across;
            gap.least = gap.most = absolute(over) - radius_;
            return gap;
        }
    }
    gap.normal = best_length > 0 ? unit(best) : across;
    if (gap.normal == Vec{}) {
        // Two parallel axes that overlap: any way across them.
        const Vec& h = half_a_;
        gap.normal = absolute(h.y) > absolute(h.x) ? unit({h.y, -h.x, 0}) : unit({-h.z, 0, h.x});
    }
    gap.least = gap.most = best_length - radius_;
    return gap;
}

}  // namespace surefoot::internal
