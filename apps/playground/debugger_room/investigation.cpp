#include "playground/debugger_room/investigation.hpp"

#include <array>

#include "debugger/worlds.hpp"

namespace surefoot::playground {
namespace {

using debugger::Question;
using debugger::WorldKind;

std::optional<Mesh> mesh_of(const std::vector<Triangle>& triangles) {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (const Triangle& triangle : triangles) {
        for (const dvec3& corner : debugger::corners_of(triangle)) {
            indices.push_back(static_cast<std::uint32_t>(vertices.size()));
            vertices.push_back(vec3(corner));
        }
    }
    auto mesh = Mesh::build({.vertices = vertices, .indices = indices});
    if (!mesh) return std::nullopt;
    return std::move(*mesh);
}

bool same_world(const Question& a, const Question& b) {
    Question other = b;
    other.triangles = a.triangles;
    other.level = a.level;
    other.opened = a.opened;
    other.world = a.world;
    return other == b;
}

}  // namespace

Investigation::Investigation()
    : history_(debugger::default_question(WorldKind::triangle)), arena_(history_.now().triangles) {
    follow(true);
}

dvec3 Investigation::place_at(double t) const {
    const Motion& motion = question().motion;
    return motion.from + t * (motion.to - motion.from);
}

Triangle Investigation::triangle_hit() const {
    return level_ ? level_->level.mesh.triangle(hit_->triangle) : question().triangles[hit_->triangle];
}

void Investigation::apply(const debugger::Edit& edit) {
    const Question before = question();
    history_.apply(edit);
    if (question() == before) return;
    follow(!same_world(question(), before));
}

void Investigation::end_drag() {
    history_.end_drag();
    if (search_waits_) ask();
}

void Investigation::undo() {
    end_drag();
    const Question before = question();
    if (history_.undo()) follow(!same_world(question(), before));
}

void Investigation::redo() {
    end_drag();
    const Question before = question();
    if (history_.redo()) follow(!same_world(question(), before));
}

void Investigation::choose_world(WorldKind world) {
    apply(debugger::Replace{debugger::default_question(world)});
}

void Investigation::show(const LevelLoader::Loaded& level) {
    const std::string& file = level->level.file;
    levels_.push_back(level);
    Question question = debugger::question_in_level(file, level->level.mesh.bounds());
    question.opened = static_cast<std::uint32_t>(levels_.size());
    apply(debugger::Replace{std::move(question)});
}

void Investigation::show(const Moment& moment) {
    apply(debugger::Replace{moment.question});
    moment_ = moment;
    saved_step_.reset();
    ask();
}

void Investigation::show(const debugger::SavedStep& step) {
    apply(debugger::Replace{step.question});
    moment_.reset();
    saved_step_ = step;
    step_ = debugger::recorded_step(saved_step_->capture);
    ++version_;
}

void Investigation::choose_search(Search search) {
    search_ = search;
    ask();
}

void Investigation::follow(bool other_world) {
    if (moment_ && !(moment_->question == question())) moment_.reset();
    if (saved_step_ && !(saved_step_->question == question())) saved_step_.reset();
    if (other_world) {
        const Question& now = question();
        level_ = now.world == WorldKind::level && now.opened > 0 ? levels_[now.opened - 1] : nullptr;
        mesh_ = level_ ? std::optional(level_->level.mesh) : mesh_of(now.triangles);
        arena_ = level_ ? debugger::Arena(level_->level.mesh) : debugger::Arena(now.triangles);
        ++world_version_;
    }
    ask();
}

void Investigation::ask() {
    const Question& now = question();
    const Volume volume = now.volume();
    by_tree_.reset();
    search_waits_ = level_ && search_ == Search::brute_force && history_.is_dragged() &&
                    mesh_->triangle_count() > most_asked_while_dragged;
    if (level_ && search_ == Search::brute_force && !search_waits_) {
        hit_ = mesh_->sweep(volume, now.motion, {.one_sided = now.one_sided, .search = search_});
        by_tree_ = arena_.sweep(volume, now.motion, now.one_sided);
    } else {
        hit_ = arena_.sweep(volume, now.motion, now.one_sided);
    }
    step_ = saved_step_ ? debugger::recorded_step(saved_step_->capture)
                        : debugger::make_step(arena_.world(), debugger::order_of(now));
    ++version_;
}

Capture Investigation::capture() const {
    const Question& now = question();
    if (level_) return capture_sweep(level_->level.mesh, now.volume(), now.motion, {.one_sided = now.one_sided});
    return capture_of(now, hit_);
}

}  // namespace surefoot::playground
