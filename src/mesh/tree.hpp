// A tree of boxes over triangles, binary, split at the median: the simple reference.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <surefoot/math.hpp>

#include "query/reach.hpp"
#include "vec.hpp"

namespace surefoot::internal {

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

/// The part of a motion, as times in [0, 1], during which something of this extent about its reference point meets a
/// box.
class BoxSweep {
public:
    BoxSweep(const Motion& motion, const Box3& extent) noexcept;

    /// When it enters, or anything above 1 if it does not. Never later than the truth.
    [[nodiscard]] double entry(const Box3& box) const noexcept;

private:
    Vec from_;
    Vec along_;
    Box3 extent_;
};

}  // namespace surefoot::internal
