// A binary tree of boxes over triangles, split where the surface area heuristic says. The wide tree is collapsed from
// it.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <vector>

namespace surefoot::internal {

/// In floats, as the vertices are: exact.
struct FloatBox {
    float min[3];
    float max[3];

    void include(const FloatBox& box) noexcept {
        for (int i = 0; i < 3; ++i) {
            min[i] = box.min[i] < min[i] ? box.min[i] : min[i];
            max[i] = max[i] < box.max[i] ? box.max[i] : max[i];
        }
    }
    /// Half of it, which is as good for comparing.
    [[nodiscard]] float area() const noexcept {
        const float x = max[0] - min[0];
        const float y = max[1] - min[1];
        const float z = max[2] - min[2];
        return x * y + y * z + z * x;
    }
};

/// A triangle's box and what it is called, as two vectors of four floats.
struct alignas(16) TreeItem {
    float min[4];  ///< and the bits of its id
    float max[4];  ///< and its tile, as a number

    static TreeItem of(const FloatBox& box, std::uint32_t id, std::uint16_t tile) noexcept {
        // Adding 0 makes 0 of -0: which of the two a minimum is depends on the machine.
        return {{box.min[0] + 0.0F, box.min[1] + 0.0F, box.min[2] + 0.0F, std::bit_cast<float>(id)},
                {box.max[0] + 0.0F, box.max[1] + 0.0F, box.max[2] + 0.0F, static_cast<float>(tile)}};
    }
    [[nodiscard]] std::uint32_t id() const noexcept { return std::bit_cast<std::uint32_t>(min[3]); }
};

struct BinaryNode {
    FloatBox box;
    std::uint32_t first;  ///< its first place in `order`
    std::uint32_t count;  ///< how many triangles are below it
    std::uint32_t left;   ///< 0 for a leaf (the root is nobody's child); the right child is the next one

    [[nodiscard]] std::uint32_t right() const noexcept { return left + 1; }
};

struct BinaryTree {
    std::unique_ptr<BinaryNode[]> nodes;  ///< the root first; with gaps
    std::vector<std::uint32_t> order;     ///< triangles, leaf by leaf
    std::vector<std::uint32_t> parts;     ///< the roots of disjoint subtrees that hold all triangles, by their place
    std::uint32_t part_size = 0;          ///< nodes of no more triangles are in a part, and no others

    /// How many nodes there is room for.
    [[nodiscard]] std::size_t room() const noexcept { return 2 * order.size(); }
};

/// At most this many splits by area below the root: behind it, halves.
inline constexpr int deepest_split = 64;

/// No tree is deeper: tiles are halved (16), then split, then halved (31).
inline constexpr int deepest_tree = deepest_split + 48;

/// The same tree whatever the number of threads [1, 64]; a leaf holds triangles of one tile.
/// Requires: at least one item, at most 2^31.
[[nodiscard]] BinaryTree build_binary_tree(std::vector<TreeItem>&& items, int threads);

}  // namespace surefoot::internal
