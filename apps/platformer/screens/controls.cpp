#include "platformer/screens/controls.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "platformer/screens/game_settings.hpp"

namespace surefoot::platformer {
namespace {

constexpr double mouse_turn = 0.0025;  // [rad] a window unit, at a sensitivity of 1
constexpr double pad_turn = 3;         // [rad/s] with the stick at its end
constexpr double key_turn = 2;         // [rad/s] while a key is held

/// Nothing within the dead zone, then from 0 to 1: a stick at rest is never quite in its middle.
view::dvec2 lively(const view::dvec2& stick) {
    constexpr double dead = 0.18;
    const double length = glm::length(stick);
    if (!(length > dead)) return {0, 0};
    return stick / length * std::min((length - dead) / (0.95 - dead), 1.0);
}

}  // namespace

bool Controls::Button::is_held() const {
    return std::any_of(held.begin(), held.end(), [](bool one) { return one; });
}

bool Controls::event(const view::InputEvent& event, const Bindings& bindings) {
    if (const auto* const focus = std::get_if<view::FocusChange>(&event); focus != nullptr && !focus->focused) {
        release();
        return false;
    }
    if (const auto* const move = std::get_if<view::PointerMove>(&event)) {
        pushed_ += move->by;
        return true;
    }
    if (const auto* const axis = std::get_if<view::GamepadAxis>(&event)) {
        switch (axis->axis) {
            case view::PadAxis::left_x:
                stick_.x = axis->value;
                return true;
            case view::PadAxis::left_y:
                stick_.y = axis->value;
                return true;
            case view::PadAxis::right_x:
                look_.x = axis->value;
                return true;
            case view::PadAxis::right_y:
                look_.y = axis->value;
                return true;
            default:
                break;
        }
    }
    const auto pull = pull_of(event);
    if (!pull) return false;
    bool used = false;
    for (std::size_t i = 0; i < action_count; ++i) {
        for (std::size_t place = 0; place < Bindings::places; ++place) {
            if (bindings.rows[i][place] != pull->trigger) continue;
            Button& button = buttons_[i];
            if (pull->down && !button.held[place]) button.pressed = true;
            button.held[place] = pull->down;
            used = true;
        }
    }
    return used;
}

Asked Controls::take(const GameSettings& settings, double seconds) {
    const auto button = [&](Action action) -> Button& { return buttons_[static_cast<std::size_t>(action)]; };
    const auto on = [&](Action action) { return button(action).is_held() || button(action).pressed ? 1.0 : 0.0; };
    Asked asked;
    asked.move = lively(stick_) * view::dvec2(1, -1) +
                 view::dvec2(on(Action::right) - on(Action::left), on(Action::forward) - on(Action::back));
    if (const double length = glm::length(asked.move); length > 1) asked.move /= length;
    const view::dvec2 look = lively(look_);
    asked.turn = pushed_ * mouse_turn * settings.mouse_sensitivity +
                 look * glm::length(look) * pad_turn * settings.pad_sensitivity * seconds;
    asked.turn.y = -asked.turn.y;
    if (settings.invert_x) asked.turn.x = -asked.turn.x;
    if (settings.invert_y) asked.turn.y = -asked.turn.y;
    // Of keys each says by its name where it turns.
    asked.turn +=
        view::dvec2(on(Action::look_right) - on(Action::look_left), on(Action::look_up) - on(Action::look_down)) *
        key_turn * settings.pad_sensitivity * seconds;
    asked.jump = on(Action::jump) > 0;
    asked.dash = on(Action::dash) > 0;
    asked.crouch = on(Action::crouch) > 0;
    asked.retry = button(Action::retry).pressed;
    pushed_ = {0, 0};
    for (Button& one : buttons_) one.pressed = false;
    return asked;
}

}  // namespace surefoot::platformer
