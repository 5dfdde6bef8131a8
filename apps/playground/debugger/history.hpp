/// Edits of a question, one step each, with undo and redo. A drag is one step, however many times the mouse moved.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "debugger/question.hpp"

namespace surefoot::debugger {

struct MoveStart {
    dvec3 to;
};
struct MoveEnd {
    dvec3 to;
};
/// Moves one corner, and with it all corners that are at exactly the same place, so that a fold stays whole.
struct MoveCorner {
    std::size_t triangle = 0;
    std::size_t corner = 0;  ///< 0: a, 1: b, 2: c
    dvec3 to;
    bool alone = false;  ///< leaves the others behind
};
struct ChooseShape {
    ShapeName name;
};
/// Sets the sizes of the shape that it is, and shows that shape.
struct Resize {
    Shape shape;
};
struct Turn {
    dquat orientation;
};
struct ChooseSides {
    bool one_sided;
};
/// Another world, or a pasted question.
struct Replace {
    Question question;
};

using Edit = std::variant<MoveStart, MoveEnd, MoveCorner, ChooseShape, Resize, Turn, ChooseSides, Replace>;

/// The question after an edit. A corner that is not there is no edit.
[[nodiscard]] Question edited(const Question& question, const Edit& edit);

/// What an edit does, for a menu: "move START".
[[nodiscard]] std::string title_of(const Edit& edit);

class History {
public:
    explicit History(Question question) : now_(std::move(question)) {}

    [[nodiscard]] const Question& now() const { return now_; }

    /// Does an edit; one that changes nothing is no step. What had been undone can no longer be redone.
    void apply(const Edit& edit);

    /// Between these two, edits of the same thing are one step.
    void begin_drag() { dragging_ = true; }
    void end_drag() { dragging_ = merges_ = false; }
    [[nodiscard]] bool is_dragged() const { return dragging_; }

    /// False if there is nothing to undo, or to redo. Both end a drag.
    bool undo();
    bool redo();

    /// What they would undo or redo; empty for nothing.
    [[nodiscard]] std::string undo_title() const { return done_.empty() ? "" : done_.back().title; }
    [[nodiscard]] std::string redo_title() const { return undone_.empty() ? "" : undone_.back().title; }

    /// The oldest steps are forgotten beyond this.
    static constexpr std::size_t most_steps = 1000;

private:
    struct Step {
        std::string title;
        std::string target;  ///< what it changed, to merge the edits of a drag
        Question other;      ///< before a step that can be undone, after one that can be redone
    };

    static bool take_back(std::vector<Step>& from, std::vector<Step>& into, Question& now);

    Question now_;
    std::vector<Step> done_;
    std::vector<Step> undone_;
    bool dragging_ = false;
    bool merges_ = false;  ///< is the last step one of this drag?
};

}  // namespace surefoot::debugger
