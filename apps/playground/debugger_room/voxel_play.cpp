#include "playground/debugger_room/voxel_play.hpp"

#include <algorithm>

namespace surefoot::playground {

using debugger::VoxelLesson;
using debugger::VoxelMethod;
using debugger::VoxelScene;
using debugger::VoxelStep;

namespace {

/// A floor of full blocks, a cell high.
void add_floor(VoxelScene& scene) {
    for (std::int32_t x = 0; x < scene.window.cells.x; ++x)
        for (std::int32_t z = 0; z < scene.window.cells.z; ++z) scene.solid.push_back({x, 0, z});
}

/// The model's corner, and as much of what is around as is needed: four cells along x and z.
VoxelScene corner(std::int32_t first) {
    VoxelScene scene = debugger::corner_scene();
    scene.window.first = {first, 0, first};
    scene.window.cells = {4, 3, 4};
    return scene;
}

/// Down and sideways at once, at the edge of a block: each axis alone passes it.
VoxelScene step_scene() {
    VoxelScene scene;
    scene.window = {.first = {0, 0, 0}, .cells = {4, 3, 4}};
    add_floor(scene);
    for (std::int32_t x = 2; x < 4; ++x)
        for (std::int32_t z = 1; z < 3; ++z) scene.solid.push_back({x, 1, z});
    scene.box = {.half_extents = {0.25, 0.75, 0.25}};
    scene.from = {1.6, 2.9, 2};
    scene.displacement = {0.7, -0.7, 0};
    return scene;
}

}  // namespace

std::span<const VoxelStory> voxel_stories() {
    static const std::array stories{
        VoxelStory{"The corner",
                   "A box passes the corner of a wall slantwise. Each axis alone is free; both together "
                   "lead into a block.",
                   corner(1), 1},
        VoxelStory{"The wall it walks through",
                   "The same move, three times in a row. What it stands in does not hold "
                   "it, so it comes out at the other side.",
                   corner(2), 3},
        VoxelStory{"The step it falls into",
                   "It falls, and steers over the edge of a block while it does. Falling "
                   "straight down is free, and so is going sideways.",
                   step_scene(), 1}};
    return stories;
}

VoxelTale tell(const VoxelStory& story, VoxelMethod method) {
    VoxelTale tale;
    tale.method = method;
    VoxelScene scene = story.scene;
    bool was_inside = false;
    for (int move = 0; move < story.moves; ++move) {
        VoxelLesson lesson = voxel_lesson(scene, method);
        for (VoxelStep& step : lesson.steps) {
            was_inside = was_inside || step.inside;
            tale.steps.push_back(std::move(step));
            tale.move_of.push_back(move);
        }
        scene.from = lesson.result.position;
        tale.conclusion = std::move(lesson.conclusion);
        if (was_inside && !lesson.ends_inside)
            tale.conclusion = "It has gone through the wall: it was let in, and nothing held it on its way out.";
    }
    return tale;
}

void VoxelPlay::choose(std::size_t story) {
    chosen_ = std::min(story, voxel_stories().size() - 1);
    wrong_ = tell(this->story(), VoxelMethod::all_from_the_start);
    right_ = tell(this->story(), VoxelMethod::each_from_the_last);
    count_ = static_cast<int>(wrong_.steps.size());
    restart();
}

void VoxelPlay::next() {
    if (taken_ == count_) return;
    ++taken_;
    since_ = 0;
}

void VoxelPlay::back() {
    plays_ = false;
    taken_ = std::max(taken_ - 1, 0);
    since_ = walk_time;
}

void VoxelPlay::restart() {
    plays_ = false;
    taken_ = 0;
    since_ = walk_time;
}

void VoxelPlay::play() {
    if (taken_ == count_) restart();
    plays_ = true;
}

bool VoxelPlay::update(double dt) {
    const bool moves = plays_ || since_ < walk_time;
    since_ += dt;
    if (plays_ && since_ >= walk_time + (taken_ == 0 ? 0 : rest_time)) {
        next();
        plays_ = taken_ < count_;
    }
    return moves;
}

double VoxelPlay::share() const {
    const double part = std::clamp(since_ / walk_time, 0.0, 1.0);
    return part * part * (3 - 2 * part);
}

const VoxelStep* VoxelPlay::step(const VoxelTale& tale) const {
    return taken_ == 0 ? nullptr : &tale.steps[static_cast<std::size_t>(taken_ - 1)];
}

dvec3 VoxelPlay::position(const VoxelTale& tale) const {
    const VoxelStep* const now = step(tale);
    if (now == nullptr) return story().scene.from;
    // In the end exactly where the lesson says, not nearly there.
    if (share() >= 1) return now->moved_to;
    return now->moved_from + (now->moved_to - now->moved_from) * share();
}

dvec3 VoxelPlay::move_start(const VoxelTale& tale) const {
    if (taken_ == 0) return story().scene.from;
    auto first = static_cast<std::size_t>(taken_ - 1);
    while (first > 0 && tale.move_of[first - 1] == tale.move_of[first]) --first;
    return tale.steps[first].moved_from;
}

}  // namespace surefoot::playground
