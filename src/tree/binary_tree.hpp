// A binary tree of boxes over triangles, split where the surface area heuristic says. The wide tree is collapsed from
// it.
#pragma once

#include <cstdint>
#include <span>
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

struct BinaryNode {
    FloatBox box;
    std::uint32_t first = 0;  ///< its first place in `order`
    std::uint32_t count = 0;  ///< how many triangles are below it
    std::uint32_t left = 0;   ///< 0 for a leaf (the root is nobody's child)
    std::uint32_t right = 0;
};

struct BinaryTree {
    std::vector<BinaryNode> nodes;     ///< the root first, children behind their parents
    std::vector<std::uint32_t> order;  ///< triangles, leaf by leaf
};

/// At most this many splits by area below the root: behind it, halves.
inline constexpr int deepest_split = 64;

/// No tree is deeper: tiles are halved (16), then split, then halved (31).
inline constexpr int deepest_tree = deepest_split + 48;

/// The same tree whatever the number of threads [1, 64]. `tiles` says which tile each triangle is in, and is empty for
/// one tile; a leaf holds triangles of one.
/// Requires: at least one box, at most 2^31; one tile a box, or none.
[[nodiscard]] BinaryTree build_binary_tree(std::span<const FloatBox> boxes, std::span<const std::uint16_t> tiles,
                                           int threads);

}  // namespace surefoot::internal
