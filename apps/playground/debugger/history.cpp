#include "debugger/history.hpp"

#include <fmt/format.h>
#include <utility>

namespace surefoot::debugger {

namespace {

struct Doing {
    Question& question;

    void operator()(const MoveStart& edit) const { question.motion.from = edit.to; }
    void operator()(const MoveEnd& edit) const { question.motion.to = edit.to; }
    void operator()(const MoveCorner& edit) const {
        if (edit.triangle >= question.triangles.size() || edit.corner > 2) return;
        const dvec3 from = corner_of(question.triangles[edit.triangle], edit.corner);
        if (!edit.alone) {
            for (Triangle& triangle : question.triangles) {
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    if (corner_of(triangle, corner) == from) corner_of(triangle, corner) = edit.to;
                }
            }
        }
        corner_of(question.triangles[edit.triangle], edit.corner) = edit.to;
    }
    void operator()(const ChooseShape& edit) const { question.shape = edit.name; }
    void operator()(const Resize& edit) const {
        question.sizes.set(edit.shape);
        question.shape = name_of(edit.shape);
    }
    void operator()(const Turn& edit) const { question.orientation = edit.orientation; }
    void operator()(const ChooseSides& edit) const { question.one_sided = edit.one_sided; }
    void operator()(const Replace& edit) const { question = edit.question; }
};

/// Edits of the same target merge within one drag.
std::string target_of(const Edit& edit) {
    if (const auto* corner = std::get_if<MoveCorner>(&edit))
        return fmt::format("{}/{}/{}", edit.index(), corner->triangle, corner->corner);
    return std::to_string(edit.index());
}

}  // namespace

Question edited(const Question& question, const Edit& edit) {
    Question after = question;
    std::visit(Doing{after}, edit);
    return after;
}

std::string title_of(const Edit& edit) {
    static constexpr const char* titles[] = {"move START",       "move END", "move a corner", "choose a shape",
                                             "change its sizes", "turn it",  "choose sides",  "another question"};
    static_assert(std::size(titles) == std::variant_size_v<Edit>);
    return titles[edit.index()];
}

void History::apply(const Edit& edit) {
    Question after = edited(now_, edit);
    if (after == now_) return;
    const std::string target = target_of(edit);
    undone_.clear();
    if (!merges_ || done_.empty() || done_.back().target != target) {
        if (done_.size() == most_steps) done_.erase(done_.begin());
        done_.push_back({title_of(edit), target, std::move(now_)});
    }
    merges_ = dragging_;
    now_ = std::move(after);
}

bool History::take_back(std::vector<Step>& from, std::vector<Step>& into, Question& now) {
    if (from.empty()) return false;
    Step step = std::move(from.back());
    from.pop_back();
    std::swap(step.other, now);
    into.push_back(std::move(step));
    return true;
}

bool History::undo() {
    end_drag();
    return take_back(done_, undone_, now_);
}

bool History::redo() {
    end_drag();
    return take_back(undone_, done_, now_);
}

}  // namespace surefoot::debugger
