#include "world/grown.hpp"

#include <cmath>

#include "overloaded.hpp"

namespace surefoot::internal {

namespace {

// The ellipsoid's support function is h(n)^2 = sum of n_i^2 r_i^2 over unit n. With radii R_i^2 = r_i^2 (1 + by/s) +
// by s + by^2 its square is h^2 + by (h^2/s + s) + by^2, and h^2/s + s >= 2h whatever s > 0: at least (h + by)^2. The
// geometric mean of the extreme radii for s shares the excess between them. The overhang as a function of h is convex,
// so it is largest at one of the radii.
GrownShape grown_ellipsoid(const Ellipsoid& ellipsoid, double by) noexcept {
    const Vec r = to_vec(ellipsoid.radii);
    const double least = smaller(r.x, smaller(r.y, r.z));
    const double s = std::sqrt(least) * std::sqrt(largest(r));
    const auto radius = [&](double old) noexcept {
        return std::sqrt(old * old + by * (old * (old / s) + s) + by * by) * (1 + 0x1p-51);
    };
    const Vec more{radius(r.x), radius(r.y), radius(r.z)};
    return {Ellipsoid{to_dvec3(more)}, 0, largest(more - r)};
}

// The disc is raised by `by`, the side moved out by as much, which lowers the apex by `by` over the sine of half the
// cone's angle. Beyond the ball of that size, the apex reaches this far, and the rim `by` over the sine of half its own
// angle.
GrownShape grown_cone(const Cone& cone, double by) noexcept {
    const double side = std::sqrt(cone.radius * cone.radius + cone.height * cone.height);
    const double drop = by * (side / cone.radius);
    const double height = cone.height + by + drop;
    const double rim = by * std::sqrt(2 * side * (side + cone.radius)) / cone.height;
    return {Cone{.radius = height * (cone.radius / cone.height), .height = height}, drop, larger(drop, rim)};
}

}  // namespace

GrownShape grown(const Shape& shape, double by) noexcept {
    if (!(by > 0)) return {shape, 0, 0};
    return std::visit(
        Overloaded{
            [&](const Sphere& sphere) noexcept {
                return GrownShape{Sphere{.radius = sphere.radius + by}, 0, by};
            },
            [&](const Ellipsoid& ellipsoid) noexcept { return grown_ellipsoid(ellipsoid, by); },
            [&](const Capsule& capsule) noexcept {
                return GrownShape{Capsule{.radius = capsule.radius + by, .half_height = capsule.half_height}, 0, by};
            },
            [&](const Box& box) noexcept {
                return GrownShape{Box{to_dvec3(to_vec(box.half_extents) + Vec{by, by, by})}, 0,
                                  by * 1.7320508075688773};
            },
            [&](const Cylinder& cylinder) noexcept {
                return GrownShape{Cylinder{.radius = cylinder.radius + by, .half_height = cylinder.half_height + by}, 0,
                                  by * 1.4142135623730952};
            },
            [&](const Cone& cone) noexcept { return grown_cone(cone, by); },
        },
        shape);
}

double turning_reach(const Shape& shape, const Vec& axis) noexcept {
    const Vec a{absolute(axis.x), absolute(axis.y), absolute(axis.z)};
    // What is round about its own Y only feels how fast that Y tilts.
    const double tilt = std::sqrt(axis.x * axis.x + axis.z * axis.z);
    const double reach =
        std::visit(Overloaded{
                       [](const Sphere&) noexcept { return 0.0; },
                       // |n x k| by components, k = (r_i^2 n_i) / h, where h >= |(r_i n_i, r_j n_j)|.
                       [&](const Ellipsoid& ellipsoid) noexcept {
                           const Vec r = to_vec(ellipsoid.radii);
                           return a.x * absolute(r.y - r.z) + a.y * absolute(r.z - r.x) + a.z * absolute(r.x - r.y);
                       },
                       [&](const Capsule& capsule) noexcept { return tilt * capsule.half_height; },
                       // The corner that is farthest from the axis; convex, so no other point is farther.
                       [&](const Box& box) noexcept {
                           const Vec h = to_vec(box.half_extents);
                           double farthest = 0;
                           for (const Vec& corner :
                                {Vec{h.x, h.y, h.z}, Vec{-h.x, h.y, h.z}, Vec{h.x, -h.y, h.z}, Vec{h.x, h.y, -h.z}}) {
                               farthest = larger(farthest, length(cross(axis, corner)));
                           }
                           return farthest;
                       },
                       [&](const Cylinder& cylinder) noexcept {
                           return tilt * std::sqrt(cylinder.radius * cylinder.radius +
                                                   cylinder.half_height * cylinder.half_height);
                       },
                       [&](const Cone& cone) noexcept {
                           return tilt * std::sqrt(cone.radius * cone.radius + cone.height * cone.height);
                       },
                   },
                   shape);
    return reach;
}

}  // namespace surefoot::internal
