#include "playground/walk/follow_camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace surefoot::playground {
namespace {

constexpr double turn_per_unit = 0.005;  // [rad per window unit]
constexpr double steepest = 1.5;         // [rad]
constexpr double ball = 0.18;            // of the eye; nothing is nearer to it [m]
constexpr double above = 0.35;           // of what is looked at, over the middle of the body [m]
constexpr double eagerness = 9;          // of going back to where there is room again [1/s]
constexpr double steadiness = 16;        // of following up and down [1/s]
constexpr double nearest = 1.2;          // [m]
constexpr double farthest = 40;          // [m]

}  // namespace

double yaw_towards(const dvec3& direction) {
    return std::atan2(-direction.x, -direction.z);
}

dvec3 FollowCamera::outward() const {
    const auto [first, second] = view::across({0, 1, 0});
    return std::cos(pitch_) * (std::cos(yaw_) * first + std::sin(yaw_) * second) + dvec3(0, std::sin(pitch_), 0);
}

dvec3 FollowCamera::ahead() const {
    const auto [first, second] = view::across({0, 1, 0});
    return -(std::cos(yaw_) * first + std::sin(yaw_) * second);
}

void FollowCamera::turn(const view::dvec2& by) {
    yaw_ -= by.x;
    pitch_ = std::clamp(pitch_ + by.y, -steepest, steepest);
}

bool FollowCamera::event(const view::InputEvent& event, bool captured) {
    if (const auto* const press = std::get_if<view::ButtonPress>(&event)) {
        if (press->down && !drag_) {
            drag_ = press->button;
        } else if (!press->down && drag_ == press->button) {
            drag_.reset();
        }
        return true;
    }
    if (const auto* const focus = std::get_if<view::FocusChange>(&event)) {
        if (!focus->focused) drag_.reset();
        return false;
    }
    if (const auto* const move = std::get_if<view::PointerMove>(&event)) {
        if (!drag_ && !captured) return false;
        turn(move->by * turn_per_unit);
        return true;
    }
    if (const auto* const wheel = std::get_if<view::WheelTurn>(&event)) {
        distance_ = std::clamp(distance_ * std::pow(0.86, wheel->by.y), nearest, farthest);
        return true;
    }
    return false;
}

double FollowCamera::free_way(const World& world, const dvec3& middle) const {
    const dvec3 pivot = middle + dvec3(0, above - lag_, 0);
    // The world as it stands when the tick ends: a look takes no time.
    const auto hit = world.sweep(Sphere{ball}, {pivot, pivot + outward() * distance_}, {.begin = 1, .end = 1});
    return hit ? hit->t * distance_ : distance_;
}

bool FollowCamera::update(double dt, const World& world, const dvec3& middle) {
    height_ += (middle.y - height_) * (1 - std::exp(-steadiness * dt));
    constexpr double most_lag = 1;  // [m]
    lag_ = std::clamp(middle.y - height_, -most_lag, most_lag);
    height_ = middle.y - lag_;
    const double room = free_way(world, middle);
    const double before = free_;
    // At once towards the character, gently away from it.
    free_ = room < free_ ? room : free_ + (room - free_) * (1 - std::exp(-eagerness * dt));
    return std::abs(free_ - before) > 1e-4 || std::abs(lag_) > 1e-4;
}

void FollowCamera::keep_in(const view::Area& part, const view::ivec2& size, double dt) {
    const view::dvec2 at = part.middle() / view::dvec2(size) * 2.0 - 1.0;
    lens_shift_ += (view::dvec2(at.x, -at.y) - lens_shift_) * (1 - std::exp(-eagerness * dt));
}

void FollowCamera::jump_to(const dvec3& middle, double yaw) {
    yaw_ = yaw;
    height_ = middle.y;
    lag_ = 0;
    free_ = distance_;
}

view::Camera FollowCamera::camera(const World& world, const dvec3& middle) const {
    view::Camera camera;
    const dvec3 out = outward();
    camera.eye =
        middle + dvec3(0, above - lag_, 0) + out * std::max(std::min(free_, free_way(world, middle)), ball * 0.5);
    camera.forward = -out;
    camera.field_of_view = 1.0;
    camera.nearest = ball * 0.4;
    camera.lens_shift = lens_shift_;
    return camera;
}

}  // namespace surefoot::playground
