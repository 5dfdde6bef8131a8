#include "view/orbit_camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
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
    camera.lens_shift = lens_shift_;
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
    lens_shift_ += (lens_goal_ - lens_shift_) * share;
    const bool moves = glm::length(goal_.pivot - now_.pivot) > 1e-4 * now_.distance ||
                       std::abs(goal_.yaw - now_.yaw) > 1e-4 || std::abs(goal_.pitch - now_.pitch) > 1e-4 ||
                       std::abs(goal_.distance / now_.distance - 1) > 1e-4 ||
                       glm::length(lens_goal_ - lens_shift_) > 1e-4;
    if (!moves) arrive();
    return moves;
}

void OrbitCamera::frame(const Bounds& bounds) {
    goal_.pivot = (bounds.min + bounds.max) * 0.5;
    const double radius = std::max(glm::length(bounds.max - bounds.min) * 0.5, 1e-3);
    goal_.distance = radius / std::sin(field_of_view / 2) * 1.02;
    goal_ = within_limits(goal_);
}

void OrbitCamera::frame(std::span<const dvec3> places, const Area& part, const ivec2& size) {
    // Seen along the view, a place at (x, y) and `z` ahead is within the part if |x - eye.x| <= (z - eye.z) slope.x,
    // and likewise for y. Each place bounds how far ahead the eye may stand, and where; these are the tightest bounds.
    const dvec3 ahead = -outward(goal_);
    const dvec3 right = glm::normalize(glm::cross(ahead, up_));
    const dvec3 above = glm::cross(right, ahead);
    const dvec2 slope = part.size() / double(size.y) * std::tan(field_of_view / 2);
    constexpr double none = 1e300;
    dvec2 most(-none);
    dvec2 least(none);
    dvec2 near_and_far(none, -none);
    for (const dvec3& place : places) {
        const dvec2 at(glm::dot(place, right), glm::dot(place, above));
        const double z = glm::dot(place, ahead);
        most = glm::max(most, at - slope * z);
        least = glm::min(least, at + slope * z);
        near_and_far = {std::min(near_and_far.x, z), std::max(near_and_far.y, z)};
    }
    const dvec2 eye = (most + least) * 0.5;
    const dvec2 nearest = (least - most) * 0.5 / slope;
    const double middle = (near_and_far.x + near_and_far.y) * 0.5;
    // A single place has no size, and something has to be between it and the eye.
    goal_.distance = std::max(middle - std::min(nearest.x, nearest.y), 1e-3);
    goal_.pivot = right * eye.x + above * eye.y + ahead * middle;
    goal_ = within_limits(goal_);
    keep_pivot_in(part, size);
}

void OrbitCamera::keep_pivot_in(const Area& part, const ivec2& size) {
    const dvec2 at = part.middle() / dvec2(size) * 2.0 - 1.0;
    lens_goal_ = {at.x, -at.y};
}

void OrbitCamera::arrive() {
    now_ = goal_;
    lens_shift_ = lens_goal_;
}

void OrbitCamera::move_by(const dvec3& by) {
    goal_.pivot += by;
    now_.pivot += by;
}

void OrbitCamera::go_to(const Stand& stand) {
    goal_ = within_limits(stand);
}

void OrbitCamera::jump_to(const Stand& stand) {
    goal_ = within_limits(stand);
    arrive();
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
