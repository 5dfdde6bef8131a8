// The wide tree walked one box at a time, in doubles: what the SIMD search is measured and tested against, and what the
// queries use whose speed is not worth a kernel.
#pragma once

#include <utility>

#include "query/reach.hpp"
#include "tree/binary_tree.hpp"
#include "tree/view.hpp"

namespace surefoot::internal {

/// The part of a motion, as times in [0, 1], during which something of this extent about its reference point meets a
/// box.
class BoxSweep {
public:
    BoxSweep(const Motion& motion, const Box3& extent) noexcept;

    /// When it enters, or anything above 1 if it does not. Never later than the truth.
    [[nodiscard]] double operator()(const Box3& box) const noexcept;

private:
    Vec from_;
    Vec along_;
    Box3 extent_;
};

/// How far a box is from a point, along the axis in which it is farthest off [m].
class BoxDistance {
public:
    explicit BoxDistance(const dvec3& point) noexcept : point_(to_vec(point)) {}
    [[nodiscard]] double operator()(const Box3& box) const noexcept;

private:
    Vec point_;
};

[[nodiscard]] inline Box3 box_of_child(const WideNode& node, std::uint32_t i) noexcept {
    return {{node.decoded(0, node.low[0][i]), node.decoded(1, node.low[1][i]), node.decoded(2, node.low[2][i])},
            {node.decoded(0, node.high[0][i]), node.decoded(1, node.high[1][i]), node.decoded(2, node.high[2][i])}};
}

/// The box around all children of a node.
[[nodiscard]] Box3 box_of_node(const WideNode& node) noexcept;

/// Calls `look(leaf word)` for the leaves whose `measure` of their box is at most `limit()`, least first, and
/// `opened(node, measure)` for the nodes on the way to them. Returns false if a bound on the work was exceeded, which
/// only bytes that nobody wrote do.
template <typename Measure, typename Look, typename Limit, typename Opened>
bool search_by(const MeshView& view, const Measure& measure, const Look& look, const Limit& limit,
               const Opened& opened) noexcept {
    struct Entry {
        double at;
        std::uint32_t child;
    };
    Entry stack[7 * (deepest_tree + 1) + tree_width];
    constexpr std::size_t room = sizeof stack / sizeof stack[0];
    std::size_t size = 0;
    if (view.nodes.empty()) return true;
    stack[size++] = {0, 0};
    std::size_t left = view.nodes.size();
    while (size > 0) {
        const Entry entry = stack[--size];
        if (entry.at > limit()) continue;
        if ((entry.child & leaf_bit) != 0) {
            look(entry.child & ~leaf_bit);
            continue;
        }
        if (left-- == 0) return false;
        const WideNode& node = view.nodes[entry.child];
        opened(node, entry.at);
        const std::size_t first = size;
        for (std::uint32_t i = 0; i < node.count && i < tree_width; ++i) {
            const std::uint32_t child = node.child[i];
            if ((child & leaf_bit) == 0 && (child <= entry.child || child >= view.nodes.size())) continue;
            const double at = measure(box_of_child(node, i));
            if (at > limit()) continue;
            if (size == room) return false;
            std::size_t place = size++;
            for (; place > first && stack[place - 1].at < at; --place) stack[place] = stack[place - 1];
            stack[place] = {at, child};
        }
    }
    return true;
}

}  // namespace surefoot::internal
