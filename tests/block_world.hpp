// Random worlds of full and partial blocks, and their triangles made without the library's help.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include <surefoot/query.hpp>
#include <surefoot/voxels.hpp>

#include "rounded.hpp"
#include "splitmix.hpp"

namespace surefoot::tests {

inline constexpr BlockBox slab[] = {{{0, 0, 0}, {1, 0.5F, 1}}};
inline constexpr BlockBox stairs[] = {{{0, 0, 0}, {1, 0.5F, 1}}, {{0.5F, 0.5F, 0}, {1, 1, 1}}};
inline constexpr BlockBox post[] = {{{0.375F, 0, 0.375F}, {0.625F, 1, 0.625F}}};
inline constexpr BlockBox hatch[] = {{{0, 0.8125F, 0}, {1, 1, 1}}};
inline constexpr BlockBox odd[] = {{{0.1F, 0.2F, 0.3F}, {0.4F, 0.9F, 1}}};
inline constexpr std::array<std::span<const BlockBox>, 5> partial_blocks{slab, stairs, post, hatch, odd};

/// One box in space.
struct Solid {
    dvec3 min;
    dvec3 max;
    std::uint32_t first_id;
    std::uint32_t surface;
};

struct BlockWorld {
    VoxelWindow window;
    std::vector<Block> grid{};

    /// `full` and `partial`: how many of 16 cells are so.
    BlockWorld(const VoxelWindow& w, std::uint64_t seed, std::uint64_t full, std::uint64_t partial) : window(w) {
        SplitMix random(seed);
        grid.resize(static_cast<std::size_t>(w.cells.x * w.cells.y * w.cells.z));
        for (Block& block : grid) {
            const std::uint64_t kind = random.next() % 16;
            const auto surface = static_cast<std::uint32_t>(random.next() % 5);
            if (kind < full) block = Block::full(surface);
            if (kind >= full && kind < full + partial) {
                block = Block::of(partial_blocks[random.next() % partial_blocks.size()], surface);
            }
        }
    }

    Block operator()(std::int32_t x, std::int32_t y, std::int32_t z) const {
        const std::int32_t i = x - window.first.x;
        const std::int32_t j = y - window.first.y;
        const std::int32_t k = z - window.first.z;
        const bool inside =
            i >= 0 && j >= 0 && k >= 0 && i < window.cells.x && j < window.cells.y && k < window.cells.z;
        EXPECT_TRUE(inside) << "asked about a cell outside of the window";
        return inside ? grid[index(i, j, k)] : Block::empty();
    }

    [[nodiscard]] std::size_t index(std::int32_t i, std::int32_t j, std::int32_t k) const {
        return static_cast<std::size_t>((j * window.cells.z + k) * window.cells.x + i);
    }

    template <typename Look>  // look(i, j, k, box, number of the box)
    void for_each_box(const Look& look) const {
        for (std::int32_t j = 0; j < window.cells.y; ++j) {
            for (std::int32_t k = 0; k < window.cells.z; ++k) {
                for (std::int32_t i = 0; i < window.cells.x; ++i) {
                    const Block& block = grid[index(i, j, k)];
                    for (std::uint32_t b = 0; b < block.count; ++b) look(i, j, k, block.boxes[b], b);
                }
            }
        }
    }

    [[nodiscard]] dvec3 place(std::int32_t i, std::int32_t j, std::int32_t k, const vec3& share) const {
        const auto at = [](double origin, double size, double cell, double part) {
            return internal::rounded_to_float(origin + size * (cell + part));
        };
        return {at(window.origin.x, window.size.x, window.first.x + i, share.x),
                at(window.origin.y, window.size.y, window.first.y + j, share.y),
                at(window.origin.z, window.size.z, window.first.z + k, share.z)};
    }

    [[nodiscard]] std::vector<Solid> solids() const {
        std::vector<Solid> all;
        for_each_box([&](std::int32_t i, std::int32_t j, std::int32_t k, const BlockBox& box, std::uint32_t b) {
            const std::size_t cell = index(i, j, k);
            all.push_back({place(i, j, k, box.min), place(i, j, k, box.max),
                           static_cast<std::uint32_t>((cell * window.boxes_per_block + b) * 12), grid[cell].surface});
        });
        return all;
    }

    /// Does one box of the cell beyond cover this face, which lies in the side of its own cell?
    [[nodiscard]] bool covered(const std::array<std::int32_t, 3>& cell, const BlockBox& box, int axis,
                               bool high) const {
        if (high ? box.max[axis] != 1.0F : box.min[axis] != 0.0F) return false;
        std::array<std::int32_t, 3> beyond = cell;
        beyond[static_cast<std::size_t>(axis)] += high ? 1 : -1;
        const std::array<std::int32_t, 3> end{window.cells.x, window.cells.y, window.cells.z};
        for (std::size_t a = 0; a < 3; ++a) {
            if (beyond[a] < 0 || beyond[a] >= end[a]) return false;
        }
        const Block& other = grid[index(beyond[0], beyond[1], beyond[2])];
        for (std::uint32_t b = 0; b < other.count; ++b) {
            BlockBox cover = other.boxes[b];
            if (high ? cover.min[axis] != 0.0F : cover.max[axis] != 1.0F) continue;
            cover.min[axis] = box.min[axis];
            cover.max[axis] = box.max[axis];
            bool all = true;
            for (int a = 0; a < 3; ++a) all = all && cover.min[a] <= box.min[a] && cover.max[a] >= box.max[a];
            if (all) return true;
        }
        return false;
    }

    /// In the order of ids.
    [[nodiscard]] std::vector<SourceTriangle> triangles(bool hidden_too) const {
        std::vector<SourceTriangle> all;
        for_each_box([&](std::int32_t i, std::int32_t j, std::int32_t k, const BlockBox& box, std::uint32_t b) {
            const std::size_t cell = index(i, j, k);
            for (int face = 0; face < 6; ++face) {
                const int axis = face / 2;
                const bool high = face % 2 == 1;
                if (!hidden_too && covered({i, j, k}, box, axis, high)) continue;
                const int u = (axis + 1) % 3;
                const int v = (axis + 2) % 3;
                const auto corner = [&](bool at_u, bool at_v) {
                    vec3 share = high ? box.max : box.min;
                    share[u] = at_u ? box.max[u] : box.min[u];
                    share[v] = at_v ? box.max[v] : box.min[v];
                    return place(i, j, k, share);
                };
                const dvec3 a = corner(false, false);
                const dvec3 c = corner(true, true);
                const dvec3 at_u = corner(true, false);
                const dvec3 at_v = corner(false, true);
                const auto id = static_cast<std::uint32_t>((cell * window.boxes_per_block + b) * 12) +
                                static_cast<std::uint32_t>(2 * face);
                const Triangle first = high ? Triangle{a, at_u, c} : Triangle{a, c, at_u};
                const Triangle second = high ? Triangle{a, c, at_v} : Triangle{a, at_v, c};
                all.push_back({first, id, grid[cell].surface});
                all.push_back({second, id + 1, grid[cell].surface});
            }
        });
        return all;
    }
};

}  // namespace surefoot::tests
