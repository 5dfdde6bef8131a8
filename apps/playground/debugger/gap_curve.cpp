#include "debugger/gap_curve.hpp"

#include <glm/geometric.hpp>

#include <surefoot/barycentrics.hpp>
#include <surefoot/overlap.hpp>
#include <surefoot/sweep.hpp>

#include "debugger/distance.hpp"
#include "debugger/squash.hpp"

namespace surefoot::debugger {

namespace {

/// Of the origin.
double distance_to(const Triangle& triangle) {
    const dvec3 weights = barycentrics({0, 0, 0}, triangle);
    return glm::length(triangle.a * weights.x + triangle.b * weights.y + triangle.c * weights.z);
}

}  // namespace

double gap_at(const Volume& volume, const dvec3& position, const Triangle& triangle) {
    const Triangle seen{triangle.a - position, triangle.b - position, triangle.c - position};
    if (const auto* sphere = std::get_if<Sphere>(&volume.shape)) return distance_to(seen) - sphere->radius;
    if (is_squashable(volume.shape))
        return distance_to({squashed(volume, seen.a), squashed(volume, seen.b), squashed(volume, seen.c)}) - 1;
    if (const auto touch = overlap(volume, position, triangle)) return -touch->depth;
    return distance(volume, position, triangle);
}

GapCurve gap_curve(const Volume& volume, const Motion& motion, const Triangle& triangle, std::size_t count,
                   bool one_sided) {
    GapCurve curve;
    const dvec3 along = motion.to - motion.from;
    if (std::holds_alternative<Ellipsoid>(volume.shape)) {
        curve.space = GapSpace::squashed;
        curve.method = "Distance of the centre to the triangle minus 1, in squashed space.";
    } else if (std::holds_alternative<Sphere>(volume.shape)) {
        curve.method = "Distance of the centre to the triangle minus the radius.";
    } else {
        curve.method =
            "While apart the distance, searched after Gilbert, Johnson and Keerthi; in touch the depth, as "
            "overlap tells it.";
    }
    for (std::size_t i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(count - 1);
        curve.samples.push_back({t, gap_at(volume, motion.from + along * t, triangle)});
    }
    if (const auto hit = sweep(volume, motion, triangle, {.one_sided = one_sided})) {
        curve.t_star = hit->t;
        curve.g_at_t_star = gap_at(volume, motion.from + along * hit->t, triangle);
    }
    return curve;
}

}  // namespace surefoot::debugger
