/// What takes START, END and corners by the hand: which of them is under the pointer, held, and selected.
#pragma once

#include <optional>

#include "playground/debugger_room/grips.hpp"
#include "playground/debugger_room/investigation.hpp"
#include "view/camera.hpp"
#include "view/input.hpp"

namespace surefoot::playground {

/// What a press or a release did.
enum class Grasp : std::uint8_t {
    nothing,  ///< nothing is there to be taken
    taken,
    dropped,  ///< what was held is let go
};

class Hands {
public:
    explicit Hands(Investigation& asked) : asked_(asked) {}

    /// From where, and how large the picture is.
    struct Eye {
        view::Camera camera;
        view::ivec2 size;
    };

    Grasp button(const view::ButtonPress& press, const Eye& eye);
    /// Drags what is held, on a grid while Shift is; true if something is. Else looks what is under the pointer.
    bool move(const view::PointerMove& move, const Eye& eye, double grid);
    void let_go();
    [[nodiscard]] bool hold() const { return drag_.has_value(); }
    /// True if something was selected.
    bool deselect();
    /// The question has changed: what is not there any more is not selected.
    void follow();
    /// Nothing is under the pointer that could be taken.
    void look_away() { hovered_.reset(); }

    [[nodiscard]] const std::optional<Target>& selected() const { return selected_; }
    [[nodiscard]] const std::optional<Grip>& hovered() const { return hovered_; }

private:
    Investigation& asked_;
    std::optional<Target> selected_;
    std::optional<Grip> hovered_;
    std::optional<Drag> drag_;
    std::optional<view::dvec2> pressed_at_;  // a press on nothing, which may become a click
};

}  // namespace surefoot::playground
