#include "character/alike.hpp"

#include <cmath>

namespace surefoot::internal {

namespace {

// What is in touch to within this counts as in touch, as a share of both radii: some roundings of the place where the
// last sweep has ended.
constexpr double touching = 1e-9;

}  // namespace

std::optional<AlikeEllipsoids> AlikeEllipsoids::of(const Volume& a, const Volume& b, double by) noexcept {
    const auto* first = std::get_if<Ellipsoid>(&a.shape);
    const auto* second = std::get_if<Ellipsoid>(&b.shape);
    if (first == nullptr || second == nullptr || !(to_vec(first->radii) == to_vec(second->radii))) return std::nullopt;
    const dquat& p = a.orientation;
    const dquat& q = b.orientation;
    if (p.w != q.w || p.x != q.x || p.y != q.y || p.z != q.z) return std::nullopt;
    return AlikeEllipsoids(*first, p, by);
}

AlikeEllipsoids::AlikeEllipsoids(const Ellipsoid& ellipsoid, const dquat& orientation, double by) noexcept
    : frame_(orientation), radii_(to_vec(ellipsoid.radii)) {
    radii_ = radii_ * (2 + by / smaller(radii_.x, smaller(radii_.y, radii_.z)));
}

// On the ellipsoid x^2/r^2 = 1 the normal is along x/r^2. By the least radius first, so that nothing overflows.
Vec AlikeEllipsoids::normal_at(const Vec& squashed) const noexcept {
    const double least = smaller(radii_.x, smaller(radii_.y, radii_.z));
    const Vec normal = divide_each(squashed * least, radii_);
    const double size = length(normal);
    return frame_.to_world(size > 0 ? normal / size : Vec{1, 0, 0});
}

std::optional<AlikeEllipsoids::Meeting> AlikeEllipsoids::sweep(const Vec& from, const Vec& motion) const noexcept {
    const Vec x = divide_each(frame_.to_local(from), radii_);
    const Vec v = divide_each(frame_.to_local(motion), radii_);
    const double b = dot(x, v);
    if (b >= 0) return std::nullopt;  // not coming nearer
    const double a = dot(v, v);
    const double c = dot(x, x) - 1;
    double t = 0;
    if (c > touching) {
        const Vec nearest = x - v * (b / a);
        const double left = 1 - dot(nearest, nearest);
        if (left <= 0) return std::nullopt;
        t = c / (std::sqrt(a * left) - b);
        if (t > 1) return std::nullopt;
    }
    const Vec touch = x + v * t;
    return Meeting{t, normal_at(touch), frame_.to_world(multiply_each(touch, radii_) * 0.5)};
}

std::optional<AlikeEllipsoids::Overlap> AlikeEllipsoids::overlap(const Vec& from) const noexcept {
    const Vec x = divide_each(frame_.to_local(from), radii_);
    const double c = dot(x, x) - 1;
    if (c > 0) return std::nullopt;
    const Vec normal = normal_at(x);
    const Vec v = divide_each(frame_.to_local(normal), radii_);
    const double a = dot(v, v);
    const double b = dot(x, v);
    return Overlap{normal, -c / (b + std::sqrt(b * b - a * c))};
}

}  // namespace surefoot::internal
