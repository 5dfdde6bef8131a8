// By dynamic programming over the surface area heuristic: Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on
// GPUs Through Compressed Wide BVHs" (2017), section 3.
#include "tree/plan.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "parallel.hpp"

namespace surefoot::internal {

namespace {

// What it costs to look into a node, into a leaf, and at one of its triangles.
constexpr float node_cost = 1.0F;
constexpr float leaf_cost = 1.0F;
constexpr float triangle_cost = 0.01F;

class Planner {
public:
    Planner(const BinaryTree& binary, const LeafInput& input)
        : binary_(binary), input_(input), plans_(std::make_unique_for_overwrite<Plan[]>(binary.room())) {}

    std::unique_ptr<Plan[]> run(int threads) {
        in_parallel(binary_.parts.size(), threads, [&](std::size_t i) { plan<true>(binary_.parts[i]); });
        plan<false>(0);
        return std::move(plans_);
    }

private:
    // Everything below a node, then the node: of a part, or of what is above the parts.
    template <bool in_part>
    void plan(std::uint32_t n) {
        const BinaryNode& node = binary_.nodes[n];
        if (!in_part && node.count <= binary_.part_size) return;
        if (node.left != 0) {
            plan<in_part>(node.left);
            plan<in_part>(node.right());
        }
        plan_node(n);
    }

    void plan_node(std::uint32_t n) {
        const BinaryNode& node = binary_.nodes[n];
        Plan& plan = plans_[n];
        const float area = node.box.area();
        const float as_leaf = node.count <= tree_width && is_one_tile(node)
                                  ? area * (leaf_cost + triangle_cost * static_cast<float>(node.count))
                                  : std::numeric_limits<float>::infinity();
        plan.left[0] = 0;
        if (node.left == 0) {
            plan.cost[0] = as_leaf;
            plan.left_of_node = 0;
            plan.most = 1;
            return;
        }
        const Plan& left = plans_[node.left];
        const Plan& right = plans_[node.right()];
        plan.most = static_cast<std::uint8_t>(std::min<int>(left.most + right.most, tree_width));
        for (unsigned roots = 2; roots <= plan.most; ++roots) {
            float least = std::numeric_limits<float>::infinity();
            unsigned most_left = 1;
            const unsigned last = std::min<unsigned>(left.most, roots - 1);
            for (unsigned k = roots > right.most ? roots - right.most : 1; k <= last; ++k) {
                const float cost = left.cost[k - 1] + right.cost[roots - k - 1];
                if (cost < least) {
                    least = cost;
                    most_left = k;
                }
            }
            plan.cost[roots - 1] = least;
            plan.left[roots - 1] = static_cast<std::uint8_t>(most_left);
        }
        plan.left_of_node = plan.left[plan.most - 1];
        const float as_node = area * node_cost + plan.cost[plan.most - 1];
        if (as_leaf <= as_node) plan.left_of_node = 0;
        plan.cost[0] = std::min(as_leaf, as_node);
        for (unsigned roots = 2; roots <= plan.most; ++roots) {
            if (plan.cost[roots - 2] <= plan.cost[roots - 1]) {
                plan.cost[roots - 1] = plan.cost[roots - 2];
                plan.left[roots - 1] = 0;
            }
        }
    }

    [[nodiscard]] bool is_one_tile(const BinaryNode& node) const {
        if (input_.tiles.empty()) return true;
        for (std::uint32_t i = 1; i < node.count; ++i) {
            if (input_.tiles[binary_.order[node.first + i]] != input_.tiles[binary_.order[node.first]]) return false;
        }
        return true;
    }

    const BinaryTree& binary_;
    const LeafInput& input_;
    std::unique_ptr<Plan[]> plans_;
};

}  // namespace

std::unique_ptr<Plan[]> make_plans(const BinaryTree& binary, const LeafInput& input, int threads) {
    return Planner(binary, input).run(threads);
}

}  // namespace surefoot::internal
