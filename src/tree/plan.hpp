// Which nodes of the binary tree become wide nodes, and which leaves.
#pragma once

#include <cstdint>
#include <memory>

#include "tree/wide_tree.hpp"

namespace surefoot::internal {

/// The cheapest way to stand for a subtree with at most i roots, i = 1 ... most.
struct Plan {
    float cost[tree_width];
    std::uint8_t left[tree_width];  ///< how many of them in the left half; 0: one root less is as good
    std::uint8_t left_of_node;      ///< as a wide node of its own: how many of its eight; 0: better a leaf
    std::uint8_t most;              ///< how many of its nodes can be roots at once [1, 8]
};

/// One for each node of the tree, in its place; the same whatever the number of threads [1, 64].
[[nodiscard]] std::unique_ptr<Plan[]> make_plans(const BinaryTree& binary, const LeafInput& input, int threads);

}  // namespace surefoot::internal
