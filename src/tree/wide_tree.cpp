// Which nodes of the binary tree become wide nodes is decided by dynamic programming over the surface area heuristic:
// Ylitie, Karras, Laine, "Efficient Incoherent Ray Traversal on GPUs Through Compressed Wide BVHs" (2017), section 3.
#include "tree/wide_tree.hpp"

#include <algorithm>
#include <hwy/cache_control.h>
#include <limits>
#include <memory>
#include <utility>

#include "parallel.hpp"

namespace surefoot::internal {

namespace {

// What it costs to look into a node, into a leaf, and at one of its triangles.
constexpr float node_cost = 1.0F;
constexpr float leaf_cost = 1.0F;
constexpr float triangle_cost = 0.03F;

// The cheapest way to stand for a subtree with at most i roots, i = 1 ... most.
struct Plan {
    float cost[tree_width];
    std::uint8_t left[tree_width];  ///< how many of them in the left half; 0: one root less is as good
    std::uint8_t left_of_node;      ///< as a wide node of its own: how many of its eight; 0: better a leaf
    std::uint8_t most;              ///< how many of its nodes can be roots at once [1, 8]
};

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

// All that a leaf keeps of a triangle.
struct LeafTriangle {
    vec3 corners[3];
    std::uint32_t id;
    std::uint16_t tile;
    std::uint8_t edges;
};

// Triangles lie anywhere in memory, so those that come next are fetched while others are copied.
void gather(std::span<const std::uint32_t> ids, const LeafInput& input, LeafTriangle* to) {
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

// Writes leaf blocks one behind the other.
class LeafWriter {
public:
    LeafWriter(WideTree& tree, std::span<std::uint32_t> places) : tree_(tree), places_(places) {}

    // Returns what a parent keeps: leaf_bit and the first word.
    std::uint32_t add(std::span<const LeafTriangle> triangles) {
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

private:
    WideTree& tree_;
    std::span<std::uint32_t> places_;
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
    const std::unique_ptr<Plan[]> plans = Planner(binary, input).run(threads);
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
