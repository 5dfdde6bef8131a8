/// Voxels: blocks on a grid, a triangle source of its own. Nothing is built and nothing is stored: your own function
/// says what each cell holds, and a query asks it about the cells on its way.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>

#include <surefoot/bounds.hpp>
#include <surefoot/error.hpp>
#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/overlap.hpp>
#include <surefoot/query.hpp>
#include <surefoot/shapes.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// A place in the grid.
struct Cell {
    std::int32_t x = 0;
    std::int32_t y = 0;
    std::int32_t z = 0;

    friend constexpr bool operator==(const Cell&, const Cell&) = default;
};

/// One box of a block, in shares of its cell; a slab is {{0, 0, 0}, {1, 0.5, 1}}. Anything but 0 <= min < max <= 1 is
/// read as the whole cell, so that a mistake blocks instead of opening a hole.
struct BlockBox {
    vec3 min{0, 0, 0};  ///< [0, 1]
    vec3 max{1, 1, 1};  ///< [0, 1, above min]
};

/// The box of a full block.
inline constexpr BlockBox whole_block{};

/// What a cell holds: nothing, a full block, or a block of several boxes.
struct Block {
    const BlockBox* boxes = nullptr;  ///< non-owning: must stay as they are during the query
    std::uint32_t count = 0;          ///< of boxes; more than the window's `boxes_per_block` are read as a full block
    std::uint32_t surface = 0;        ///< what it is made of, your own number

    [[nodiscard]] static constexpr Block empty() noexcept { return {}; }
    [[nodiscard]] static constexpr Block full(std::uint32_t surface = 0) noexcept { return {&whole_block, 1, surface}; }
    /// Stairs, slabs, posts: for example of a table `static constexpr BlockBox stairs[]`.
    [[nodiscard]] static constexpr Block of(std::span<const BlockBox> boxes, std::uint32_t surface = 0) noexcept {
        return {boxes.data(), static_cast<std::uint32_t>(boxes.size()), surface};
    }
};

static_assert(sizeof(Block) <= 16 && std::is_trivially_copyable_v<Block>);

/// What can say which blocks there are: any callable of a cell's x, y, z that answers `bool` (solid or not) or `Block`.
template <typename T>
concept SaysBlocks = requires(const T& callable, std::int32_t at) {
    requires std::same_as<decltype(callable(at, at, at)), bool> || std::same_as<decltype(callable(at, at, at)), Block>;
};

/// A view of your callable. Non-owning. It may not throw, and must answer the same throughout a query.
class BlockAt {
public:
    template <SaysBlocks Callable>
    constexpr BlockAt(const Callable& callable) noexcept
        : callable_(&callable), call_([](const void* target, std::int32_t x, std::int32_t y, std::int32_t z) -> Block {
              const auto answer = (*static_cast<const Callable*>(target))(x, y, z);
              if constexpr (std::same_as<decltype(answer), const Block>) {
                  return answer;
              } else {
                  return answer ? Block::full() : Block::empty();
              }
          }) {}

    [[nodiscard]] Block operator()(const Cell& cell) const { return call_(callable_, cell.x, cell.y, cell.z); }

private:
    const void* callable_;
    Block (*call_)(const void*, std::int32_t, std::int32_t, std::int32_t);
};

/// Which part of the grid there is, and where it lies. Nothing is asked about cells outside; they are empty.
struct VoxelWindow {
    Cell first{};                       ///< the lowest cell
    Cell cells{16, 16, 16};             ///< how many along each axis [each >= 1]
    dvec3 size{1, 1, 1};                ///< of a cell [m, > 0]
    dvec3 origin{0, 0, 0};              ///< the lowest corner of cell (0, 0, 0), in the window or not [m]
    std::uint32_t boxes_per_block = 1;  ///< the most boxes that a block may have [1, 64]
};

/// The triangles of blocks: for each box six faces of two triangles, fronts outwards.
///
/// Hidden faces are not there: a face is left out if and only if it lies in the side of its cell and one box of the
/// block beyond that side covers it wholly. Between two full blocks there is nothing to catch on, nor between two
/// slabs. That takes away only triangles that nobody can reach from outside: all of the solid's own surface is still
/// there, docs/sources.md says why. A query that starts inside the solid passes between blocks without meeting
/// anything.
///
/// A corner is exactly these floats: float(origin + size * (cell + share)), computed in doubles and rounded once. Ids
/// do not depend on what is where: triangle k (0, 1) of face f (0: -x, 1: +x, 2: -y, 3: +y, 4: -z, 5: +z) of box b of
/// the cell at (i, j, k') within the window is ((((j * cells.z + k') * cells.x + i) * boxes_per_block + b) * 6 + f) * 2
/// + k. They fit into 32 bits: a window of full blocks may have 357 million cells, which is 710 a side.
///
/// The queries are those of `Mesh`, and their answers are those of a mesh with the same triangles, bit for bit.
/// Non-owning and small: copy it freely; your blocks must outlive it. Blocks may change between two queries.
/// Threads: as safe as your callable. Allocates nothing.
class Voxels {
public:
    /// Fails with `invalid` when a number of the window is out of its range, a coordinate would lie beyond 1e9 m or two
    /// neighbouring sides of cells would round to the same float; with `limit` when ids need more than 32 bits.
    [[nodiscard]] static Expected<Voxels> over(const BlockAt& blocks, const VoxelWindow& window);

    /// See Mesh; ties go to the lowest triangle.
    [[nodiscard]] std::optional<Hit> sweep(const Volume& volume, const Motion& motion,
                                           const QueryOptions& options = {}) const noexcept;
    [[nodiscard]] bool sweep_any(const Volume& volume, const Motion& motion,
                                 const QueryOptions& options = {}) const noexcept;
    [[nodiscard]] std::optional<Hit> ray(const Motion& motion, const QueryOptions& options = {}) const noexcept;
    [[nodiscard]] bool ray_any(const Motion& motion, const QueryOptions& options = {}) const noexcept;
    std::size_t overlap(const Volume& volume, const dvec3& position, std::span<Overlap> found,
                        const QueryOptions& options = {}) const noexcept;
    [[nodiscard]] std::optional<NearestPoint> nearest(const dvec3& point, double farthest,
                                                      const QueryOptions& options = {}) const noexcept;
    /// As for Mesh, but the kinds of edges are not worked out: all are `open`.
    std::size_t gather(const Bounds& near, std::span<SourceTriangle> found,
                       const QueryOptions& options = {}) const noexcept;

    [[nodiscard]] const VoxelWindow& window() const noexcept { return window_; }
    [[nodiscard]] const BlockAt& blocks() const noexcept { return blocks_; }
    /// The box around the whole window.
    [[nodiscard]] Bounds bounds() const noexcept;
    /// Requires: an id from an answer, or any id of a cell in the window. A box that the block does not have is read as
    /// the whole cell.
    [[nodiscard]] Triangle triangle(std::uint32_t id) const noexcept;
    /// Requires: as for `triangle`. 0 where there is no block.
    [[nodiscard]] std::uint32_t surface(std::uint32_t id) const noexcept;
    /// Which cell a triangle belongs to. Requires: as for `triangle`.
    [[nodiscard]] Cell cell(std::uint32_t id) const noexcept;

private:
    Voxels(const BlockAt& blocks, const VoxelWindow& window) noexcept : blocks_(blocks), window_(window) {}

    BlockAt blocks_;
    VoxelWindow window_;
};

}  // namespace v0
}  // namespace surefoot
