/// A part of the Debugger room: widgets, and what they put into the world, all about the question that is being asked.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/arena.hpp"
#include "debugger/made_step.hpp"
#include "debugger/question.hpp"
#include "debugger/saved_step.hpp"
#include "playground/room.hpp"

namespace surefoot::playground {

/// What all panels look at. The room keeps it, and asks anew whenever the question changes.
struct Inquiry {
    const debugger::Question& question;
    const debugger::Arena& arena;
    const std::optional<Hit>& hit;
    double t = 1;  ///< the moment that is looked at [0, 1]: the shape is drawn there too. A panel's slider may set it
    bool is_dragged = false;                          ///< what takes long can wait until it no longer is
    const debugger::MadeStep* step = nullptr;         ///< whose end is RESULT; none where there is no room around it
    const debugger::SavedStep* saved_step = nullptr;  ///< where that comes from a file
};

class Panel {
public:
    Panel() = default;
    Panel(const Panel&) = delete;
    Panel& operator=(const Panel&) = delete;
    virtual ~Panel() = default;

    /// In the bar of panels, and for scripts: `click "Mathematics"`.
    [[nodiscard]] virtual std::string_view name() const = 0;

    /// The stage, once, before anything else.
    virtual void enter(Stage& /*stage*/) {}

    /// The question, the arena or the answer is another. Expensive work belongs here.
    virtual void changed(const Inquiry& inquiry) = 0;

    /// A tick of 1/60 s, while it is open; true while something moves.
    virtual bool update(double /*dt*/, Inquiry& /*inquiry*/) { return false; }

    /// Into the world, while it is open.
    virtual void draw(view::Renderer& renderer, const Inquiry& inquiry) = 0;

    /// Its widgets, inside of a window that the room has begun.
    virtual void ui(Inquiry& inquiry) = 0;

    /// A lesson has a scene of its own: while it is open the question's world and shapes are not drawn.
    [[nodiscard]] virtual bool has_own_scene() const { return false; }

    /// What of its own should be seen, besides the question if that is drawn.
    [[nodiscard]] virtual std::vector<dvec3> scene_places() const { return {}; }
};

}  // namespace surefoot::playground
