// A mesh as it lies in memory, or in a file: plain arrays without a pointer in them. Built in memory or mapped, it is
// the same bytes, and whatever those bytes are, reading them through these functions stays within the arrays.
//
// The tree is eight wide. A node keeps the boxes of its children in 8 bits a side, on a grid of its own: an origin and
// a power of two for each axis, so that low = origin + q * scale has one rounding and is the same float on every
// machine. The boxes contain what is below them, exactly as decoded.
//
// A leaf is a block of 32-bit words that holds up to eight triangles with their own vertices, so that nothing else has
// to be fetched to test them:
//
//     1 word            count, vertex count (8 bits each), tile (16 bits)
//     3 * vertices      x of all vertices, then y, then z: floats, relative to the tile's origin
//     count words       bytes: the first corners of all triangles, the second ones, the third ones, then the edges
//     count words       the triangles' ids
//
// The edges of a triangle are two bits each (EdgeKind), of ab lowest.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include <surefoot/math.hpp>
#include <surefoot/query.hpp>

#include "query/reach.hpp"
#include "vec.hpp"

namespace surefoot::internal {

inline constexpr int tree_width = 8;
inline constexpr std::uint32_t leaf_bit = 0x80000000U;
inline constexpr std::uint32_t most_leaf_words = 1U << 29;  // a place in `places` keeps three bits for the slot
inline constexpr std::uint32_t leaf_padding =
    32;  // words after the last leaf, so that wide loads stay within the array

struct alignas(32) WideNode {
    float origin[3];
    std::uint8_t exponent[3];  ///< of the grid's step, as in a float: step = 2^(exponent - 127)
    std::uint8_t count;        ///< how many children there are [0, 8]
    std::uint8_t low[3][tree_width];
    std::uint8_t high[3][tree_width];
    std::uint32_t child[tree_width];  ///< a node behind this one, or leaf_bit and the first word of a leaf

    [[nodiscard]] float step(int axis) const noexcept {
        return std::bit_cast<float>(std::uint32_t{exponent[axis]} << 23);
    }
    [[nodiscard]] float decoded(int axis, std::uint8_t q) const noexcept {
        return origin[axis] + static_cast<float>(q) * step(axis);
    }
};

static_assert(sizeof(WideNode) == 96);

/// One leaf, checked to lie within the leaves.
struct LeafBlock {
    const std::uint32_t* words = nullptr;
    std::uint32_t count = 0;
    std::uint32_t vertices = 0;
    std::uint32_t tile = 0;

    [[nodiscard]] const float* axis(int i) const noexcept {
        return reinterpret_cast<const float*>(words + 1) + static_cast<std::size_t>(i) * vertices;
    }
    [[nodiscard]] const std::uint8_t* corner(int i) const noexcept {
        return reinterpret_cast<const std::uint8_t*>(words + 1 + 3 * std::size_t{vertices}) +
               static_cast<std::size_t>(i) * count;
    }
    [[nodiscard]] const std::uint8_t* edges() const noexcept { return corner(3); }
    [[nodiscard]] const std::uint32_t* ids() const noexcept { return words + 1 + 3 * std::size_t{vertices} + count; }

    /// Requires: `slot` < count.
    [[nodiscard]] vec3 vertex(int i, std::uint32_t slot) const noexcept {
        const std::uint32_t named = corner(i)[slot];
        const std::uint32_t index = named < vertices ? named : 0;  // only bytes that nobody wrote name another
        return {axis(0)[index], axis(1)[index], axis(2)[index]};
    }
};

/// How many words a leaf takes.
[[nodiscard]] constexpr std::uint32_t leaf_words(std::uint32_t count, std::uint32_t vertices) noexcept {
    return 1 + 3 * vertices + 2 * count;
}

struct MeshView {
    std::span<const WideNode> nodes;          ///< children behind their parents, the root first; none for no triangles
    std::span<const std::uint32_t> leaves;    ///< words, leaf_padding of them after the last leaf
    std::span<const std::uint32_t> places;    ///< by id: first word of the leaf * 8 + slot
    std::span<const std::uint32_t> surfaces;  ///< by id; none means 0 for all
    std::span<const dvec3> tiles;             ///< what a leaf's vertices are relative to; none means the origin for all
    std::span<const std::uint64_t> hidden;    ///< a bit an id; none means that all are shown
    Box3 bounds;                              ///< of all triangles
    std::uint64_t vertex_count = 0;           ///< of the input, for information

    [[nodiscard]] std::uint32_t triangle_count() const noexcept { return static_cast<std::uint32_t>(places.size()); }

    /// The leaf that begins at this word; an empty one if there is none.
    [[nodiscard]] LeafBlock leaf(std::uint32_t word) const noexcept {
        if (leaves.size() < leaf_padding || word >= leaves.size() - leaf_padding) return {};
        const std::uint32_t header = leaves[word];
        LeafBlock block{&leaves[word], header & 0xff, (header >> 8) & 0xff, header >> 16};
        const bool fits = block.count <= tree_width && block.vertices >= 1 && block.vertices <= 3 * tree_width &&
                          leaf_words(block.count, block.vertices) <= leaves.size() - leaf_padding - word;
        return fits ? block : LeafBlock{};
    }

    [[nodiscard]] Vec origin_of(std::uint32_t tile) const noexcept {
        return tile < tiles.size() ? to_vec(tiles[tile]) : Vec{};
    }

    /// Requires: `slot` < block.count.
    [[nodiscard]] Triangle triangle(const LeafBlock& block, std::uint32_t slot) const noexcept {
        const Vec origin = origin_of(block.tile);
        const auto corner = [&](int i) {
            const vec3 v = block.vertex(i, slot);
            return dvec3(double{v.x} + origin.x, double{v.y} + origin.y, double{v.z} + origin.z);
        };
        return {corner(0), corner(1), corner(2)};
    }

    /// All zeros for an id that is not there: a hit in a hostile file may name one.
    [[nodiscard]] Triangle triangle(std::uint32_t id) const noexcept {
        if (id >= places.size()) return {};
        const LeafBlock block = leaf(places[id] >> 3);
        const std::uint32_t slot = places[id] & 7;
        return slot < block.count ? triangle(block, slot) : Triangle{};
    }

    [[nodiscard]] std::uint32_t surface(std::uint32_t id) const noexcept {
        return id < surfaces.size() ? surfaces[id] : 0;
    }

    [[nodiscard]] bool is_hidden(std::uint32_t id) const noexcept {
        return id / 64 < hidden.size() && (hidden[id / 64] >> (id % 64) & 1) != 0;
    }

    /// Requires: `slot` < block.count.
    [[nodiscard]] SourceTriangle source_triangle(const LeafBlock& block, std::uint32_t slot) const noexcept {
        SourceTriangle result{.triangle = triangle(block, slot), .id = block.ids()[slot]};
        result.surface = surface(result.id);
        const std::uint8_t edges = block.edges()[slot];
        for (int i = 0; i < 3; ++i) result.edges[i] = static_cast<EdgeKind>(edges >> (2 * i) & 3);
        return result;
    }
};

}  // namespace surefoot::internal
