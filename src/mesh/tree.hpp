// A tree of boxes over triangles, binary, split at the median: the simple reference.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <surefoot/math.hpp>

#include "vec.hpp"

namespace surefoot::internal {

struct Box3 {
    Vec min;
    Vec max;

    void include(const Vec& p) noexcept {
        min = {smaller(min.x, p.x), smaller(min.y, p.y), smaller(min.z, p.z)};
        max = {larger(max.x, p.x), larger(max.y, p.y), larger(max.z, p.z)};
    }
    void include(const Box3& box) noexcept {
        include(box.min);
        include(box.max);
    }
};

struct TreeNode {
    Box3 box;
    std::uint32_t first = 0;  ///< a leaf: its first place in `order`; else: its first child, the second follows
    std::uint32_t count = 0;  ///< a leaf: how many triangles; else 0
};

struct Tree {
    std::vector<TreeNode> nodes;       ///< the root first; empty for no triangles
    std::vector<std::uint32_t> order;  ///< triangle ids, leaf by leaf

    static constexpr std::uint32_t leaf_size = 4;
    static constexpr int deepest = 64;  ///< halving 2^31 triangles takes 31 steps
};

[[nodiscard]] Tree build_tree(std::span<const Box3> boxes);

/// The part of a motion, as times in [0, 1], during which a point comes within `reach` of a box along each axis.
class BoxSweep {
public:
    BoxSweep(const Motion& motion, const Vec& reach) noexcept;

    /// When it enters, or anything above 1 if it does not. Never later than the truth.
    [[nodiscard]] double entry(const Box3& box) const noexcept;

private:
    Vec from_;
    Vec along_;
    Vec reach_;
};

}  // namespace surefoot::internal
