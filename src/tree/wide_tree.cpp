#include "tree/wide_tree.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "parallel.hpp"
#include "tree/leaf_writer.hpp"
#include "tree/plan.hpp"

namespace surefoot::internal {

namespace {

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

// Part of the collapse that waits for its turn.
struct Branch {
    std::uint32_t wide;    // the wide node above it
    std::uint32_t slot;    // which of its children this is
    std::uint32_t binary;  // the binary node that it begins at
    WideTree tree{};       // what became of it, numbered from 0
};

class Collapser {
public:
    // Writes nodes and leaves to `tree`. Children of at most `apart` triangles are put off, into `branches`.
    Collapser(const BinaryTree& binary, const Plan* plans, const LeafInput& input, WideTree& tree,
              std::span<std::uint32_t> places, std::uint32_t apart, std::vector<Branch>* branches)
        : binary_(binary),
          plans_(plans),
          input_(input),
          leaves_(tree, places),
          tree_(tree),
          apart_(apart),
          branches_(branches) {}

    void run(std::uint32_t binary) {
        const BinaryNode& node = binary_.nodes[binary];
        tree_.nodes.reserve(node.count / 16 + 16);
        tree_.leaves.reserve(node.count * std::size_t{7} + leaf_padding);
        tree_.nodes.resize(1);
        if (apart_ == 0) {
            first_ = node.first;
            triangles_ = std::make_unique_for_overwrite<LeafTriangle[]>(node.count);
            gather({&binary_.order[node.first], node.count}, input_, triangles_.get());
        }
        fill(0, binary);
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
            collect(node.right(), static_cast<std::uint8_t>(tree_width - left), children);
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
                result.child[i] = add_leaf(child);
            } else if (child.count <= apart_) {
                branches_->push_back({wide, i, children.node[i]});
            } else {
                result.child[i] = static_cast<std::uint32_t>(tree_.nodes.size() + inner_count);
                inner[inner_count++] = children.node[i];
            }
        }
        const auto first = static_cast<std::uint32_t>(tree_.nodes.size());
        tree_.nodes.resize(first + inner_count);
        tree_.nodes[wide] = result;
        for (std::uint32_t i = 0; i < inner_count; ++i) fill(first + i, inner[i]);
    }

    std::uint32_t add_leaf(const BinaryNode& node) {
        if (triangles_) return leaves_.add({&triangles_[node.first - first_], node.count});
        LeafTriangle triangles[tree_width];
        gather({&binary_.order[node.first], node.count}, input_, triangles);
        return leaves_.add({triangles, node.count});
    }

    void collect(std::uint32_t n, std::uint8_t roots, Children& children) {
        roots = std::min(roots, plans_[n].most);
        while (roots > 1 && plans_[n].left[roots - 1U] == 0) --roots;
        if (roots == 1) {
            children.node[children.count++] = n;
            return;
        }
        const std::uint8_t left = plans_[n].left[roots - 1U];
        collect(binary_.nodes[n].left, left, children);
        collect(binary_.nodes[n].right(), static_cast<std::uint8_t>(roots - left), children);
    }

    const BinaryTree& binary_;
    const Plan* plans_;
    const LeafInput& input_;
    LeafWriter leaves_;
    WideTree& tree_;
    std::uint32_t apart_;
    std::vector<Branch>* branches_;
    std::unique_ptr<LeafTriangle[]> triangles_;  // all of a branch, in order; null above the branches
    std::uint32_t first_ = 0;                    // the place of the first of them
};

// Puts the branches behind the top of the tree.
void join(WideTree& tree, std::vector<Branch>& branches, const BinaryTree& binary, int threads) {
    std::vector<std::size_t> first_node(branches.size());
    std::vector<std::size_t> first_word(branches.size());
    std::size_t nodes = tree.nodes.size();
    std::size_t words = tree.leaves.size();
    for (std::size_t i = 0; i < branches.size(); ++i) {
        first_node[i] = nodes;
        first_word[i] = words;
        nodes += branches[i].tree.nodes.size();
        words += branches[i].tree.leaves.size();
        tree.nodes[branches[i].wide].child[branches[i].slot] = static_cast<std::uint32_t>(first_node[i]);
        tree.too_large = tree.too_large || branches[i].tree.too_large;
    }
    tree.too_large = tree.too_large || words > most_leaf_words;
    if (tree.too_large) return;
    tree.nodes.resize(nodes);
    tree.leaves.resize(words);
    in_parallel(branches.size(), threads, [&](std::size_t i) {
        const WideTree branch = std::move(branches[i].tree);
        const auto node = static_cast<std::uint32_t>(first_node[i]);
        const auto word = static_cast<std::uint32_t>(first_word[i]);
        for (std::uint32_t n = 0; n < branch.nodes.size(); ++n) {
            WideNode& moved = tree.nodes[node + n];
            moved = branch.nodes[n];
            for (std::uint32_t k = 0; k < moved.count; ++k)
                moved.child[k] += (moved.child[k] & leaf_bit) != 0 ? word : node;
        }
        std::copy(branch.leaves.begin(), branch.leaves.end(), tree.leaves.begin() + word);
        const BinaryNode& all = binary.nodes[branches[i].binary];
        for (std::uint32_t k = all.first; k < all.first + all.count; ++k) tree.places[binary.order[k]] += word << 3;
    });
}

}  // namespace

WideTree collapse(const BinaryTree& binary, const LeafInput& input, int threads) {
    WideTree tree;
    tree.places.resize(binary.order.size());
    const std::unique_ptr<Plan[]> plans = make_plans(binary, input, threads);
    const bool shared = binary.order.size() > binary.part_size;
    std::vector<Branch> branches;
    Collapser(binary, plans.get(), input, tree, tree.places, shared ? binary.part_size : 0, &branches).run(0);
    in_parallel(branches.size(), threads, [&](std::size_t i) {
        Collapser(binary, plans.get(), input, branches[i].tree, tree.places, 0, nullptr).run(branches[i].binary);
    });
    join(tree, branches, binary, threads);
    tree.leaves.resize(tree.leaves.size() + leaf_padding);
    std::fill(tree.leaves.end() - leaf_padding, tree.leaves.end(), 0U);
    return tree;
}

WideTree refit(const MeshView& view, const LeafInput& input, std::span<const FloatBox> boxes) {
    WideTree tree;
    tree.places.resize(view.places.size());
    tree.nodes.assign(view.nodes.begin(), view.nodes.end());
    tree.leaves.reserve(view.leaves.size());
    LeafWriter leaves(tree, tree.places);
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
            LeafTriangle triangles[tree_width];
            gather({ids, block.count}, input, triangles);
            node.child[i] = leaves.add({triangles, block.count});
        }
        whole[n] = children[0];
        for (std::uint32_t i = 1; i < node.count; ++i) whole[n].include(children[i]);
        quantise(node, {children, node.count});
    }
    tree.leaves.resize(tree.leaves.size() + leaf_padding);
    std::fill(tree.leaves.end() - leaf_padding, tree.leaves.end(), 0U);
    return tree;
}

}  // namespace surefoot::internal
