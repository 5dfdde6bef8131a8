// The library is asked for one axis at a time, which is what it does itself: a displacement along one axis moves
// nothing else. A listener between it and the blocks hears which cells it asks about.
#include "debugger/voxel_lesson.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "debugger/equation.hpp"

namespace surefoot::debugger {

namespace {

constexpr const char* axis_names[] = {"x", "y", "z"};

std::array<int, 3> axes_of(AxisOrder order) {
    static constexpr std::array<int, 3> all[] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    return all[static_cast<std::size_t>(order)];
}

struct Listener {
    const VoxelScene& scene;
    std::vector<Cell>& heard;

    bool operator()(std::int32_t x, std::int32_t y, std::int32_t z) const {
        heard.push_back({x, y, z});
        return scene.is_solid(x, y, z);
    }
};

struct AxisTry {
    dvec3 to{0, 0, 0};
    std::optional<Cell> stopped_by;
    std::vector<Cell> looked_at;
};

AxisTry try_axis(const VoxelScene& scene, const dvec3& from, int axis) {
    AxisTry tried;
    const Listener listener{scene, tried.looked_at};
    const auto voxels = Voxels::over(listener, scene.window);
    dvec3 way(0, 0, 0);
    // Every move ends with the question whether it began inside of something. It is no part of the axis.
    const bool inside = move_axis_by_axis(*voxels, scene.box, from, way).started_inside;
    static_cast<void>(inside);
    const std::size_t asked_in_the_end = tried.looked_at.size();
    tried.looked_at.clear();
    way[axis] = scene.displacement[axis];
    const BoxMove move = move_axis_by_axis(*voxels, scene.box, from, way);
    tried.looked_at.resize(tried.looked_at.size() - asked_in_the_end);
    tried.to = move.position;
    const AxisStop& stop = axis == 0 ? move.x : (axis == 1 ? move.y : move.z);
    if (stop.blocked) tried.stopped_by = voxels->cell(stop.triangle);
    return tried;
}

bool is_inside(const VoxelScene& scene, const dvec3& position) {
    const auto solid = [&](std::int32_t x, std::int32_t y, std::int32_t z) { return scene.is_solid(x, y, z); };
    const auto voxels = Voxels::over(solid, scene.window);
    return move_axis_by_axis(*voxels, scene.box, position, {0, 0, 0}).started_inside;
}

BoxMove whole_move(const VoxelScene& scene, VoxelMethod method) {
    const auto solid = [&](std::int32_t x, std::int32_t y, std::int32_t z) { return scene.is_solid(x, y, z); };
    const auto voxels = Voxels::over(solid, scene.window);
    if (method == VoxelMethod::all_from_the_start)
        return incorrect_move_axes_together(*voxels, scene.box, scene.from, scene.displacement);
    return move_axis_by_axis(*voxels, scene.box, scene.from, scene.displacement, scene.order);
}

std::string words_for(const VoxelStep& step, VoxelMethod method) {
    const char* name = axis_names[step.axis];
    const std::string from = method == VoxelMethod::all_from_the_start ? "From START" : "From here";
    const std::string found = step.stopped_by
                                  ? fmt::format("{} along {}: stopped at {} = {} by the block ({}, {}, {}).", from,
                                                name, name, short_text(step.tried_to[step.axis]), step.stopped_by->x,
                                                step.stopped_by->y, step.stopped_by->z)
                                  : fmt::format("{} along {}: free as far as {} = {}.", from, name, name,
                                                short_text(step.tried_to[step.axis]));
    if (method == VoxelMethod::each_from_the_last) return found + " It goes there, and the next axis begins there.";
    return found + (step.inside ? " It believes that this holds wherever the other axes have taken it. It does not."
                                : " It believes that this holds wherever the other axes take it.");
}

}  // namespace

bool VoxelScene::is_solid(std::int32_t x, std::int32_t y, std::int32_t z) const {
    return std::find(solid.begin(), solid.end(), Cell{x, y, z}) != solid.end();
}

VoxelScene corner_scene() {
    VoxelScene scene;
    scene.window = {.first = {0, 0, 0}, .cells = {6, 3, 6}};
    for (std::int32_t x = 0; x < 6; ++x)
        for (std::int32_t z = 0; z < 6; ++z) scene.solid.push_back({x, 0, z});
    for (std::int32_t y = 1; y < 3; ++y)
        for (std::int32_t x = 3; x < 6; ++x) scene.solid.push_back({x, y, 3});
    scene.box = {.half_extents = {0.25, 0.75, 0.25}};
    scene.from = {2.5, 1.75, 2.5};
    scene.displacement = {0.9, 0, 0.9};
    return scene;
}

VoxelLesson voxel_lesson(const VoxelScene& scene, VoxelMethod method) {
    VoxelLesson lesson;
    lesson.method = method;
    lesson.result = whole_move(scene, method);
    dvec3 at = scene.from;
    const bool right = method == VoxelMethod::each_from_the_last;
    for (const int axis : axes_of(right ? scene.order : AxisOrder::xyz)) {
        if (scene.displacement[axis] == 0) continue;
        VoxelStep step;
        step.axis = axis;
        step.tried_from = right ? at : scene.from;
        AxisTry tried = try_axis(scene, step.tried_from, axis);
        step.tried_to = tried.to;
        step.moved_from = at;
        at[axis] = tried.to[axis];
        step.moved_to = at;
        step.looked_at = std::move(tried.looked_at);
        step.stopped_by = tried.stopped_by;
        step.inside = is_inside(scene, at);
        step.text = words_for(step, method);
        lesson.steps.push_back(std::move(step));
    }
    lesson.ends_inside = is_inside(scene, at);
    lesson.conclusion = lesson.ends_inside
                            ? "It stands inside a block that none of its questions was about; and what it stands in "
                              "does not hold it, so the next move goes on through."
                            : "It touches no block from inside, and slides along the one that stopped it.";
    return lesson;
}

}  // namespace surefoot::debugger
