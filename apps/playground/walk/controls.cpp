#include "playground/walk/controls.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

namespace surefoot::playground {
namespace {

using view::dvec2;
using view::GamepadAxis;
using view::GamepadButton;
using view::Key;

// A stick that nobody touches does not stand exactly in its middle.
constexpr double dead_zone = 0.18;

dvec2 without_dead_zone(const dvec2& stick) {
    const double length = glm::length(stick);
    if (length <= dead_zone) return {0, 0};
    return stick / length * std::min((length - dead_zone) / (1 - dead_zone), 1.0);
}

}  // namespace

bool Controls::event(const view::InputEvent& event) {
    const auto use_of_key = [](Key key) -> std::optional<Use> {
        switch (key) {
            case Key::w:
                return forth;
            case Key::s:
                return back;
            case Key::a:
                return left;
            case Key::d:
                return right;
            case Key::space:
                return jump;
            case Key::shift:
                return run;
            case Key::control:
                return crouch;
            case Key::q:
                return dash;
            default:
                return std::nullopt;
        }
    };
    const auto use_of_button = [](view::PadButton button) -> std::optional<Use> {
        switch (button) {
            case view::PadButton::a:
                return jump;
            case view::PadButton::b:
                return crouch;
            case view::PadButton::x:
                return dash;
            case view::PadButton::right_bumper:
                return run;
            default:
                return std::nullopt;
        }
    };
    if (const auto* const press = std::get_if<view::KeyPress>(&event)) {
        const auto use = use_of_key(press->key);
        if (!use) return false;
        if (!press->repeat) keys_[*use].set(press->down);
        return true;
    }
    if (const auto* const press = std::get_if<GamepadButton>(&event)) {
        const auto use = use_of_button(press->button);
        if (use) pad_[*use].set(press->down);
        return use.has_value();
    }
    if (const auto* const move = std::get_if<GamepadAxis>(&event)) {
        switch (move->axis) {
            case view::PadAxis::left_x:
                stick_.x = move->value;
                return true;
            case view::PadAxis::left_y:
                stick_.y = move->value;
                return true;
            case view::PadAxis::right_x:
                look_.x = move->value;
                return true;
            case view::PadAxis::right_y:
                look_.y = move->value;
                return true;
            default:
                return false;
        }
    }
    if (const auto* const focus = std::get_if<view::FocusChange>(&event); focus != nullptr && !focus->focused)
        release();
    return false;
}

void Controls::release() {
    keys_ = {};
    pad_ = {};
    stick_ = look_ = {0, 0};
}

dvec2 Controls::look() const {
    return without_dead_zone(look_);
}

CharacterInput Controls::take(const dvec3& ahead) {
    std::array<bool, use_count> on{};
    for (std::size_t i = 0; i < use_count; ++i) {
        const bool key = keys_[i].take();
        const bool pad = pad_[i].take();
        on[i] = key || pad;
    }
    const dvec2 stick = without_dead_zone(stick_);
    dvec2 way(double(on[right]) - double(on[left]) + stick.x, double(on[forth]) - double(on[back]) - stick.y);
    const double length = glm::length(way);
    if (length > 1) way /= length;
    const dvec3 up(0, 1, 0);
    const dvec3 sideways = glm::cross(ahead, up);
    CharacterInput input;
    input.mode = mode;
    input.wish = (ahead * way.y + sideways * way.x) * (on[run] ? run_speed : walk_speed);
    input.jump = on[jump];
    input.crouch = on[crouch];
    input.dash = on[dash];
    if (mode != CharacterMode::walk) input.wish += up * ((double(on[jump]) - double(on[crouch])) * walk_speed);
    return input;
}

}  // namespace surefoot::playground
