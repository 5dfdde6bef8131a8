#include "view/fly_camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace surefoot::view {
namespace {

constexpr double turn_per_unit = 0.004;
constexpr double hurry = 4;
constexpr double inertia = 10;  // how fast the wished speed is reached [1/s]

}  // namespace

FlyCamera::FlyCamera(const dvec3& up) : up_(glm::normalize(up)) {}

void FlyCamera::place(const dvec3& eye, const dvec3& forward) {
    eye_ = eye;
    velocity_ = dvec3(0);
    const auto [first, second] = across(up_);
    const dvec3 unit = glm::normalize(forward);
    pitch_ = std::clamp(std::asin(std::clamp(glm::dot(unit, up_), -1.0, 1.0)), -1.55, 1.55);
    yaw_ = std::atan2(glm::dot(unit, second), glm::dot(unit, first));
}

Camera FlyCamera::camera() const {
    const auto [first, second] = across(up_);
    Camera camera;
    camera.eye = eye_;
    camera.forward = std::cos(pitch_) * (std::cos(yaw_) * first + std::sin(yaw_) * second) + std::sin(pitch_) * up_;
    camera.up = up_;
    camera.field_of_view = field_of_view;
    return camera;
}

bool FlyCamera::event(const InputEvent& event) {
    if (const auto* const press = std::get_if<KeyPress>(&event)) {
        if (press->down && (press->held.control || press->held.alt)) return false;
        keys_[static_cast<std::size_t>(press->key)] = press->down;
        return press->key == Key::w || press->key == Key::a || press->key == Key::s || press->key == Key::d ||
               press->key == Key::q || press->key == Key::e;
    }
    if (const auto* const focus = std::get_if<FocusChange>(&event)) {
        if (!focus->focused) {
            keys_.fill(false);
            drag_.reset();
        }
        return false;
    }
    if (const auto* const press = std::get_if<ButtonPress>(&event)) {
        if (press->down && !drag_) {
            drag_ = press->button;
        } else if (!press->down && drag_ == press->button) {
            drag_.reset();
        }
        return true;
    }
    if (const auto* const move = std::get_if<PointerMove>(&event)) {
        if (!drag_) return false;
        yaw_ -= move->by.x * turn_per_unit;
        pitch_ = std::clamp(pitch_ - move->by.y * turn_per_unit, -1.55, 1.55);
        return true;
    }
    if (const auto* const wheel = std::get_if<WheelTurn>(&event)) {
        speed = std::clamp(speed * std::pow(1.2, wheel->by.y), 0.01, 1e5);
        return true;
    }
    return false;
}

bool FlyCamera::update(double dt) {
    const Camera now = camera();
    const auto axis = [&](Key forth, Key back) { return double(held(forth)) - double(held(back)); };
    dvec3 wish = now.forward * axis(Key::w, Key::s) + now.right() * axis(Key::d, Key::a) + up_ * axis(Key::e, Key::q);
    const double length = glm::length(wish);
    if (length > 1) wish /= length;
    wish *= speed * (held(Key::shift) ? hurry : 1);
    velocity_ += (wish - velocity_) * (1 - std::exp(-inertia * dt));
    if (length == 0 && glm::length(velocity_) < 1e-3 * speed) velocity_ = dvec3(0);
    eye_ += velocity_ * dt;
    return velocity_ != dvec3(0);
}

}  // namespace surefoot::view
