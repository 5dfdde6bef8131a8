// Each shape is convex, so a line is in it from one time to another. For a shape that is the common part of simpler
// ones (a box of three slabs, a cylinder of a slab and a round column, a cone of a slab and a nappe) these times are
// the last of the entries and the first of the exits. A capsule is the union of a cylinder and two balls: the first of
// the entries, the last of the exits.
#include "hitboxes/ray_shape.hpp"

#include <cmath>
#include <limits>

#include "overloaded.hpp"

namespace surefoot::internal {

namespace {

constexpr double forever = std::numeric_limits<double>::infinity();

// The times at which a line is inside, and the unit normal where it comes in. Empty if `enter` > `exit`.
struct Inside {
    double enter = -forever;
    double exit = forever;
    Vec normal;

    [[nodiscard]] bool empty() const noexcept { return enter > exit; }
};

constexpr Inside nowhere{forever, -forever, {}};

Inside common(const Inside& a, const Inside& b) noexcept {
    const bool later = b.enter > a.enter;
    return {later ? b.enter : a.enter, smaller(a.exit, b.exit), later ? b.normal : a.normal};
}

Inside either(const Inside& a, const Inside& b) noexcept {
    if (a.empty()) return b;
    if (b.empty()) return a;
    const bool earlier = b.enter < a.enter;
    return {earlier ? b.enter : a.enter, larger(a.exit, b.exit), earlier ? b.normal : a.normal};
}

// Between two planes across one axis.
Inside in_slab(double from, double along, double low, double high, const Vec& axis) noexcept {
    if (along == 0) return from >= low && from <= high ? Inside{} : nowhere;
    const double to_low = (low - from) / along;
    const double to_high = (high - from) / along;
    return along > 0 ? Inside{to_low, to_high, -axis} : Inside{to_high, to_low, axis};
}

Vec unit_or_zero(const Vec& v) noexcept {
    const double size = length(v);
    return size > 0 ? v / size : Vec{};
}

// The roots of a t^2 + 2 b t + c, a > 0: between them the line is within a ball or a column. The square of half their
// distance is what is left of the radius at the closest point, which has no cancellation of large numbers in it.
struct Roots {
    double first;
    double second;
};

std::optional<Roots> within(const Vec& from, const Vec& along, double radius) noexcept {
    const double a = dot(along, along);
    const double closest = -dot(from, along) / a;
    const Vec nearest = from + along * closest;
    const double left = radius * radius - dot(nearest, nearest);
    if (left < 0) return std::nullopt;
    const double half = std::sqrt(left / a);
    return Roots{closest - half, closest + half};
}

Inside in_ball(const Vec& centre, double radius, const Vec& from, const Vec& along) noexcept {
    if (along == Vec{}) return length(from - centre) <= radius ? Inside{} : nowhere;
    const auto roots = within(from - centre, along, radius);
    if (!roots) return nowhere;
    return {roots->first, roots->second, unit_or_zero(from - centre + along * roots->first)};
}

// A round column without ends about the y axis.
Inside in_column(double radius, const Vec& from, const Vec& along) noexcept {
    const Vec place{from.x, 0, from.z};
    const Vec way{along.x, 0, along.z};
    return in_ball({}, radius, place, way);
}

Inside in_ellipsoid(const Ellipsoid& ellipsoid, const Vec& from, const Vec& along) noexcept {
    const Vec radii = to_vec(ellipsoid.radii);
    Inside inside = in_ball({}, 1, divide_each(from, radii), divide_each(along, radii));
    // The squashed normal n becomes n / r in the world. By the least radius first, so that nothing overflows.
    const double least = smaller(radii.x, smaller(radii.y, radii.z));
    inside.normal = unit_or_zero(divide_each(inside.normal * least, radii));
    return inside;
}

Inside in_box(const Box& box, const Vec& from, const Vec& along) noexcept {
    const Vec half = to_vec(box.half_extents);
    return common(common(in_slab(from.x, along.x, -half.x, half.x, {1, 0, 0}),
                         in_slab(from.y, along.y, -half.y, half.y, {0, 1, 0})),
                  in_slab(from.z, along.z, -half.z, half.z, {0, 0, 1}));
}

Inside in_cylinder(double radius, double half_height, const Vec& from, const Vec& along) noexcept {
    return common(in_slab(from.y, along.y, -half_height, half_height, {0, 1, 0}), in_column(radius, from, along));
}

Inside in_capsule(const Capsule& capsule, const Vec& from, const Vec& along) noexcept {
    const Vec end{0, capsule.half_height, 0};
    const Inside balls = either(in_ball(end, capsule.radius, from, along), in_ball(-end, capsule.radius, from, along));
    if (!(capsule.half_height > 0)) return balls;
    const Inside middle = in_cylinder(capsule.radius, capsule.half_height, from, along);
    // Through a flat end the cylinder is entered inside of a ball, but left where no ball may be.
    if (middle.normal.y != 0 && !middle.empty()) return {balls.enter, larger(balls.exit, middle.exit), balls.normal};
    return either(balls, middle);
}

// x^2 + z^2 <= k^2 y^2 is two nappes, tip to tip, and a line that is steeper than the cone is in both: outside of the
// roots, and in the upper one on the side to which it rises. One that is flatter is between the roots, in one of them.
// The roots are q / a and c / q with q = -(b + sign(b) sqrt(b^2 - a c)), which loses no digits where a is small.
Inside in_nappe(double slope, const Vec& from, const Vec& along) noexcept {
    const auto product = [&](const Vec& v, const Vec& w) noexcept {
        return v.x * w.x + v.z * w.z - slope * v.y * (slope * w.y);
    };
    const double a = product(along, along);
    const double b = product(from, along);
    const double c = product(from, from);
    const double square = b * b - a * c;
    if (a > 0 && square < 0) return nowhere;
    const double root = std::sqrt(larger(0, square));
    const double q = b > 0 ? -(b + root) : root - b;
    if (q == 0 && a == 0) return c <= 0 ? Inside{} : nowhere;
    // A line along the cone's side is in one nappe only: the upper one if it dives into it as it rises.
    if (a == 0 && (b > 0) == (along.y > 0)) return nowhere;
    const double other = q == 0 ? 0 : c / q;
    const double one = a == 0 ? other : q / a;
    const double first = smaller(one, other);
    const double second = larger(one, other);
    Inside inside;
    if (a > 0) {
        inside.enter = first;
        inside.exit = second;
    } else {
        inside = along.y > 0 ? Inside{second, forever, {}} : Inside{-forever, first, {}};
    }
    if (inside.enter > -forever && inside.enter < forever) {
        const Vec at = from + along * inside.enter;
        const double run = std::sqrt(at.x * at.x + at.z * at.z);
        inside.normal = run > 0 ? unit_or_zero({at.x, -slope * run, at.z}) : Vec{0, -1, 0};
    }
    return inside;
}

Inside in_cone(const Cone& cone, const Vec& from, const Vec& along) noexcept {
    return common(in_slab(from.y, along.y, 0, cone.height, {0, 1, 0}),
                  in_nappe(cone.radius / cone.height, from, along));
}

}  // namespace

std::optional<RayTouch> ray_shape(const Shape& shape, const Vec& from, const Vec& along) noexcept {
    // From where the line is closest to the reference point: what is far away would eat up the shape's digits.
    const double square = dot(along, along);
    const double closest = square > 0 ? -dot(from, along) / square : 0;
    const Vec near = from + along * closest;
    const Inside inside =
        std::visit(Overloaded{
                       [&](const Sphere& sphere) noexcept { return in_ball({}, sphere.radius, near, along); },
                       [&](const Ellipsoid& ellipsoid) noexcept { return in_ellipsoid(ellipsoid, near, along); },
                       [&](const Capsule& capsule) noexcept { return in_capsule(capsule, near, along); },
                       [&](const Box& box) noexcept { return in_box(box, near, along); },
                       [&](const Cylinder& cylinder) noexcept {
                           return in_cylinder(cylinder.radius, cylinder.half_height, near, along);
                       },
                       [&](const Cone& cone) noexcept { return in_cone(cone, near, along); },
                   },
                   shape);
    const double enter = inside.enter + closest;
    const double exit = inside.exit + closest;
    if (inside.empty() || exit < 0 || enter > 1) return std::nullopt;
    if (enter <= 0) return RayTouch{0, {}, true};
    return RayTouch{enter, inside.normal, false};
}

}  // namespace surefoot::internal
