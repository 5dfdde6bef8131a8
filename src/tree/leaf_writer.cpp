#include "tree/leaf_writer.hpp"

#include <algorithm>
#include <bit>
#include <cstring>
#include <hwy/cache_control.h>

namespace surefoot::internal {

namespace {

// The vertices of a leaf, each once.
class LeafVertices {
public:
    std::uint32_t add(const vec3& p) noexcept {
        const std::uint32_t x = std::bit_cast<std::uint32_t>(p.x);
        const std::uint32_t y = std::bit_cast<std::uint32_t>(p.y);
        const std::uint32_t z = std::bit_cast<std::uint32_t>(p.z);
        // Most vertices that are new are so at a glance: no other had their hash.
        const std::uint64_t mark = std::uint64_t{1} << (((x ^ y * 0x85EBCA6BU ^ z * 0xC2B2AE35U) * 0x9E3779B9U) >> 26);
        if ((marks_ & mark) != 0) {
            for (std::uint32_t i = 0; i < count; ++i) {
                if (axes[0][i] == x && axes[1][i] == y && axes[2][i] == z) return i;
            }
        }
        marks_ |= mark;
        axes[0][count] = x;
        axes[1][count] = y;
        axes[2][count] = z;
        return count++;
    }

    std::uint32_t axes[3][3 * tree_width];
    std::uint32_t count = 0;

private:
    std::uint64_t marks_ = 0;
};

}  // namespace

// Triangles lie anywhere in memory, so those that come next are fetched while others are copied.
void gather(std::span<const std::uint32_t> ids, const LeafInput& input, LeafTriangle* to) noexcept {
    constexpr std::size_t far = 24;
    constexpr std::size_t near = 12;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        if (i + far < ids.size()) hwy::Prefetch(&input.indices[3 * std::size_t{ids[i + far]}]);
        if (i + near < ids.size()) {
            const std::uint32_t* const next = &input.indices[3 * std::size_t{ids[i + near]}];
            for (int corner = 0; corner < 3; ++corner) hwy::Prefetch(&input.vertices[next[corner]]);
        }
        const std::uint32_t id = ids[i];
        to[i] = {{input.corner(id, 0), input.corner(id, 1), input.corner(id, 2)},
                 id,
                 input.tiles.empty() ? std::uint16_t{0} : input.tiles[id],
                 input.edges.empty() ? std::uint8_t{0} : input.edges[id]};
    }
}

std::uint32_t LeafWriter::add(std::span<const LeafTriangle> triangles) {
    const LeafTriangle* by_id[tree_width];
    std::uint32_t count = 0;
    for (const LeafTriangle& triangle : triangles) {
        std::uint32_t at = count++;
        for (; at > 0 && by_id[at - 1]->id > triangle.id; --at) by_id[at] = by_id[at - 1];
        by_id[at] = &triangle;
    }
    const auto word = static_cast<std::uint32_t>(tree_.leaves.size());
    LeafVertices vertices;
    std::uint8_t bytes[4 * tree_width];
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            bytes[i * count + slot] = static_cast<std::uint8_t>(vertices.add(by_id[slot]->corners[i]));
        }
        bytes[3 * count + slot] = by_id[slot]->edges;
    }
    const std::uint32_t size = leaf_words(count, vertices.count);
    if (word + std::size_t{size} > most_leaf_words) {
        tree_.too_large = true;
        return leaf_bit;
    }
    tree_.leaves.resize(word + std::size_t{size});
    std::uint32_t* to = tree_.leaves.data() + word;
    *to++ = count | vertices.count << 8 | std::uint32_t{by_id[0]->tile} << 16;
    for (const auto& axis : vertices.axes) to = std::copy_n(axis, vertices.count, to);
    std::memcpy(to, bytes, 4 * std::size_t{count});
    to += count;
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        *to++ = by_id[slot]->id;
        places_[by_id[slot]->id] = word << 3 | slot;
    }
    return leaf_bit | word;
}

}  // namespace surefoot::internal
