#include "tour/solids.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace surefoot::tools {
namespace {

/// The first root of a s^2 + 2 b s + c = 0, if there is one ahead.
std::optional<double> entry(double a, double b, double c) {
    const double discriminant = b * b - a * c;
    if (discriminant < 0 || a <= 0) return std::nullopt;
    const double s = (-b - std::sqrt(discriminant)) / a;
    return s > 0 ? std::optional(s) : std::nullopt;
}

}  // namespace

double SweptEllipsoid::reach() const {
    return glm::length(to - from) / 2 + std::max({radii.x, radii.y, radii.z});
}

std::optional<Sighting> SweptEllipsoid::sight(const dvec3& eye, const dvec3& direction) const {
    // In the ellipsoid's own axes, divided by its radii, the ellipsoid is a unit ball and its sweep a capsule.
    const dquat inverse = glm::conjugate(orientation);
    const auto squash = [&](const dvec3& v) { return (inverse * v) / radii; };
    const dvec3 o = squash(eye - from);
    const dvec3 d = squash(direction);
    const dvec3 axis = squash(to - from);
    const double length2 = glm::dot(axis, axis);
    std::optional<double> nearest;
    dvec3 normal(0);
    const auto offer = [&](std::optional<double> s, const dvec3& n) {
        if (!s || (nearest && *s >= *nearest)) return;
        nearest = s;
        normal = n;
    };
    for (const dvec3& end : {dvec3(0), axis}) {
        const dvec3 away = o - end;
        if (const auto s = entry(glm::dot(d, d), glm::dot(away, d), glm::dot(away, away) - 1)) offer(s, away + *s * d);
    }
    if (length2 > 0) {
        const dvec3 od = o - axis * (glm::dot(o, axis) / length2);
        const dvec3 dd = d - axis * (glm::dot(d, axis) / length2);
        if (const auto s = entry(glm::dot(dd, dd), glm::dot(od, dd), glm::dot(od, od) - 1)) {
            const double along = glm::dot(o + *s * d, axis) / length2;
            if (along >= 0 && along <= 1) offer(s, od + *s * dd);
        }
    }
    if (!nearest) return std::nullopt;
    return Sighting{*nearest, glm::normalize(orientation * (normal / radii))};
}

double ArrowHead::reach() const {
    return std::hypot(glm::length(tip - base) / 2, radius);
}

std::optional<Sighting> ArrowHead::sight(const dvec3& eye, const dvec3& direction) const {
    const double height = glm::length(tip - base);
    const dvec3 axis = (base - tip) / height;  // from the tip down
    const double slope = radius / height;
    const dvec3 o = eye - tip;
    const double oa = glm::dot(o, axis);
    const double da = glm::dot(direction, axis);
    const dvec3 od = o - oa * axis;
    const dvec3 dd = direction - da * axis;
    const double k = slope * slope;
    const double a = glm::dot(dd, dd) - k * da * da;
    const double b = glm::dot(od, dd) - k * oa * da;
    const double c = glm::dot(od, od) - k * oa * oa;
    std::optional<Sighting> met;
    const auto offer = [&](double s, const dvec3& normal) {
        if (s > 0 && (!met || s < met->distance)) met = Sighting{s, normal};
    };
    if (const double discriminant = b * b - a * c; discriminant >= 0 && a != 0)
        for (const double sign : {-1.0, 1.0}) {
            const double s = (-b + sign * std::sqrt(discriminant)) / a;
            const double along = oa + s * da;
            if (along < 0 || along > height) continue;
            const dvec3 outwards = od + s * dd;
            const double length = glm::length(outwards);
            if (length > 0) offer(s, glm::normalize(outwards / length - slope * axis));
        }
    if (da != 0) {
        const double s = (height - oa) / da;
        const dvec3 outwards = od + s * dd;
        if (glm::dot(outwards, outwards) <= radius * radius) offer(s, axis);
    }
    return met;
}

}  // namespace surefoot::tools
