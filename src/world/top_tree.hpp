// The tree over the bodies of a world: boxes that come, go and move one by one. It stays balanced, so that a walk needs
// no more than a small stack, and it never decides an answer: any tree over the same boxes gives the same ones.
#pragma once

#include <cstdint>
#include <vector>

#include "query/reach.hpp"

namespace surefoot::internal {

struct WorldBody;

class TopTree {
public:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    /// No two children differ by more than one in height, so 2^31 leaves stand at most 45 high; a walk that pushes two
    /// and pops one holds one more than that.
    static constexpr int stack_size = 64;

    struct Node {
        Box3 box;
        WorldBody* body = nullptr;       ///< of a leaf
        std::uint32_t parent = none;     ///< of the root: none; of an unused node: the next one
        std::uint32_t children[2] = {};  ///< of an inner node
        std::int32_t height = 0;         ///< of a leaf: 0
    };

    /// Returns the leaf. May allocate; nothing else here does.
    std::uint32_t insert(const Box3& box, WorldBody* body);
    void remove(std::uint32_t leaf) noexcept;
    /// The leaf keeps its number.
    void move(std::uint32_t leaf, const Box3& box) noexcept;

    /// The box around everything; all zeros when there is nothing.
    [[nodiscard]] Box3 bounds() const noexcept { return root_ == none ? Box3{} : nodes_[root_].box; }

    /// How many boxes lie one in another above the lowest leaf.
    [[nodiscard]] std::int32_t height() const noexcept { return root_ == none ? 0 : nodes_[root_].height; }

    /// Calls `ask(body)` for all bodies whose `key(box)` is at most `limit()` when it is their turn, lowest keys first
    /// as far as the tree knows. `open()` is told of every box that is opened.
    template <typename Key, typename Limit, typename Ask, typename Open>
    void visit(const Key& key, const Limit& limit, const Ask& ask, const Open& open) const {
        struct Entry {
            double key;
            std::uint32_t node;
        };
        Entry stack[stack_size];
        int size = 0;
        if (root_ != none) stack[size++] = {key(nodes_[root_].box), root_};
        while (size > 0) {
            const Entry entry = stack[--size];
            if (!(entry.key <= limit())) continue;
            const Node& node = nodes_[entry.node];
            open();
            if (node.body != nullptr) {
                ask(*node.body);
                continue;
            }
            const Entry one{key(nodes_[node.children[0]].box), node.children[0]};
            const Entry two{key(nodes_[node.children[1]].box), node.children[1]};
            const bool one_first = one.key <= two.key;
            stack[size++] = one_first ? two : one;
            stack[size++] = one_first ? one : two;
        }
    }

private:
    [[nodiscard]] std::uint32_t take_node();
    void give_node_back(std::uint32_t node) noexcept;
    void link(std::uint32_t leaf) noexcept;
    void unlink(std::uint32_t leaf) noexcept;
    void update(std::uint32_t node) noexcept;
    void update_upwards(std::uint32_t node) noexcept;
    [[nodiscard]] std::uint32_t balance(std::uint32_t node) noexcept;
    void replace_child(std::uint32_t parent, std::uint32_t old_child, std::uint32_t new_child) noexcept;

    std::vector<Node> nodes_;
    std::uint32_t root_ = none;
    std::uint32_t free_ = none;
    std::uint32_t spare_ = none;  // the inner node that a leaf being moved has left behind
};

}  // namespace surefoot::internal
