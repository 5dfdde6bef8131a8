#include "character/body.hpp"

#include "overloaded.hpp"
#include "quat.hpp"
#include "sweep/query.hpp"
#include "world/ask.hpp"

namespace surefoot::internal {

namespace {

// The shortest turn that takes +Y to `up`. Straight down is half a turn about X.
Quat turn_to(const Vec& up) noexcept {
    const double w = 1 + up.y;
    if (w < 1e-12) return {0, {1, 0, 0}};
    return {w, {up.z, 0, -up.x}};
}

}  // namespace

double reach_along(const Volume& volume, const Vec& direction) noexcept {
    return reach_against(volume.shape, -Frame(volume.orientation).to_local(direction));
}

Box3 reach_box(const Volume& volume) noexcept {
    const Frame frame(volume.orientation);
    const auto reach = [&](const Vec& direction) noexcept {
        return reach_against(volume.shape, -frame.to_local(direction));
    };
    return {{-reach({-1, 0, 0}), -reach({0, -1, 0}), -reach({0, 0, -1})},
            {reach({1, 0, 0}), reach({0, 1, 0}), reach({0, 0, 1})}};
}

Across across(const Vec& up) noexcept {
    const Vec one = unit(cross(up, absolute(up.x) < 0.6 ? Vec{1, 0, 0} : Vec{0, 0, 1}));
    return {one, cross(up, one)};
}

Box3 Body::around(const Vec& from, const Vec& motion, double margin) const noexcept {
    const Vec wide = Vec{1, 1, 1} * margin;
    return swept_box({extent.min - wide, extent.max + wide}, {to_dvec3(from), to_dvec3(from + motion)});
}

namespace {

bool has_edges(const Shape& shape) noexcept {
    return std::holds_alternative<Box>(shape) || std::holds_alternative<Cylinder>(shape) ||
           std::holds_alternative<Cone>(shape);
}

}  // namespace

double smallest_of(const Shape& shape) noexcept {
    return std::visit(
        Overloaded{
            [](const Sphere& sphere) { return sphere.radius; },
            [](const Ellipsoid& ellipsoid) {
                return smaller(ellipsoid.radii.x, smaller(ellipsoid.radii.y, ellipsoid.radii.z));
            },
            [](const Capsule& capsule) { return capsule.radius; },
            [](const Box& box) { return smaller(box.half_extents.x, smaller(box.half_extents.y, box.half_extents.z)); },
            [](const Cylinder& cylinder) { return smaller(cylinder.radius, cylinder.half_height); },
            [](const Cone& cone) { return smaller(cone.radius, cone.height); },
        },
        shape);
}

Volume turned_to(const Volume& volume, const Vec& up) noexcept {
    if (up == Vec{0, 1, 0}) return volume;
    return {volume.shape, to_dquat(product(turn_to(up), scaled_to_one(volume.orientation)))};
}

Body body_of(const Volume& volume, double skin, const Vec& up) noexcept {
    Body body;
    body.volume = turned_to(volume, up);
    const GrownVolume kept_off = grown(body.volume, skin);
    body.kept_off = kept_off.volume;
    body.shift = kept_off.shift;
    body.frame = Frame(body.volume.orientation);
    const Cone* cone = std::get_if<Cone>(&volume.shape);
    if (cone != nullptr) body.middle = body.frame.to_world(Vec{0, 0.5 * cone->height, 0});
    body.is_sharp = has_edges(volume.shape);
    const Box3 reach = reach_box(body.kept_off);
    body.extent = {reach.min + body.shift, reach.max + body.shift};
    const auto [one, other] = across(up);
    body.half_width = larger(larger(reach_along(body.volume, one), reach_along(body.volume, -one)),
                             larger(reach_along(body.volume, other), reach_along(body.volume, -other)));
    body.foot = reach_along(body.kept_off, -up) - dot(body.shift, up);
    return body;
}

}  // namespace surefoot::internal
