#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include <surefoot/navigation_build.hpp>

#include "frame.hpp"

namespace surefoot {
inline namespace v0 {
namespace {

/// How far a shape reaches from its reference point along a unit direction of its own axes.
double reach(const Shape& shape, const dvec3& along) {
    struct Visitor {
        dvec3 along;
        [[nodiscard]] double flat() const { return std::sqrt(along.x * along.x + along.z * along.z); }
        double operator()(const Sphere& sphere) const { return sphere.radius; }
        double operator()(const Ellipsoid& ellipsoid) const { return navigation::length(ellipsoid.radii * along); }
        double operator()(const Capsule& capsule) const {
            return capsule.radius + capsule.half_height * std::abs(along.y);
        }
        double operator()(const Box& box) const {
            return std::abs(box.half_extents.x * along.x) + std::abs(box.half_extents.y * along.y) +
                   std::abs(box.half_extents.z * along.z);
        }
        double operator()(const Cylinder& cylinder) const {
            return cylinder.radius * flat() + cylinder.half_height * std::abs(along.y);
        }
        double operator()(const Cone& cone) const {
            return std::max(0.0, cone.radius * flat() + cone.height * along.y);
        }
    };
    return std::visit(Visitor{along}, shape);
}

/// q* v q / |q|^2: from the world's axes into the shape's own.
dvec3 turned_back(const dquat& q, const dvec3& v) {
    const dvec3 axis{-q.x, -q.y, -q.z};
    const dvec3 twice = navigation::cross(axis, v) * 2.0;
    const double size = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    return v + (q.w * twice + navigation::cross(axis, twice)) / size;
}

}  // namespace

NavigationAgent navigation_agent(const CharacterSettings& settings) noexcept {
    if (!is_valid(settings)) return {.radius = 0, .height = 0, .climb = 0, .slope_limit_deg = 0, .feet = 0};
    const auto reach_to = [&](const dvec3& direction) {
        return reach(settings.volume.shape, turned_back(settings.volume.orientation, direction));
    };
    // The farthest that the body reaches aside is its farthest reach in any level direction; eighths of a degree are
    // finer than the skin that is added.
    constexpr int directions = 2880;
    double radius = 0;
    for (int i = 0; i < directions; ++i) {
        const double angle = 2 * std::numbers::pi * i / directions;
        radius = std::max(radius, reach_to({std::cos(angle), 0, std::sin(angle)}));
    }
    const double feet = reach_to({0, -1, 0}) + settings.skin;
    return {.radius = radius + settings.skin,
            .height = feet + reach_to({0, 1, 0}) + settings.skin,
            .climb = settings.step_up,
            .slope_limit_deg = settings.slope_limit_deg,
            .feet = feet};
}

}  // namespace v0
}  // namespace surefoot
