#include "platformer/screens/bindings.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::platformer {
namespace {

using view::Key;
using view::MouseButton;
using view::PadAxis;
using view::PadButton;

constexpr std::array<std::string_view, action_count> labels{
    "Run forward", "Run back", "Run left",  "Run right",        "Jump", "Dash", "Crouch", "Look left",
    "Look right",  "Look up",  "Look down", "Back to the flag", "Pause"};
constexpr std::array<std::string_view, action_count> words{"forward",   "back",   "left",      "right",      "jump",
                                                           "dash",      "crouch", "look_left", "look_right", "look_up",
                                                           "look_down", "retry",  "pause"};
constexpr std::array<std::string_view, 3> mouse_words{"left", "right", "middle"};

constexpr std::array<std::string_view, static_cast<std::size_t>(PadButton::count)> pad_labels{
    "A",     "B",          "X",           "Y",        "LB",          "RB",         "View",      "Menu",
    "Guide", "Left stick", "Right stick", "Cross up", "Cross right", "Cross down", "Cross left"};
constexpr std::array<std::string_view, static_cast<std::size_t>(PadAxis::count)> axis_labels{
    "Left stick", "Left stick", "Right stick", "Right stick", "LT", "RT"};

bool is_reserved(const Trigger& trigger) {
    return trigger == Trigger(Key::escape) || trigger == Trigger(PadButton::start);
}

bool looks(Action action) {
    return action >= Action::look_left && action <= Action::look_down;
}

/// Sticks run and look, the mouse looks, and Escape and Start pause, whatever is bound.
bool may_be_empty(Action action, std::size_t place) {
    return action == Action::pause || looks(action) || (place >= 2 && action <= Action::right);
}

bool has_other(const Bindings::Row& row, std::size_t place) {
    const std::size_t other = place ^ 1U;  // the other place of the same device
    return static_cast<bool>(row[other]);
}

}  // namespace

std::string_view label_of(Action action) {
    return labels[static_cast<std::size_t>(action)];
}

std::string_view word_of(Action action) {
    return words[static_cast<std::size_t>(action)];
}

std::string name_of(const Trigger& trigger) {
    switch (trigger.kind) {
        case Trigger::Kind::none:
            return {};
        case Trigger::Kind::key:
            return std::string(key_name(static_cast<Key>(trigger.code)));
        case Trigger::Kind::mouse: {
            std::string name(mouse_words[trigger.code]);
            name[0] = static_cast<char>(name[0] - 'a' + 'A');
            return name + " mouse";
        }
        case Trigger::Kind::pad:
            return std::string(pad_labels[trigger.code]);
        case Trigger::Kind::axis:
            return std::string(axis_labels[trigger.code]);
    }
    return {};
}

std::string text_of(const Trigger& trigger) {
    switch (trigger.kind) {
        case Trigger::Kind::none:
            return {};
        case Trigger::Kind::key:
            return "key " + std::string(key_name(static_cast<Key>(trigger.code)));
        case Trigger::Kind::mouse:
            return "mouse " + std::string(mouse_words[trigger.code]);
        case Trigger::Kind::pad:
            return "pad " + std::string(button_name(static_cast<PadButton>(trigger.code)));
        case Trigger::Kind::axis:
            return "axis " + std::string(axis_name(static_cast<PadAxis>(trigger.code)));
    }
    return {};
}

Trigger trigger_from(std::string_view text) {
    const std::size_t space = text.find(' ');
    if (space == std::string_view::npos) return {};
    const std::string_view kind = text.substr(0, space);
    const std::string_view name = text.substr(space + 1);
    if (kind == "key") {
        const Key key = view::key_named(name);
        if (key != Key::none) return key;
    } else if (kind == "mouse") {
        const auto found = std::find(mouse_words.begin(), mouse_words.end(), name);
        if (found != mouse_words.end()) return static_cast<MouseButton>(found - mouse_words.begin());
    } else if (kind == "pad") {
        const PadButton button = view::pad_button_named(name);
        if (button != PadButton::count) return button;
    } else if (kind == "axis") {
        const PadAxis axis = view::pad_axis_named(name);
        if (axis == PadAxis::left_trigger || axis == PadAxis::right_trigger) return axis;
    }
    return {};
}

std::optional<Pull> pull_of(const view::InputEvent& event) {
    if (const auto* const key = std::get_if<view::KeyPress>(&event)) {
        if (key->repeat || key->key == Key::none) return std::nullopt;
        return Pull{key->key, key->down};
    }
    if (const auto* const button = std::get_if<view::ButtonPress>(&event)) return Pull{button->button, button->down};
    if (const auto* const button = std::get_if<view::GamepadButton>(&event)) return Pull{button->button, button->down};
    if (const auto* const axis = std::get_if<view::GamepadAxis>(&event)) {
        if (axis->axis == PadAxis::left_trigger || axis->axis == PadAxis::right_trigger)
            return Pull{axis->axis, axis->value > 0};
    }
    return std::nullopt;
}

std::optional<Device> device_of(const view::InputEvent& event) {
    if (std::holds_alternative<view::KeyPress>(event) || std::holds_alternative<view::ButtonPress>(event) ||
        std::holds_alternative<view::WheelTurn>(event))
        return Device::keyboard;
    if (const auto* const move = std::get_if<view::PointerMove>(&event)) {
        if (std::abs(move->by.x) + std::abs(move->by.y) > 3) return Device::keyboard;
    }
    if (std::holds_alternative<view::GamepadButton>(event)) return Device::gamepad;
    if (const auto* const axis = std::get_if<view::GamepadAxis>(&event)) {
        const bool is_trigger = axis->axis == PadAxis::left_trigger || axis->axis == PadAxis::right_trigger;
        if (is_trigger ? axis->value > 0 : std::abs(axis->value) > 0.5) return Device::gamepad;
    }
    return std::nullopt;
}

Bindings Bindings::defaults() {
    Bindings all;
    all[Action::forward] = {Key::w, Key::up, {}, {}};
    all[Action::back] = {Key::s, Key::down, {}, {}};
    all[Action::left] = {Key::a, Key::left, {}, {}};
    all[Action::right] = {Key::d, Key::right, {}, {}};
    all[Action::jump] = {Key::space, {}, PadButton::a, {}};
    all[Action::dash] = {Key::shift, {}, PadButton::x, PadAxis::right_trigger};
    all[Action::crouch] = {Key::control, Key::c, PadButton::b, {}};
    all[Action::look_left] = {Key::q, {}, {}, {}};
    all[Action::look_right] = {Key::e, {}, {}, {}};
    all[Action::look_up] = {Key::page_up, {}, {}, {}};
    all[Action::look_down] = {Key::page_down, {}, {}, {}};
    all[Action::retry] = {Key::r, {}, PadButton::back, {}};
    all[Action::pause] = {Key::p, {}, {}, {}};
    return all;
}

bool Bindings::is(Action action, const Trigger& trigger) const {
    if (action == Action::pause && is_reserved(trigger)) return true;
    const Row& row = (*this)[action];
    return trigger && std::find(row.begin(), row.end(), trigger) != row.end();
}

Trigger Bindings::first(Action action, Device device) const {
    if (action == Action::pause) return device == Device::gamepad ? Trigger(PadButton::start) : Trigger(Key::escape);
    const Row& row = (*this)[action];
    const std::size_t at = device == Device::gamepad ? 2 : 0;
    return row[at] ? row[at] : row[at + 1];
}

std::optional<std::string> Bindings::bind(Action action, std::size_t place, const Trigger& trigger) {
    Row& row = (*this)[action];
    Trigger& here = row[place];
    if (is_reserved(trigger)) return name_of(trigger) + " always pauses";
    if (trigger && trigger.is_pad() != (place >= 2)) return std::string("that is of the other device");
    if (here == trigger) return std::nullopt;
    if (!trigger) {
        if (!has_other(row, place) && !may_be_empty(action, place))
            return std::string(label_of(action)) + " would have nothing left";
        here = {};
        return std::nullopt;
    }
    for (std::size_t i = 0; i < action_count; ++i) {
        for (std::size_t other = 0; other < places; ++other) {
            if (rows[i][other] != trigger) continue;
            if (&rows[i] != &row && !here && !has_other(rows[i], other) && !may_be_empty(static_cast<Action>(i), other))
                return std::string(label_of(static_cast<Action>(i))) + " would have nothing left";
            std::swap(rows[i][other], here);
            return std::nullopt;
        }
    }
    here = trigger;
    return std::nullopt;
}

std::string_view Bindings::always(Action action, Device device) {
    const bool pad = device == Device::gamepad;
    if (action == Action::pause) return pad ? "Start" : "Escape";
    if (pad && action <= Action::right) return "Left stick";
    if (looks(action)) return pad ? "Right stick" : "Mouse";
    return {};
}

bool Bindings::is_complete() const {
    for (std::size_t i = 0; i < action_count; ++i)
        for (const std::size_t place : {0U, 2U})
            if (!rows[i][place] && !has_other(rows[i], place) && !may_be_empty(static_cast<Action>(i), place))
                return false;
    return true;
}

std::vector<PromptPart> prompt_parts(std::string_view text, const Bindings& bindings, Device device) {
    std::vector<PromptPart> parts;
    const auto say = [&](std::string_view more) {
        if (more.empty()) return;
        if (!parts.empty() && !parts.back().is_key)
            parts.back().text += more;
        else
            parts.push_back({std::string(more), false});
    };
    const auto key = [&](std::string name) { parts.push_back({std::move(name), true}); };
    while (!text.empty()) {
        const std::size_t open = text.find('{');
        say(text.substr(0, open));
        if (open == std::string_view::npos) break;
        text.remove_prefix(open);
        const std::size_t close = text.find('}');
        const std::string_view word = text.substr(1, close == std::string_view::npos ? close : close - 1);
        const auto found = std::find(words.begin(), words.end(), word);
        if (close != std::string_view::npos && word == "camera") {
            key(device == Device::gamepad ? "Right stick" : "Mouse");
        } else if (close != std::string_view::npos && word == "move") {
            if (device == Device::gamepad) {
                key("Left stick");
            } else {
                for (const Action action : {Action::forward, Action::left, Action::back, Action::right})
                    key(name_of(bindings.first(action, device)));
            }
        } else if (close != std::string_view::npos && found != words.end()) {
            key(name_of(bindings.first(static_cast<Action>(found - words.begin()), device)));
        } else {
            say(text.substr(0, 1));
            text.remove_prefix(1);
            continue;
        }
        text.remove_prefix(close + 1);
    }
    return parts;
}

}  // namespace surefoot::platformer
