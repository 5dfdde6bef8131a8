#include "view/camera.hpp"

#include <cmath>
#include <glm/ext/matrix_clip_space.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

namespace surefoot::view {

dvec3 Camera::right() const {
    return glm::normalize(glm::cross(forward, up));
}

dvec3 Camera::above() const {
    return glm::cross(right(), forward);
}

dmat4 Camera::turn() const {
    const dvec3 x = right();
    const dvec3 y = above();
    return {x.x, y.x, -forward.x, 0, x.y, y.y, -forward.y, 0, x.z, y.z, -forward.z, 0, 0, 0, 0, 1};
}

dmat4 Camera::projection(double width_to_height) const {
    dmat4 clip = glm::perspective(field_of_view, width_to_height, nearest, farthest);
    clip[2][0] -= lens_shift.x;
    clip[2][1] -= lens_shift.y;
    return clip;
}

dvec3 Camera::direction(const dvec2& at, const ivec2& size) const {
    const double half = std::tan(field_of_view / 2);
    const double x = (2 * at.x / size.x - 1 - lens_shift.x) * half * size.x / size.y;
    const double y = (1 - 2 * at.y / size.y - lens_shift.y) * half;
    return glm::normalize(forward + right() * x + above() * y);
}

Motion Camera::ray(const dvec2& at, const ivec2& size, double length) const {
    return {eye, eye + direction(at, size) * length};
}

std::optional<Projected> Camera::project(const dvec3& place, const ivec2& size) const {
    const dvec3 to = place - eye;
    const double depth = glm::dot(to, forward);
    if (!(depth > nearest)) return std::nullopt;
    const double half = std::tan(field_of_view / 2) * depth;
    const double x = glm::dot(to, right()) / (half * size.x / size.y) + lens_shift.x;
    const double y = glm::dot(to, above()) / half + lens_shift.y;
    return Projected{{(x + 1) / 2 * size.x, (1 - y) / 2 * size.y}, depth};
}

double Camera::unit_at(double depth, const ivec2& size) const {
    return 2 * std::tan(field_of_view / 2) * depth / size.y;
}

std::optional<Hit> pick(const Mesh& mesh, const Camera& camera, const dvec2& at, const ivec2& size) {
    return mesh.ray(camera.ray(at, size, camera.farthest));
}

Across across(const dvec3& up) {
    // The axis that up has least of, counted on from up's own, so that +Y gives +Z and +X.
    const dvec3 helper = std::abs(up.y) > 0.5 ? dvec3(1, 0, 0) : dvec3(0, 1, 0);
    const dvec3 first = glm::normalize(glm::cross(helper, up));
    return {first, glm::cross(up, first)};
}

}  // namespace surefoot::view
