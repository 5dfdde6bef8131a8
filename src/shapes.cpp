#include <surefoot/shapes.hpp>

#include "limits.hpp"
#include "overloaded.hpp"
#include "vec.hpp"

namespace surefoot {
inline namespace v0 {

namespace {

// Written so that NaN fails every comparison.
bool dimensions_are_valid(double smallest, double largest) noexcept {
    return smallest >= internal::smallest_dimension && largest <= internal::largest_dimension &&
           largest <= internal::largest_ratio * smallest;
}

bool pair_is_valid(double a, double b) noexcept {
    return a > 0 && b > 0 && dimensions_are_valid(internal::smaller(a, b), internal::larger(a, b));
}

bool triple_is_valid(const dvec3& v) noexcept {
    using internal::larger;
    using internal::smaller;
    return v.x > 0 && v.y > 0 && v.z > 0 &&
           dimensions_are_valid(smaller(v.x, smaller(v.y, v.z)), larger(v.x, larger(v.y, v.z)));
}

bool shape_is_valid(const Shape& shape) noexcept {
    return std::visit(internal::Overloaded{
                          [](const Sphere& sphere) { return dimensions_are_valid(sphere.radius, sphere.radius); },
                          [](const Ellipsoid& ellipsoid) { return triple_is_valid(ellipsoid.radii); },
                          [](const Capsule& capsule) {
                              return capsule.half_height >= 0 &&
                                     dimensions_are_valid(capsule.radius,
                                                          internal::larger(capsule.radius, capsule.half_height));
                          },
                          [](const Box& box) { return triple_is_valid(box.half_extents); },
                          [](const Cylinder& cylinder) { return pair_is_valid(cylinder.radius, cylinder.half_height); },
                          [](const Cone& cone) { return pair_is_valid(cone.radius, cone.height); },
                      },
                      shape);
}

bool orientation_is_valid(const dquat& q) noexcept {
    using internal::absolute;
    const double largest = internal::larger(internal::largest({q.x, q.y, q.z}), absolute(q.w));
    const bool all_finite =
        absolute(q.x) <= 0x1p500 && absolute(q.y) <= 0x1p500 && absolute(q.z) <= 0x1p500 && absolute(q.w) <= 0x1p500;
    return all_finite && largest >= 0x1p-500;
}

}  // namespace

bool is_valid(const Volume& volume) noexcept {
    return shape_is_valid(volume.shape) && orientation_is_valid(volume.orientation);
}

}  // namespace v0
}  // namespace surefoot
