// Insertion by the least growth in surface (Goldsmith, Salmon, "Automatic Creation of Object Hierarchies for Ray
// Tracing", 1987), balance by rotations (Adelson-Velsky, Landis, "An algorithm for the organization of information",
// 1962). Leaves have no order, so of the two grandchildren on the higher side either may stay up, and one rotation
// does.
#include "world/top_tree.hpp"

#include <utility>

namespace surefoot::internal {

namespace {

Box3 joined(const Box3& a, const Box3& b) noexcept {
    Box3 box = a;
    box.include(b);
    return box;
}

double half_surface(const Box3& box) noexcept {
    const Vec size = box.max - box.min;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

bool contains(const Box3& outer, const Box3& inner) noexcept {
    return outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && outer.min.z <= inner.min.z &&
           inner.max.x <= outer.max.x && inner.max.y <= outer.max.y && inner.max.z <= outer.max.z;
}

}  // namespace

std::uint32_t TopTree::take_node() {
    if (free_ != none) return std::exchange(free_, nodes_[free_].parent);
    nodes_.emplace_back();
    return static_cast<std::uint32_t>(nodes_.size() - 1);
}

void TopTree::give_node_back(std::uint32_t node) noexcept {
    nodes_[node] = Node{};
    nodes_[node].parent = std::exchange(free_, node);
}

std::uint32_t TopTree::insert(const Box3& box, WorldBody* body) {
    const std::uint32_t leaf = take_node();
    spare_ = root_ == none ? none : take_node();
    nodes_[leaf] = Node{};
    nodes_[leaf].box = box;
    nodes_[leaf].body = body;
    link(leaf);
    return leaf;
}

void TopTree::remove(std::uint32_t leaf) noexcept {
    unlink(leaf);
    if (spare_ != none) give_node_back(std::exchange(spare_, none));
    give_node_back(leaf);
}

void TopTree::move(std::uint32_t leaf, const Box3& box) noexcept {
    const std::uint32_t parent = nodes_[leaf].parent;
    if (parent == none || contains(nodes_[parent].box, box)) {
        // It stays where its neighbours are, so the tree stays good: refit.
        nodes_[leaf].box = box;
        for (std::uint32_t node = parent; node != none; node = nodes_[node].parent) update(node);
        return;
    }
    unlink(leaf);
    nodes_[leaf].box = box;
    link(leaf);
}

// Requires: `spare_` is a node to become the leaf's parent, unless the tree is empty.
void TopTree::link(std::uint32_t leaf) noexcept {
    nodes_[leaf].parent = none;
    if (root_ == none) {
        root_ = leaf;
        return;
    }
    const Box3 box = nodes_[leaf].box;
    std::uint32_t sibling = root_;
    while (nodes_[sibling].body == nullptr) {
        // Down to a leaf, always: beside a higher node the new one would be out of balance by more than one rotation.
        const auto growth = [&](std::uint32_t child) noexcept {
            const Box3& old = nodes_[child].box;
            return half_surface(joined(old, box)) - half_surface(old);
        };
        const std::uint32_t* children = nodes_[sibling].children;
        const double one = growth(children[0]);
        const double two = growth(children[1]);
        const bool first = one != two ? one < two : nodes_[children[0]].height <= nodes_[children[1]].height;
        sibling = children[first ? 0 : 1];
    }
    const std::uint32_t parent = std::exchange(spare_, none);
    const std::uint32_t above = nodes_[sibling].parent;
    nodes_[parent] = Node{};
    nodes_[parent].parent = above;
    nodes_[parent].children[0] = sibling;
    nodes_[parent].children[1] = leaf;
    replace_child(above, sibling, parent);
    nodes_[sibling].parent = parent;
    nodes_[leaf].parent = parent;
    update_upwards(parent);
}

// Leaves the node that was the leaf's parent in `spare_`.
void TopTree::unlink(std::uint32_t leaf) noexcept {
    const std::uint32_t parent = nodes_[leaf].parent;
    if (parent == none) {
        root_ = none;
        return;
    }
    const std::uint32_t sibling = nodes_[parent].children[nodes_[parent].children[0] == leaf ? 1 : 0];
    const std::uint32_t above = nodes_[parent].parent;
    replace_child(above, parent, sibling);
    nodes_[sibling].parent = above;
    spare_ = parent;
    update_upwards(above);
}

void TopTree::replace_child(std::uint32_t parent, std::uint32_t old_child, std::uint32_t new_child) noexcept {
    if (parent == none) {
        root_ = new_child;
    } else {
        nodes_[parent].children[nodes_[parent].children[0] == old_child ? 0 : 1] = new_child;
    }
}

void TopTree::update(std::uint32_t node) noexcept {
    const Node& one = nodes_[nodes_[node].children[0]];
    const Node& two = nodes_[nodes_[node].children[1]];
    nodes_[node].box = joined(one.box, two.box);
    nodes_[node].height = 1 + (one.height < two.height ? two.height : one.height);
}

void TopTree::update_upwards(std::uint32_t node) noexcept {
    while (node != none) {
        update(node);
        node = nodes_[balance(node)].parent;
    }
}

// Where one child is two higher than the other, it takes its parent's place. Returns what stands there now.
std::uint32_t TopTree::balance(std::uint32_t node) noexcept {
    const std::int32_t lean = nodes_[nodes_[node].children[1]].height - nodes_[nodes_[node].children[0]].height;
    if (lean >= -1 && lean <= 1) return node;
    const int high_side = lean > 0 ? 1 : 0;
    const std::uint32_t high = nodes_[node].children[high_side];
    const int keep = nodes_[nodes_[high].children[0]].height < nodes_[nodes_[high].children[1]].height ? 1 : 0;
    const std::uint32_t given = nodes_[high].children[1 - keep];

    replace_child(nodes_[node].parent, node, high);
    nodes_[high].parent = nodes_[node].parent;
    nodes_[high].children[1 - keep] = node;
    nodes_[node].parent = high;
    nodes_[node].children[high_side] = given;
    nodes_[given].parent = node;
    update(node);
    update(high);
    return high;
}

}  // namespace surefoot::internal
