// Which nodes of the binary tree become wide nodes is decided by dynamic programming over the surface area heuristic:
// Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs" (2017), section 3.
#include "tree/wide_tree.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace surefoot::internal {

namespace {

// What it costs to look into a node, into a leaf, and at one of its triangles.
constexpr float node_cost = 1.0F;
constexpr float leaf_cost = 1.0F;
constexpr float triangle_cost = 0.03F;

// The cheapest way to stand for a subtree with at most i roots, i = 1 ... 8.
struct Plan {
    std::array<float, tree_width> cost;
    std::array<std::uint8_t, tree_width> left;  ///< how many of them in the left half; 0: one root less is as good
    std::uint8_t left_of_node = 0;              ///< as a wide node of its own: how many of its eight; 0: better a leaf
};

bool is_one_tile(const BinaryTree& binary, const BinaryNode& node, const LeafInput& input) {
    if (input.tiles.empty()) return true;
    for (std::uint32_t i = 1; i < node.count; ++i) {
        if (input.tiles[binary.order[node.first + i]] != input.tiles[binary.order[node.first]]) return false;
    }
    return true;
}

std::vector<Plan> make_plans(const BinaryTree& binary, const LeafInput& input) {
    std::vector<Plan> plans(binary.nodes.size());
    for (std::size_t n = plans.size(); n-- > 0;) {
        const BinaryNode& node = binary.nodes[n];
        Plan& plan = plans[n];
        const float area = node.box.area();
        const float as_leaf = node.count <= tree_width && is_one_tile(binary, node, input)
                                  ? area * (leaf_cost + triangle_cost * static_cast<float>(node.count))
                                  : std::numeric_limits<float>::infinity();
        if (node.left == 0) {
            plan.cost.fill(as_leaf);
            plan.left.fill(0);
            continue;
        }
        const auto& left = plans[node.left].cost;
        const auto& right = plans[node.right].cost;
        const auto share = [&](std::size_t roots, std::uint8_t& most_left) {
            float least = std::numeric_limits<float>::infinity();
            most_left = 1;
            for (std::size_t k = 1; k < roots; ++k) {
                const float cost = left[k - 1] + right[roots - k - 1];
                if (cost < least) {
                    least = cost;
                    most_left = static_cast<std::uint8_t>(k);
                }
            }
            return least;
        };
        const float as_node = area * node_cost + share(tree_width, plan.left_of_node);
        plan.cost[0] = std::min(as_leaf, as_node);
        plan.left[0] = 0;
        if (as_leaf <= as_node) plan.left_of_node = 0;
        for (std::size_t roots = 2; roots <= tree_width; ++roots) {
            plan.cost[roots - 1] = share(roots, plan.left[roots - 1]);
            if (plan.cost[roots - 2] <= plan.cost[roots - 1]) {
                plan.cost[roots - 1] = plan.cost[roots - 2];
                plan.left[roots - 1] = 0;
            }
        }
    }
    return plans;
}

// Writes leaf blocks one behind the other.
class LeafWriter {
public:
    LeafWriter(const LeafInput& input, WideTree& tree) : input_(input), tree_(tree) {}

    // Returns what a parent keeps: leaf_bit and the first word.
    std::uint32_t add(std::span<std::uint32_t> ids) {
        std::sort(ids.begin(), ids.end());
        const auto word = static_cast<std::uint32_t>(tree_.leaves.size());
        vec3 vertices[3 * tree_width];
        std::uint8_t corners[3][tree_width];
        std::uint32_t vertex_count = 0;
        for (std::uint32_t slot = 0; slot < ids.size(); ++slot) {
            for (std::uint32_t i = 0; i < 3; ++i) {
                const vec3 p = input_.corner(ids[slot], i);
                std::uint32_t index = 0;
                while (index < vertex_count && std::memcmp(&vertices[index], &p, sizeof p) != 0) ++index;
                if (index == vertex_count) vertices[vertex_count++] = p;
                corners[i][slot] = static_cast<std::uint8_t>(index);
            }
        }
        const auto count = static_cast<std::uint32_t>(ids.size());
        if (word + std::size_t{leaf_words(count, vertex_count)} > most_leaf_words) {
            tree_.too_large = true;
            return leaf_bit;
        }
        const std::uint32_t tile = input_.tiles.empty() ? 0U : input_.tiles[ids[0]];
        tree_.leaves.push_back(count | vertex_count << 8 | tile << 16);
        for (int axis = 0; axis < 3; ++axis) {
            for (std::uint32_t i = 0; i < vertex_count; ++i) {
                tree_.leaves.push_back(std::bit_cast<std::uint32_t>(vertices[i][axis]));
            }
        }
        std::uint8_t bytes[4 * tree_width] = {};
        for (std::uint32_t slot = 0; slot < count; ++slot) {
            for (std::uint32_t i = 0; i < 3; ++i) bytes[i * count + slot] = corners[i][slot];
            bytes[3 * count + slot] = input_.edges.empty() ? std::uint8_t{0} : input_.edges[ids[slot]];
            tree_.places[ids[slot]] = word << 3 | slot;
        }
        for (std::uint32_t i = 0; i < count; ++i) {
            std::uint32_t four = 0;
            std::memcpy(&four, bytes + 4 * i, 4);
            tree_.leaves.push_back(four);
        }
        tree_.leaves.insert(tree_.leaves.end(), ids.begin(), ids.end());
        return leaf_bit | word;
    }

private:
    const LeafInput& input_;
    WideTree& tree_;
};

// Puts the children's boxes on the node's grid, outwards.
void quantise(WideNode& node, std::span<const FloatBox> boxes) {
    FloatBox whole = boxes[0];
    for (const FloatBox& box : boxes) whole.include(box);
    for (int axis = 0; axis < 3; ++axis) {
        node.origin[axis] = whole.min[axis];
        const float extent = whole.max[axis] - whole.min[axis];
        const std::uint32_t bits = std::bit_cast<std::uint32_t>(extent / 255.0F) >> 23;
        // Begins at or below what is needed, and grows until every box fits; at 2^127 anything does.
        for (node.exponent[axis] = static_cast<std::uint8_t>(std::max(bits, 1U)); node.exponent[axis] < 254;
             ++node.exponent[axis]) {
            const float step = node.step(axis);
            bool fits = true;
            for (std::size_t i = 0; i < boxes.size() && fits; ++i) {
                float low = (boxes[i].min[axis] - node.origin[axis]) / step;
                float high = (boxes[i].max[axis] - node.origin[axis]) / step;
                int q_low = static_cast<int>(std::min(low, 255.0F));
                int q_high = static_cast<int>(std::min(high, 255.0F));
                while (q_low > 0 && node.decoded(axis, static_cast<std::uint8_t>(q_low)) > boxes[i].min[axis]) --q_low;
                while (q_high < 255 && node.decoded(axis, static_cast<std::uint8_t>(q_high)) < boxes[i].max[axis]) {
                    ++q_high;
                }
                node.low[axis][i] = static_cast<std::uint8_t>(q_low);
                node.high[axis][i] = static_cast<std::uint8_t>(q_high);
                fits = node.decoded(axis, node.low[axis][i]) <= boxes[i].min[axis] &&
                       node.decoded(axis, node.high[axis][i]) >= boxes[i].max[axis];
            }
            if (fits) break;
        }
    }
}

class Collapser {
public:
    Collapser(const BinaryTree& binary, const LeafInput& input, WideTree& tree)
        : binary_(binary), order_(binary.order), plans_(make_plans(binary, input)), leaves_(input, tree), tree_(tree) {}

    void run() {
        tree_.nodes.resize(1);
        fill(0, 0);
    }

private:
    struct Children {
        std::uint32_t node[tree_width];
        std::uint32_t count = 0;
    };

    void fill(std::uint32_t wide, std::uint32_t n) {
        Children children;
        const BinaryNode& node = binary_.nodes[n];
        if (const std::uint8_t left = plans_[n].left_of_node; left != 0) {
            collect(node.left, left, children);
            collect(node.right, static_cast<std::uint8_t>(tree_width - left), children);
        } else {
            children.node[children.count++] = n;  // a root that is one leaf
        }
        WideNode result{};
        result.count = static_cast<std::uint8_t>(children.count);
        FloatBox boxes[tree_width];
        for (std::uint32_t i = 0; i < children.count; ++i) boxes[i] = binary_.nodes[children.node[i]].box;
        quantise(result, {boxes, children.count});
        // First all children of this node, then what is below them: siblings lie together.
        std::uint32_t inner[tree_width];
        std::uint32_t inner_count = 0;
        for (std::uint32_t i = 0; i < children.count; ++i) {
            const BinaryNode& child = binary_.nodes[children.node[i]];
            if (plans_[children.node[i]].left_of_node == 0) {
                result.child[i] = leaves_.add({&order_[child.first], child.count});
            } else {
                result.child[i] = static_cast<std::uint32_t>(tree_.nodes.size() + inner_count);
                inner[inner_count++] = i;
            }
        }
        const auto first = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes.resize(first + inner_count);
        tree_.nodes[wide] = result;
        for (std::uint32_t i = 0; i < inner_count; ++i) fill(first + i, children.node[inner[i]]);
    }

    void collect(std::uint32_t n, std::uint8_t roots, Children& children) {
        while (roots > 1 && plans_[n].left[roots - 1U] == 0) --roots;
        if (roots == 1 || binary_.nodes[n].left == 0) {
            children.node[children.count++] = n;
            return;
        }
        const std::uint8_t left = plans_[n].left[roots - 1U];
        collect(binary_.nodes[n].left, left, children);
        collect(binary_.nodes[n].right, static_cast<std::uint8_t>(roots - left), children);
    }

    const BinaryTree& binary_;
    std::vector<std::uint32_t> order_;
    std::vector<Plan> plans_;
    LeafWriter leaves_;
    WideTree& tree_;
};

}  // namespace

WideTree collapse(const BinaryTree& binary, const LeafInput& input) {
    WideTree tree;
    tree.places.resize(binary.order.size());
    tree.nodes.reserve(binary.order.size() / 24 + 16);
    tree.leaves.reserve(binary.order.size() * 6 + leaf_padding);
    Collapser(binary, input, tree).run();
    tree.leaves.resize(tree.leaves.size() + leaf_padding);
    return tree;
}

WideTree refit(const MeshView& view, const LeafInput& input, std::span<const FloatBox> boxes) {
    WideTree tree;
    tree.places.resize(view.places.size());
    tree.nodes.assign(view.nodes.begin(), view.nodes.end());
    tree.leaves.reserve(view.leaves.size());
    LeafWriter leaves(input, tree);
    std::vector<FloatBox> whole(tree.nodes.size());
    // Children lie behind their parents, so backwards every child's box is there when it is asked for.
    for (std::size_t n = tree.nodes.size(); n-- > 0;) {
        WideNode& node = tree.nodes[n];
        FloatBox children[tree_width];
        for (std::uint32_t i = 0; i < node.count; ++i) {
            if ((node.child[i] & leaf_bit) == 0) {
                children[i] = whole[node.child[i]];
                continue;
            }
            const LeafBlock block = view.leaf(node.child[i] & ~leaf_bit);
            std::uint32_t ids[tree_width];
            std::copy_n(block.ids(), block.count, ids);
            children[i] = boxes[ids[0]];
            for (std::uint32_t slot = 1; slot < block.count; ++slot) children[i].include(boxes[ids[slot]]);
            node.child[i] = leaves.add({ids, block.count});
        }
        whole[n] = children[0];
        for (std::uint32_t i = 1; i < node.count; ++i) whole[n].include(children[i]);
        quantise(node, {children, node.count});
    }
    tree.leaves.resize(tree.leaves.size() + leaf_padding);
    return tree;
}

}  // namespace surefoot::internal
