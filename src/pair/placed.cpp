#include "pair/placed.hpp"

#include <cmath>

#include "exact/products.hpp"
#include "overloaded.hpp"

namespace surefoot::internal {

namespace {

double with_sign_of(double size, double s) noexcept {
    return s < 0 ? -size : size;
}
double clamped(double s, double limit) noexcept {
    return smaller(limit, larger(-limit, s));
}

double level_length(const Vec& v) noexcept {
    return std::sqrt(v.x * v.x + v.z * v.z);
}

// In the shape's own frame.
Vec farthest_of(const Shape& shape, const Vec& n) noexcept {
    const double level = level_length(n);
    const Vec outward = level > 0 ? Vec{n.x / level, 0, n.z / level} : Vec{1, 0, 0};
    return std::visit(Overloaded{
                          [](const Sphere&) noexcept { return Vec{}; },
                          [&](const Ellipsoid& s) noexcept {
                              // The point R^2 n / |R n|, by way of a unit vector so that no square is tiny.
                              const Vec radii = to_vec(s.radii);
                              return multiply_each(unit(multiply_each(n, radii)), radii);
                          },
                          [&](const Capsule& s) noexcept {
                              return Vec{0, with_sign_of(s.half_height, n.y), 0};
                          },
                          [&](const Box& s) noexcept {
                              return Vec{with_sign_of(s.half_extents.x, n.x), with_sign_of(s.half_extents.y, n.y),
                                         with_sign_of(s.half_extents.z, n.z)};
                          },
                          [&](const Cylinder& s) noexcept {
                              return outward * s.radius + Vec{0, with_sign_of(s.half_height, n.y), 0};
                          },
                          [&](const Cone& s) noexcept {
                              const bool is_rim = s.radius * level + s.height * n.y > 0;
                              return is_rim ? outward * s.radius + Vec{0, s.height, 0} : Vec{};
                          },
                      },
                      shape);
}

Vec closest_of(const Shape& shape, const Vec& p) noexcept {
    return std::visit(Overloaded{
                          [](const Sphere&) noexcept { return Vec{}; },
                          [&](const Capsule& s) noexcept {
                              return Vec{0, clamped(p.y, s.half_height), 0};
                          },
                          [&](const Box& s) noexcept {
                              return Vec{clamped(p.x, s.half_extents.x), clamped(p.y, s.half_extents.y),
                                         clamped(p.z, s.half_extents.z)};
                          },
                          [&](const Cylinder& s) noexcept {
                              const double level = level_length(p);
                              const double shrink = level > s.radius ? s.radius / level : 1;
                              return Vec{p.x * shrink, clamped(p.y, s.half_height), p.z * shrink};
                          },
                          [&](const auto&) noexcept { return p; },
                      },
                      shape);
}

}  // namespace

Placed::Placed(const Volume& volume) noexcept : shape_(volume.shape), frame_(volume.orientation) {
    std::visit(Overloaded{
                   [&](const Sphere& s) noexcept { radius_ = size_ = s.radius; },
                   [&](const Ellipsoid& s) noexcept { size_ = largest(to_vec(s.radii)); },
                   [&](const Capsule& s) noexcept {
                       radius_ = s.radius;
                       size_ = s.radius + s.half_height;
                   },
                   [&](const Box& s) noexcept { size_ = length(to_vec(s.half_extents)); },
                   [&](const Cylinder& s) noexcept {
                       size_ = length({s.radius, s.half_height, 0});
                   },
                   [&](const Cone& s) noexcept {
                       size_ = length({s.radius, s.height, 0});
                   },
               },
               shape_);
}

Vec Placed::farthest(const Vec& n) const noexcept {
    return frame_.to_world(farthest_of(shape_, frame_.to_local(n)));
}

Vec Placed::closest_of_core(const Vec& p) const noexcept {
    return frame_.to_world(closest_of(shape_, frame_.to_local(p)));
}

}  // namespace surefoot::internal
