#include "tour/camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace surefoot::tools {
namespace {

constexpr double pi = 3.14159265358979323846;

Camera looking_along(const dvec3& forward, const CameraWish& wish) {
    Camera camera;
    camera.forward = forward;
    camera.right = glm::normalize(glm::cross(forward, dvec3(0, 1, 0)));
    camera.up = glm::cross(camera.right, forward);
    camera.width = wish.width;
    camera.height = wish.height;
    return camera;
}

/// Moves the eye so that all points are just inside the margins: first to the middle of the picture, then back.
void fit(Camera& camera, const CameraWish& wish) {
    const double tan_y = camera.tan_half * (1 - 2 * wish.margin);
    const double tan_x = tan_y * camera.width / camera.height;
    // Each border of the picture is a plane through the eye; the tightest point of each pins it.
    double left = 1e300;
    double right = -1e300;
    double low = 1e300;
    double high = -1e300;
    for (const dvec3& p : wish.frame) {
        const double z = glm::dot(p, camera.forward);
        left = std::min(left, glm::dot(p, camera.right) + z * tan_x);
        right = std::max(right, glm::dot(p, camera.right) - z * tan_x);
        low = std::min(low, glm::dot(p, camera.up) + z * tan_y);
        high = std::max(high, glm::dot(p, camera.up) - z * tan_y);
    }
    // The eye at (x, y, z) sees a point inside the right border iff p.x - x <= (p.z - z) * tan_x, and so on.
    const double z_for_x = (left - right) / (2 * tan_x);
    const double z_for_y = (low - high) / (2 * tan_y);
    const double z = std::min(z_for_x, z_for_y);
    const double x = ((right + z * tan_x) + (left - z * tan_x)) / 2;
    const double y = ((high + z * tan_y) + (low - z * tan_y)) / 2;
    camera.eye = x * camera.right + y * camera.up + z * camera.forward;
}

double seen(const Mesh& mesh, const Camera& camera, const CameraWish& wish) {
    double count = 0;
    for (const dvec3& point : wish.see) {
        const dvec3 way = (point - camera.eye) * 0.999;
        const dvec3 from = camera.eye + glm::normalize(way) * camera.sight_begins(glm::normalize(way));
        count += !mesh.ray({from, camera.eye + way}, {.one_sided = wish.one_sided});
    }
    return count / static_cast<double>(std::max<std::size_t>(wish.see.size(), 1));
}

struct View {
    Camera camera;
    double seen = 0;
};

View best_view(const Mesh& mesh, const CameraWish& wish, std::span<const double> pitches, double ceiling) {
    constexpr int around = 24;
    View best;
    double most = -1e300;
    for (const double pitch_deg : pitches)
        for (int i = 0; i < around; ++i) {
            const double pitch = pitch_deg * pi / 180;
            const double angle = 2 * pi * (i + 0.31) / around;
            Camera camera = looking_along(
                {std::cos(angle) * std::cos(pitch), -std::sin(pitch), std::sin(angle) * std::cos(pitch)}, wish);
            camera.ceiling = ceiling;
            fit(camera, wish);
            // A near eye shows more, and a flat view is more of a picture than a plan; being seen comes first.
            const double distance = glm::length(camera.eye - wish.frame.front());
            const double share = seen(mesh, camera, wish);
            double value = 4 * share - 0.01 * pitch_deg - 0.4 * std::log(distance);
            for (const dvec3& direction : wish.across) value -= std::abs(glm::dot(direction, camera.forward));
            if (value <= most) continue;
            most = value;
            best = {camera, share};
        }
    return best;
}

}  // namespace

double Camera::sight_begins(const dvec3& unit_direction) const {
    return eye.y > ceiling && unit_direction.y < 0 ? (ceiling - eye.y) / unit_direction.y : 0;
}

dvec3 Camera::direction(double x, double y) const {
    const double across = (2 * x - width) / height * tan_half;
    const double upwards = (1 - 2 * y / height) * tan_half;
    return glm::normalize(forward + across * right + upwards * up);
}

std::optional<Projected> Camera::project(const dvec3& point) const {
    const dvec3 away = point - eye;
    const double depth = glm::dot(away, forward);
    if (depth <= 1e-9) return std::nullopt;
    const double scale = height / (2 * tan_half * depth);
    return Projected{width / 2.0 + glm::dot(away, right) * scale, height / 2.0 - glm::dot(away, up) * scale, depth};
}

Camera choose_camera(const Mesh& mesh, const CameraWish& wish) {
    const View open = best_view(mesh, wish, wish.pitches, 1e300);
    constexpr double enough = 0.6;
    if (open.seen >= enough) return open.camera;
    double top = -1e300;
    for (const dvec3& point : wish.frame) top = std::max(top, point.y);
    constexpr std::array<double, 2> steep{52, 64};
    const View cut = best_view(mesh, wish, steep, top);
    return cut.seen > open.seen + 0.1 ? cut.camera : open.camera;
}

}  // namespace surefoot::tools
