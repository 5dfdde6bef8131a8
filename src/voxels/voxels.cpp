#include <string>
#include <utility>

#include <surefoot/voxels.hpp>

#include "ieee_guard.hpp"
#include "limits.hpp"
#include "query/ask.hpp"
#include "voxels/blocks.hpp"
#include "voxels/finder.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

namespace {

constexpr std::uint32_t most_boxes = 64;

tl::unexpected<Error> refuse(ErrorCode code, std::string text) {
    return tl::unexpected(Error{code, std::move(text), {}, 0});
}

Expected<void> check(const VoxelWindow& window) {
    if (window.boxes_per_block < 1 || window.boxes_per_block > most_boxes) {
        return refuse(ErrorCode::invalid, "boxes_per_block is " + std::to_string(window.boxes_per_block) +
                                              ": a block may have 1 to 64 boxes");
    }
    double ids = BlockGrid::triangles_per_box * static_cast<double>(window.boxes_per_block);
    for (int axis = 0; axis < 3; ++axis) {
        const std::int32_t cells = component(window.cells, axis);
        const std::string name(1, "xyz"[axis]);
        if (cells < 1 || std::int64_t{component(window.first, axis)} + cells > INT32_MAX) {
            return refuse(ErrorCode::invalid, "a window of voxels needs at least one cell along " + name +
                                                  ", and the last one numbered below 2^31");
        }
        const GridLine line(component(window.origin, axis), component(window.size, axis), component(window.first, axis),
                            cells);
        if (!line.told_apart(largest_coordinate)) {
            return refuse(
                ErrorCode::invalid,
                "neighbouring cells would round to the same float along " + name +
                    ", or the window reaches beyond 1e9 m: bring the origin nearer, or make cells larger than "
                    "2^-22 of the largest coordinate, finite and above 0");
        }
        ids *= cells;
    }
    if (ids > 0x1p32) {
        return refuse(ErrorCode::limit,
                      "the triangles of this window cannot be numbered in 32 bits: 12 * "
                      "boxes_per_block for each cell; split it into several windows");
    }
    return {};
}

}  // namespace

Expected<Voxels> Voxels::over(const BlockAt& blocks, const VoxelWindow& window) {
    const IeeeGuard guard;
    if (auto usable = check(window); !usable) return tl::unexpected(std::move(usable.error()));
    return Voxels(blocks, window);
}

std::optional<Hit> Voxels::sweep(const Volume& volume, const Motion& motion,
                                 const QueryOptions& options) const noexcept {
    return ask_sweep(VoxelFinder(*this), volume, motion, options);
}

bool Voxels::sweep_any(const Volume& volume, const Motion& motion, const QueryOptions& options) const noexcept {
    return ask_sweep_any(VoxelFinder(*this), volume, motion, options);
}

std::optional<Hit> Voxels::ray(const Motion& motion, const QueryOptions& options) const noexcept {
    return ask_ray(VoxelFinder(*this), motion, options);
}

bool Voxels::ray_any(const Motion& motion, const QueryOptions& options) const noexcept {
    return ask_ray_any(VoxelFinder(*this), motion, options);
}

std::size_t Voxels::overlap(const Volume& volume, const dvec3& position, std::span<Overlap> found,
                            const QueryOptions& options) const noexcept {
    return ask_overlap(VoxelFinder(*this), volume, position, found, options);
}

std::optional<NearestPoint> Voxels::nearest(const dvec3& point, double farthest,
                                            const QueryOptions& options) const noexcept {
    return ask_nearest(VoxelFinder(*this), point, farthest, options);
}

std::size_t Voxels::gather(const Bounds& near, std::span<SourceTriangle> found,
                           const QueryOptions& options) const noexcept {
    return ask_gather(VoxelFinder(*this), near, found, options);
}

Bounds Voxels::bounds() const noexcept {
    const IeeeGuard guard;
    const Box3 box = BlockGrid(*this).box();
    return {to_dvec3(box.min), to_dvec3(box.max)};
}

Triangle Voxels::triangle(std::uint32_t id) const noexcept {
    const IeeeGuard guard;
    const BlockGrid grid(*this);
    const Cell place = grid.cell(id);
    const Block block = grid.block(place);
    const std::uint32_t number = grid.box_number(id);
    const BlockBox& box = number < block.count ? BlockGrid::usable(block.boxes[number]) : whole_block;
    return triangle_of(grid.placed(place, box), BlockFace::numbered(id / 2 % 6), id % 2);
}

std::uint32_t Voxels::surface(std::uint32_t id) const noexcept {
    const BlockGrid grid(*this);
    return grid.block(grid.cell(id)).surface;
}

Cell Voxels::cell(std::uint32_t id) const noexcept {
    return BlockGrid(*this).cell(id);
}

}  // namespace v0
}  // namespace surefoot
