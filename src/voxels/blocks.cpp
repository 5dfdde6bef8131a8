#include "voxels/blocks.hpp"

namespace surefoot::internal {

BlockGrid::BlockGrid(const Voxels& voxels) noexcept
    : blocks_(voxels.blocks()), boxes_per_block_(voxels.window().boxes_per_block) {
    const VoxelWindow& window = voxels.window();
    for (int axis = 0; axis < 3; ++axis) {
        lines_[axis] = {component(window.origin, axis), component(window.size, axis), component(window.first, axis),
                        component(window.cells, axis)};
    }
}

Box3 BlockGrid::box() const noexcept {
    return {{lines_[0].at(lines_[0].first()), lines_[1].at(lines_[1].first()), lines_[2].at(lines_[2].first())},
            {lines_[0].at(lines_[0].end()), lines_[1].at(lines_[1].end()), lines_[2].at(lines_[2].end())}};
}

const BlockBox& BlockGrid::usable(const BlockBox& box) noexcept {
    const auto fits = [](float min, float max) { return 0 <= min && min < max && max <= 1; };
    const bool all = fits(box.min.x, box.max.x) && fits(box.min.y, box.max.y) && fits(box.min.z, box.max.z);
    return all ? box : whole_block;
}

bool BlockGrid::is_hidden(const Cell& cell, const BlockBox& box, const BlockFace& face) const noexcept {
    const int axis = face.axis;
    if (face.high ? component(box.max, axis) != 1 : component(box.min, axis) != 0) return false;
    const std::int32_t step = face.high ? 1 : -1;
    // Overflow is no matter: a cell at the end of all cells is at the end of its window.
    if (!lines_[axis].holds(std::int64_t{component(cell, axis)} + step)) return false;
    Cell beyond = cell;
    (axis == 0 ? beyond.x : (axis == 1 ? beyond.y : beyond.z)) += step;
    const Block other = block(beyond);
    const int across[2] = {(axis + 1) % 3, (axis + 2) % 3};
    for (std::uint32_t i = 0; i < other.count; ++i) {
        const BlockBox& cover = usable(other.boxes[i]);
        if (face.high ? component(cover.min, axis) != 0 : component(cover.max, axis) != 1) continue;
        bool covers = true;
        for (const int a : across) {
            covers = covers && component(cover.min, a) <= component(box.min, a) &&
                     component(cover.max, a) >= component(box.max, a);
        }
        if (covers) return true;
    }
    return false;
}

Cell BlockGrid::cell(std::uint32_t id) const noexcept {
    const std::int64_t index = id / triangles_per_box / boxes_per_block_;
    const std::int64_t layer = index / lines_[0].count();
    return {static_cast<std::int32_t>(lines_[0].first() + index % lines_[0].count()),
            static_cast<std::int32_t>(lines_[1].first() + layer / lines_[2].count()),
            static_cast<std::int32_t>(lines_[2].first() + layer % lines_[2].count())};
}

Box3 face_of(const Box3& box, const BlockFace& face) noexcept {
    Box3 flat = box;
    double Vec::*const axes[3] = {&Vec::x, &Vec::y, &Vec::z};
    double Vec::*const axis = axes[face.axis];
    if (face.high) {
        flat.min.*axis = box.max.*axis;
    } else {
        flat.max.*axis = box.min.*axis;
    }
    return flat;
}

Triangle triangle_of(const Box3& box, const BlockFace& face, std::uint32_t number) noexcept {
    double Vec::*const axes[3] = {&Vec::x, &Vec::y, &Vec::z};
    double Vec::*const right = axes[(face.axis + 1) % 3];
    double Vec::*const up = axes[(face.axis + 2) % 3];
    const Box3 flat = face_of(box, face);
    // The axes follow each other in a circle, so a turn from `right` to `up` is counter-clockwise from the high side.
    const auto corner = [&](bool at_right, bool at_up) {
        Vec place = flat.min;
        place.*right = (at_right ? flat.max : flat.min).*right;
        place.*up = (at_up ? flat.max : flat.min).*up;
        return to_dvec3(place);
    };
    const dvec3 first = corner(false, false);
    const dvec3 last = corner(true, true);
    const dvec3 side = corner(number == 0, number != 0);
    const bool side_first = (number == 0) == face.high;
    if (side_first) return {first, side, last};
    return {first, last, side};
}

}  // namespace surefoot::internal
