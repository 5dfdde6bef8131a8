#include "debugger/support.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include <surefoot/pose.hpp>

namespace surefoot::debugger {

namespace {

double signed_like(double size, double direction) {
    return direction < 0 ? -size : size;
}

/// In the rim of a disc of this radius that lies across Y.
dvec3 on_rim(double radius, const dvec3& direction) {
    const double level = std::sqrt(direction.x * direction.x + direction.z * direction.z);
    if (level == 0) return {0, 0, 0};
    return {radius * direction.x / level, 0, radius * direction.z / level};
}

struct Farthest {
    dvec3 n;  ///< in the shape's frame

    dvec3 operator()(const Sphere& s) const { return n * (s.radius / glm::length(n)); }
    dvec3 operator()(const Ellipsoid& s) const {
        const dvec3 scaled = n * s.radii;
        return scaled * s.radii / glm::length(scaled);
    }
    dvec3 operator()(const Capsule& s) const {
        return n * (s.radius / glm::length(n)) + dvec3(0, signed_like(s.half_height, n.y), 0);
    }
    dvec3 operator()(const Box& s) const {
        return {signed_like(s.half_extents.x, n.x), signed_like(s.half_extents.y, n.y),
                signed_like(s.half_extents.z, n.z)};
    }
    dvec3 operator()(const Cylinder& s) const {
        return on_rim(s.radius, n) + dvec3(0, signed_like(s.half_height, n.y), 0);
    }
    dvec3 operator()(const Cone& s) const {
        const dvec3 rim = on_rim(s.radius, n) + dvec3(0, s.height, 0);
        return glm::dot(rim, n) > 0 ? rim : dvec3(0, 0, 0);
    }
};

}  // namespace

dvec3 farthest_point(const Volume& volume, const dvec3& direction) {
    const Pose frame{.orientation = volume.orientation};
    return to_world(frame, std::visit(Farthest{to_body(frame, direction)}, volume.shape));
}

Bounds bounds_of(const Volume& volume, const dvec3& position) {
    Bounds box;
    for (int axis = 0; axis < 3; ++axis) {
        dvec3 direction(0, 0, 0);
        direction[axis] = 1;
        box.max[axis] = position[axis] + farthest_point(volume, direction)[axis];
        box.min[axis] = position[axis] + farthest_point(volume, -direction)[axis];
    }
    return box;
}

}  // namespace surefoot::debugger
