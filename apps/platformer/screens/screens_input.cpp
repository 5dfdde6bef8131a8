// From keys, pointer, buttons and sticks to what is meant on a screen.
#include <algorithm>
#include <cmath>

#include "platformer/screens/arrange.hpp"
#include "platformer/screens/screens.hpp"
#include "platformer/screens/settings_rows.hpp"

namespace surefoot::platformer {
namespace {

using view::Key;
using view::PadButton;

constexpr double first_wait = 0.4;  // [s] until a stick that is held moves on
constexpr double next_wait = 0.12;
constexpr double guard_time = 0.8;   // [s] that a screen which comes by itself is looked at before anything is chosen
constexpr double pause_time = 0.35;  // [s] that hands which are busy in that time have to rest

/// What chooses on a screen, or goes back from it.
bool decides(const Trigger& trigger) {
    for (const Trigger one : {Trigger(Key::enter), Trigger(Key::space), Trigger(Key::escape), Trigger(Key::backspace),
                              Trigger(view::MouseButton::left), Trigger(PadButton::a), Trigger(PadButton::b)})
        if (trigger == one) return true;
    return false;
}

}  // namespace

void Screens::guard_hands() {
    guard_left_ = guard_time;
}

/// Does this press come from before the screen was looked at? Who hammers a key goes on for a while.
bool Screens::is_too_soon(const view::InputEvent& event) {
    if (guard_left_ <= 0 || is_playing() || (top() != ScreenId::win && top() != ScreenId::lose)) return false;
    const auto pull = pull_of(event);
    if (!pull || !pull->down || !decides(pull->trigger)) return false;
    guard_left_ = std::max(guard_left_, pause_time);
    return true;
}

bool Screens::event(const view::InputEvent& event) {
    if (const auto device = device_of(event)) device_ = *device;
    if (std::holds_alternative<view::Resize>(event) || std::holds_alternative<view::CloseRequest>(event) ||
        std::holds_alternative<view::ScaleChange>(event))
        return false;
    if (is_too_soon(event)) return true;
    if (is_playing()) {
        const auto pull = pull_of(event);
        const auto* const focus = std::get_if<view::FocusChange>(&event);
        const bool away = focus != nullptr && !focus->focused;
        if (!away && !(pull && pull->down && settings_.bindings.is(Action::pause, pull->trigger))) return false;
        pause();
        return !away;  // the game lets go of its keys too
    }
    if (capture(event) || typing(event)) return true;
    pointer(event);
    obey(intent_of(event));
    return true;
}

void Screens::tick(double seconds) {
    if (notice_left_ > 0) {
        notice_left_ -= seconds;
        if (notice_left_ <= 0) notice_.clear();
    }
    guard_left_ = std::max(0.0, guard_left_ - seconds);
    if (capture_) {
        capture_->left -= seconds;
        if (capture_->left <= 0) capture_.reset();
    }
    if (stack_.empty() || stick_way_ == Intent::none) return;
    stick_wait_ -= seconds;
    if (stick_wait_ > 0) return;
    stick_wait_ = next_wait;
    obey(stick_way_);
}

/// The key for a binding that waits for one. What is no answer waits on; Escape and Start are the way out.
bool Screens::capture(const view::InputEvent& event) {
    if (!capture_) return false;
    const auto pull = pull_of(event);
    if (!pull || !pull->down) return true;
    if (pull->trigger == Trigger(Key::escape) || pull->trigger == Trigger(PadButton::start)) {
        capture_.reset();
        return true;
    }
    if (pull->trigger.is_pad() != (capture_->place >= 2)) return true;
    if (auto why = settings_.bindings.bind(capture_->action, capture_->place, pull->trigger)) {
        say(*why);
    } else {
        commands_.push_back({Command::Kind::settings, {}});
    }
    capture_.reset();
    return true;
}

/// A line that is in focus takes letters, with the keys that bring them; the others are there to move on.
bool Screens::typing(const view::InputEvent& event) {
    if (top() != ScreenId::form) return false;
    const Menu now = menu();
    const Entry& entry = now.entries[focus()];
    if (entry.kind != Entry::Kind::line) return false;
    FormField& field = form_.fields[entry.index];
    if (const auto* const letters = std::get_if<view::TextInput>(&event)) {
        field.type(letters->text);
        return true;
    }
    const auto* const key = std::get_if<view::KeyPress>(&event);
    if (key == nullptr) return false;
    switch (key->key) {
        case Key::backspace:
            if (key->down) field.erase();
            return true;
        case Key::del:
            if (key->down) field.text.clear();
            return true;
        case Key::enter:
            // A form of one line is done with it.
            if (form_.fields.size() > 1) return false;
            if (key->down && !key->repeat && form_.is_complete()) end_form(Command::Kind::answered);
            return true;
        case Key::up:
        case Key::down:
        case Key::left:
        case Key::right:
        case Key::tab:
        case Key::escape:
            return false;
        default:
            return true;
    }
}

Screens::Intent Screens::intent_of(const view::InputEvent& event) {
    if (const auto* const key = std::get_if<view::KeyPress>(&event)) {
        if (!key->down) return Intent::none;
        switch (key->key) {
            case Key::up:
            case Key::w:
                return Intent::up;
            case Key::down:
            case Key::s:
                return Intent::down;
            case Key::left:
            case Key::a:
                return Intent::leftwards;
            case Key::right:
            case Key::d:
                return Intent::rightwards;
            case Key::tab:
                return key->held.shift ? Intent::previous : Intent::next;
            case Key::enter:
            case Key::space:
                return key->repeat ? Intent::none : Intent::accept;
            case Key::escape:
            case Key::backspace:
                return key->repeat ? Intent::none : Intent::back;
            case Key::del:
                return Intent::clear;
            default:
                return Intent::none;
        }
    }
    if (const auto* const button = std::get_if<view::GamepadButton>(&event)) {
        if (!button->down) return Intent::none;
        switch (button->button) {
            case PadButton::up:
                return Intent::up;
            case PadButton::down:
                return Intent::down;
            case PadButton::left:
                return Intent::leftwards;
            case PadButton::right:
                return Intent::rightwards;
            case PadButton::a:
                return Intent::accept;
            case PadButton::b:
                return Intent::back;
            case PadButton::start:
                return top() == ScreenId::pause ? Intent::back : Intent::none;
            case PadButton::x:
                return Intent::clear;
            case PadButton::left_bumper:
                return Intent::previous;
            case PadButton::right_bumper:
                return Intent::next;
            default:
                return Intent::none;
        }
    }
    if (const auto* const axis = std::get_if<view::GamepadAxis>(&event)) {
        if (axis->axis == view::PadAxis::left_x) stick_.x = axis->value;
        if (axis->axis == view::PadAxis::left_y) stick_.y = axis->value;
        return stick_intent();
    }
    return Intent::none;
}

/// A stick that is pushed is a key that is held; let go later than it was pushed, so that it does not chatter.
Screens::Intent Screens::stick_intent() {
    const double reach = std::max(std::abs(stick_.x), std::abs(stick_.y));
    if (reach < 0.35) stick_way_ = Intent::none;
    if (reach < 0.6) return Intent::none;
    const Intent way = std::abs(stick_.x) > std::abs(stick_.y) ? (stick_.x > 0 ? Intent::rightwards : Intent::leftwards)
                                                               : (stick_.y > 0 ? Intent::down : Intent::up);
    if (way == stick_way_) return Intent::none;
    stick_way_ = way;
    stick_wait_ = first_wait;
    return way;
}

void Screens::pointer(const view::InputEvent& event) {
    const double unit = layout_.pixels() / layout_.per_window_unit;
    const Menu now = menu();
    const Arrangement all = arrange(now, layout_.size(), scroll());
    const auto entry_at = [&](const view::dvec2& place) -> std::optional<std::size_t> {
        if (!all.page.has(place)) return std::nullopt;
        for (std::size_t i = 0; i < all.places.size(); ++i)
            if (now.entries[i].can_focus() && all.places[i].has(place)) return i;
        return std::nullopt;
    };
    const auto drag = [&](std::size_t at, double x) {
        const view::Rect rail = rail_of(all.places[at]);
        set_share(setting_rows()[now.entries[at].index], settings_, (x - rail.low.x) / rail.size().x);
        commands_.push_back({Command::Kind::settings, {}});
    };
    if (const auto* const move = std::get_if<view::PointerMove>(&event)) {
        const view::dvec2 at = move->at / unit;
        if (dragged_) {
            drag(*dragged_, at.x);
        } else if (const auto over = entry_at(at)) {
            stack_.back().focus = *over;
        }
    } else if (const auto* const wheel = std::get_if<view::WheelTurn>(&event)) {
        stack_.back().scroll = std::clamp(scroll() - wheel->by.y * 48, 0.0, all.highest_scroll);
    } else if (const auto* const press = std::get_if<view::ButtonPress>(&event)) {
        if (!press->down) {
            dragged_.reset();
            return;
        }
        const view::dvec2 at = press->at / unit;
        const auto over = entry_at(at);
        if (!over || press->button != view::MouseButton::left) return;
        stack_.back().focus = *over;
        const Entry& entry = now.entries[*over];
        if (entry.kind == Entry::Kind::slider) {
            dragged_ = *over;
            drag(*over, at.x);
        } else if (entry.kind == Entry::Kind::choice) {
            change(entry, at.x < rail_of(all.places[*over]).middle().x ? -1 : 1);
        } else if (entry.kind != Entry::Kind::line) {
            choose(entry);
        }
    }
}

}  // namespace surefoot::platformer
