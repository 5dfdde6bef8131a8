/// The question that is being asked, with the history of its edits, the world it is asked of, and the answer, which
/// follows every edit.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <surefoot/mesh.hpp>
#include <surefoot/query.hpp>

#include "debugger/arena.hpp"
#include "debugger/history.hpp"
#include "debugger/made_step.hpp"
#include "debugger/question.hpp"
#include "debugger/saved_step.hpp"
#include "playground/debugger_room/saved_moment.hpp"
#include "playground/level_loader.hpp"

namespace surefoot::playground {

class Investigation {
public:
    Investigation();

    [[nodiscard]] const debugger::Question& question() const { return history_.now(); }
    [[nodiscard]] const debugger::History& history() const { return history_; }
    [[nodiscard]] const debugger::Arena& arena() const { return arena_; }
    [[nodiscard]] const std::optional<Hit>& hit() const { return hit_; }

    /// Is there a hit with a point and a normal?
    [[nodiscard]] bool touches() const { return hit_ && hit_->status == HitStatus::ok; }
    [[nodiscard]] dvec3 place_at(double t) const;
    /// What was hit. Requires: `touches()`.
    [[nodiscard]] Triangle triangle_hit() const;
    /// What `step` makes of it: RESULT is where it leaves the shape, and its story tells what turned it aside. Of a
    /// saved step it is that one, as it was recorded.
    [[nodiscard]] const debugger::MadeStep& step() const { return step_; }
    [[nodiscard]] const dvec3& result() const { return step_.result.state.position; }

    /// The world in floats, for rays of the eye and for drawing; none while its corners are no numbers.
    [[nodiscard]] const std::optional<Mesh>& mesh() const { return mesh_; }
    /// None for a few triangles.
    [[nodiscard]] const LevelLoader::Loaded& level() const { return level_; }

    /// Other numbers after every change: of anything, and of the world.
    [[nodiscard]] std::uint64_t version() const { return version_; }
    [[nodiscard]] std::uint64_t world_version() const { return world_version_; }

    void apply(const debugger::Edit& edit);
    void begin_drag() { history_.begin_drag(); }
    void end_drag();
    void undo();
    void redo();

    /// One of the worlds of a few triangles, with its own question.
    void choose_world(debugger::WorldKind world);
    /// A level, with a question that crosses it. It is kept, for undo.
    void show(const LevelLoader::Loaded& level);
    void show(const Moment& moment);
    void show(const debugger::SavedStep& step);
    /// The saved moment, while the question is still its own.
    [[nodiscard]] const std::optional<Moment>& moment() const { return moment_; }
    /// The saved step, likewise.
    [[nodiscard]] const std::optional<debugger::SavedStep>& saved_step() const { return saved_step_; }

    /// How a level is searched: by its tree, or by asking every triangle.
    [[nodiscard]] Search search() const { return search_; }
    void choose_search(Search search);
    /// Every triangle of a very large level is asked only once a drag is over; until then the answer is the tree's.
    [[nodiscard]] bool search_waits() const { return search_waits_; }
    static constexpr std::size_t most_asked_while_dragged = 200000;
    /// The tree's answer, when every triangle was asked.
    [[nodiscard]] const std::optional<Hit>& by_tree() const { return by_tree_; }

    /// The question and its answer with the triangles near the way.
    [[nodiscard]] Capture capture() const;

private:
    void follow(bool other_world);
    void ask();

    debugger::History history_;
    debugger::Arena arena_;
    std::optional<Mesh> mesh_;
    LevelLoader::Loaded level_;
    std::vector<LevelLoader::Loaded> levels_;  // that were opened, for undo; `Question::opened` counts from 1
    std::optional<Hit> hit_;
    std::optional<Hit> by_tree_;
    debugger::MadeStep step_;
    std::optional<Moment> moment_;
    std::optional<debugger::SavedStep> saved_step_;
    Search search_ = Search::tree;
    bool search_waits_ = false;
    std::uint64_t version_ = 0;
    std::uint64_t world_version_ = 0;
};

}  // namespace surefoot::playground
