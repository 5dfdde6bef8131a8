/// The move of block worlds, one axis after the other, done wrong and right on one scene, taken apart into steps that
/// can be shown one at a time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <surefoot/math.hpp>
#include <surefoot/voxels.hpp>
#include <surefoot/voxels_move.hpp>

namespace surefoot::debugger {

/// Blocks, a box among them, and where it wants to go.
struct VoxelScene {
    std::vector<Cell> solid;
    VoxelWindow window;
    Box box;
    dvec3 from{0, 0, 0};
    dvec3 displacement{0, 0, 0};
    AxisOrder order = AxisOrder::xyz;  ///< for the right one

    [[nodiscard]] bool is_solid(std::int32_t x, std::int32_t y, std::int32_t z) const;
};

/// A floor, a wall with a corner, and a box that moves at that corner slantwise: each axis alone is free, both together
/// lead into the block.
[[nodiscard]] VoxelScene corner_scene();

enum class VoxelMethod : std::uint8_t {
    each_from_the_last,  ///< right: each axis begins where the one before it ended
    all_from_the_start,  ///< wrong: each axis is tried from START, and then all are taken together
};

struct VoxelStep {
    int axis = 0;                 ///< 0: x, 1: y, 2: z
    dvec3 tried_from{0, 0, 0};    ///< from where this axis was tried [m]
    dvec3 tried_to{0, 0, 0};      ///< how far it is free from there [m]
    dvec3 moved_from{0, 0, 0};    ///< where the box is shown before the step [m]
    dvec3 moved_to{0, 0, 0};      ///< and after it [m]
    std::vector<Cell> looked_at;  ///< the cells that were asked, in order
    std::optional<Cell> stopped_by;
    bool inside = false;  ///< the box overlaps a block after the step, whatever the method believes
    std::string text;     ///< what the method believes
};

struct VoxelLesson {
    VoxelMethod method = VoxelMethod::each_from_the_last;
    std::vector<VoxelStep> steps;  ///< one for each axis along which it moves
    BoxMove result;                ///< the library's own answer, whose position the last step has
    bool ends_inside = false;
    std::string conclusion;
};

/// Requires: the scene's window is one that `Voxels::over` takes.
[[nodiscard]] VoxelLesson voxel_lesson(const VoxelScene& scene, VoxelMethod method);

}  // namespace surefoot::debugger
