#include "view/orbit_camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace surefoot::view {
namespace {

constexpr double steepest = 1.55;
constexpr double turn_per_unit = 0.006;  // radians a window unit
constexpr double zoom_per_click = 0.86;
constexpr double eagerness = 13;  // of easing [1/s]

OrbitCamera::Stand within_limits(OrbitCamera::Stand stand) {
    stand.pitch = std::clamp(stand.pitch, -steepest, steepest);
    stand.distance = std::clamp(stand.distance, 1e-4, 1e7);
    return stand;
}

}  // namespace

OrbitCamera::OrbitCamera(const dvec3& up) : up_(glm::normalize(up)) {}

void OrbitCamera::set_up(const dvec3& up) {
    up_ = glm::normalize(up);
}

dvec3 OrbitCamera::outward(const Stand& stand) const {
    const auto [first, second] = across(up_);
    return std::cos(stand.pitch) * (std::cos(stand.yaw) * first + std::sin(stand.yaw) * second) +
           std::sin(stand.pitch) * up_;
}

Camera OrbitCamera::camera() const {
    const dvec3 out = outward(now_);
    Camera camera;
    camera.eye = now_.pivot + out * now_.distance;
    camera.forward = -out;
    camera.up = up_;
    camera.field_of_view = field_of_view;
    camera.nearest = std::clamp(now_.distance * 0.01, 1e-5, 0.2);
    camera.farthest = std::max(4000.0, now_.distance * 20);
    return camera;
}

bool OrbitCamera::event(const InputEvent& event, const ivec2& size, const std::optional<dvec3>& under) {
    if (const auto* const press = std::get_if<ButtonPress>(&event)) {
        if (press->down && !drag_) {
            drag_ = press->button;
            return true;
        }
        if (!press->down && drag_ == press->button) {
            drag_.reset();
            return true;
        }
        return false;
    }
    if (const auto* const focus = std::get_if<FocusChange>(&event)) {
        if (!focus->focused) drag_.reset();
        return false;
    }
    if (const auto* const move = std::get_if<PointerMove>(&event)) {
        if (!drag_) return false;
        if (*drag_ == MouseButton::left) {
            goal_.yaw -= move->by.x * turn_per_unit;
            goal_.pitch += move->by.y * turn_per_unit;
        } else {
            const Camera now = camera();
            const double unit = now.unit_at(now_.distance, size);
            const dvec3 by = (now.above() * move->by.y - now.right() * move->by.x) * unit;
            goal_.pivot += by;
            now_.pivot += by;  // what is held must not lag behind the hand
        }
        goal_ = within_limits(goal_);
        return true;
    }
    if (const auto* const wheel = std::get_if<WheelTurn>(&event)) {
        const double factor = std::pow(zoom_per_click, wheel->by.y);
        const Camera now = camera();
        // What the pointer is over stays under it: the pivot goes towards it as the distance shrinks.
        const dvec3 direction = now.direction(wheel->at, size);
        const double along = glm::dot(direction, now.forward);
        dvec3 towards = now.eye + direction * (now_.distance / along);
        if (under) towards = *under;
        const Stand before = goal_;
        goal_.distance *= factor;
        goal_ = within_limits(goal_);
        goal_.pivot += (towards - goal_.pivot) * (1 - goal_.distance / before.distance);
        return true;
    }
    return false;
}

bool OrbitCamera::update(double dt) {
    const double share = 1 - std::exp(-eagerness * dt);
    now_.pivot += (goal_.pivot - now_.pivot) * share;
    now_.yaw += (goal_.yaw - now_.yaw) * share;
    now_.pitch += (goal_.pitch - now_.pitch) * share;
    now_.distance *= std::pow(goal_.distance / now_.distance, share);
    const bool moves = glm::length(goal_.pivot - now_.pivot) > 1e-4 * now_.distance ||
                       std::abs(goal_.yaw - now_.yaw) > 1e-4 || std::abs(goal_.pitch - now_.pitch) > 1e-4 ||
                       std::abs(goal_.distance / now_.distance - 1) > 1e-4;
    if (!moves) now_ = goal_;
    return moves;
}

void OrbitCamera::frame(const Bounds& bounds) {
    goal_.pivot = (bounds.min + bounds.max) * 0.5;
    const double radius = std::max(glm::length(bounds.max - bounds.min) * 0.5, 1e-3);
    goal_.distance = radius / std::sin(field_of_view / 2) * 1.02;
    goal_ = within_limits(goal_);
}

void OrbitCamera::go_to(const Stand& stand) {
    goal_ = within_limits(stand);
}

void OrbitCamera::jump_to(const Stand& stand) {
    now_ = goal_ = within_limits(stand);
}

void OrbitCamera::take(const Camera& camera, double distance) {
    const auto [first, second] = across(up_);
    Stand stand;
    stand.pitch = std::asin(std::clamp(-glm::dot(camera.forward, up_), -1.0, 1.0));
    stand.yaw = std::atan2(-glm::dot(camera.forward, second), -glm::dot(camera.forward, first));
    stand.distance = distance;
    stand.pivot = camera.eye + camera.forward * distance;
    jump_to(stand);
}

}  // namespace surefoot::view
