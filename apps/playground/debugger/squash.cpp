// With q the shape's orientation, D = diag(1 / radii^s) and R_s the part s of the way from no turn to q*:
//
//     map(s) = R_s q D q*        map(0) = 1        map(1) = q* q D q* = D q*
//
// The ellipsoid is the image of the unit ball under q diag(radii), so its image under map(s) is that under
// R_s q diag(radii^(1 - s)): an ellipsoid again, with radii of radius^(1 - s), turned by R_s q.
#include "debugger/squash.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include <surefoot/pose.hpp>

namespace surefoot::debugger {

bool is_squashable(const Shape& shape) {
    return std::holds_alternative<Sphere>(shape) || std::holds_alternative<Ellipsoid>(shape);
}

dvec3 radii_of(const Shape& shape) {
    if (const auto* sphere = std::get_if<Sphere>(&shape)) return dvec3(sphere->radius);
    if (const auto* ellipsoid = std::get_if<Ellipsoid>(&shape)) return ellipsoid->radii;
    return {1, 1, 1};
}

dvec3 squashed(const Volume& volume, const dvec3& vector) {
    return to_body(Pose{.orientation = volume.orientation}, vector) / radii_of(volume.shape);
}

dvec3 unsquashed(const Volume& volume, const dvec3& vector) {
    return to_world(Pose{.orientation = volume.orientation}, vector * radii_of(volume.shape));
}

dvec3 Squash::normal(const dvec3& n) const {
    return glm::normalize(glm::inverse(glm::transpose(map)) * n);
}

Squash squash_at(const Volume& volume, double s, const dvec3& pivot) {
    const dvec3 radii = radii_of(volume.shape);
    const dvec3 divisors(std::pow(radii.x, s), std::pow(radii.y, s), std::pow(radii.z, s));
    const glm::dquat turn = glm::normalize(volume.orientation);
    const glm::dquat towards = glm::slerp(glm::dquat(1, 0, 0, 0), glm::conjugate(turn), s);
    glm::dmat3 shrink(1);
    for (int axis = 0; axis < 3; ++axis) shrink[axis][axis] = 1 / divisors[axis];
    const glm::dmat3 own = glm::mat3_cast(turn);
    Squash squash;
    squash.map = glm::mat3_cast(towards) * own * shrink * glm::transpose(own);
    squash.pivot = pivot;
    squash.radii = radii / divisors;
    squash.orientation = towards * turn;
    return squash;
}

}  // namespace surefoot::debugger
