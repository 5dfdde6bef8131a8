// The sum of two such ellipsoids is an ellipsoid again, radii added, and divided by these it is the unit ball: with
// s = |x / R| they touch when s <= 1, and a point that moves enters at the smaller root of a quadratic.
//
// The distance itself would be a root of degree six. It is not needed: the plane through the surface at x / s, of
// normal x / R^2, proves a gap, and the point x / s shows that it is no more than |x - x / s|. Both go to 0 together.
#include "pair/ellipsoids.hpp"

#include "exact/products.hpp"

namespace surefoot::internal {

namespace {

// Parallel or in proportion to rounding.
constexpr double similar_hair = 0x1p-50;

// Less than half of the tolerance of a closed form.
constexpr double touching_share = 0x1p-32;

bool are_parallel(const Vec& a, const Vec& b) noexcept {
    return largest(cross(a, b)) <= similar_hair * largest(a) * largest(b);
}

}  // namespace

std::optional<SimilarEllipsoids> SimilarEllipsoids::of(const PlacedPair& pair) noexcept {
    const auto* a = std::get_if<Ellipsoid>(&pair.a.shape());
    const auto* b = std::get_if<Ellipsoid>(&pair.b.shape());
    if (a == nullptr || b == nullptr) return std::nullopt;
    const Vec radii_a = to_vec(a->radii);
    const Vec radii_b = to_vec(b->radii);
    for (const Vec& axis : {Vec{1, 0, 0}, Vec{0, 1, 0}}) {
        if (!are_parallel(pair.a.frame().to_world(axis), pair.b.frame().to_world(axis))) return std::nullopt;
    }
    // In proportion: every pair of radii by itself, so that a flat one is as exact as a round one.
    const double ratio = radii_a.x / radii_b.x;
    for (const double other : {radii_a.y / radii_b.y, radii_a.z / radii_b.z}) {
        if (absolute(other - ratio) > similar_hair * ratio) return std::nullopt;
    }
    return SimilarEllipsoids(pair.b.frame(), radii_a + radii_b);
}

Gap SimilarEllipsoids::gap_at(const Vec& x) const noexcept {
    const Vec p = frame_.to_local(x);
    const Vec squashed = divide_each(p, radii_);
    const double s = length(squashed);
    Gap gap;
    const Vec n = unit(divide_each(squashed, radii_));
    if (n == Vec{} || s < 1 - touching_share) {
        // Inside, the way out along this normal need not be the shortest; as shallow as this it does not matter.
        gap.normal = n == Vec{} ? frame_.to_world({0, 1, 0}) : frame_.to_world(n);
        gap.is_deep = true;
        return gap;
    }
    gap.normal = frame_.to_world(n);
    gap.least = (s - 1) * length(multiply_each(n, radii_));
    gap.most = (1 - 1 / s) * length(p);
    return gap;
}

double SimilarEllipsoids::guess_entry(const Vec& x, const Vec& motion) const noexcept {
    const Vec from = divide_each(frame_.to_local(x), radii_);
    const Vec along = divide_each(frame_.to_local(motion), radii_);
    const double a = dot(along, along);
    const double b = dot(from, along);
    const double c = dot(from, from) - 1;
    const double discriminant = difference_of_products(b, b, a, c);
    if (!(b < 0) || discriminant < 0) return 0;
    return c / (std::sqrt(discriminant) - b);
}

}  // namespace surefoot::internal
