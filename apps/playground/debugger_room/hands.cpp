#include "playground/debugger_room/hands.hpp"

#include <glm/geometric.hpp>

namespace surefoot::playground {

Grasp Hands::button(const view::ButtonPress& press, const Eye& eye) {
    if (press.button != view::MouseButton::left) return Grasp::nothing;
    if (press.down) {
        const auto grips = grips_of(asked_.question(), selected_, eye.camera, eye.size);
        const auto grabbed = grab(grips, eye.camera, press.at, eye.size);
        if (!grabbed) {
            pressed_at_ = press.at;
            return Grasp::nothing;
        }
        selected_ = grabbed->grip.target;
        hovered_ = grabbed->grip;
        drag_.emplace(*grabbed, asked_.question());
        asked_.begin_drag();
        return Grasp::taken;
    }
    if (drag_) {
        let_go();
        return Grasp::dropped;
    }
    // What hardly moved between press and release was a click: on nothing, it lets go of what is selected.
    constexpr double hardly = 4;
    if (pressed_at_ && glm::length(press.at - *pressed_at_) <= hardly) selected_.reset();
    pressed_at_.reset();
    return Grasp::nothing;
}

bool Hands::move(const view::PointerMove& move, const Eye& eye, double grid) {
    if (drag_) {
        const auto place = drag_->to(eye.camera, move.at, eye.size, move.held.shift ? grid : 0);
        if (place) asked_.apply(moved_to(drag_->grip().target, *place));
        return true;
    }
    const auto grabbed =
        grab(grips_of(asked_.question(), selected_, eye.camera, eye.size), eye.camera, move.at, eye.size);
    hovered_ = grabbed ? std::optional(grabbed->grip) : std::nullopt;
    return false;
}

void Hands::let_go() {
    if (!drag_) return;
    drag_.reset();
    asked_.end_drag();
}

bool Hands::deselect() {
    const bool was_selected = selected_.has_value();
    selected_.reset();
    return was_selected;
}

void Hands::follow() {
    if (selected_ && selected_->kind == Target::Kind::corner &&
        selected_->triangle >= asked_.question().triangles.size())
        selected_.reset();
}

}  // namespace surefoot::playground
