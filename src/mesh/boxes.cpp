// The tree, box by box, for those who want to look at it.
#include <surefoot/mesh.hpp>

#include "mesh/data.hpp"
#include "tree/binary_tree.hpp"
#include "tree/scalar_search.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

std::size_t Mesh::tree_boxes(std::span<TreeBox> found) const noexcept {
    const MeshView& view = data_->view;
    struct Entry {
        std::uint32_t node;
        std::uint32_t depth;
    };
    Entry stack[7 * (deepest_tree + 1) + tree_width];
    constexpr std::size_t room = sizeof stack / sizeof stack[0];
    std::size_t size = 0;
    std::size_t count = 0;
    if (!view.nodes.empty()) stack[size++] = {0, 0};
    // Bytes that nobody wrote may name a node twice; no tree has more than its nodes.
    for (std::size_t left = view.nodes.size(); size > 0 && left > 0; --left) {
        const Entry entry = stack[--size];
        const WideNode& node = view.nodes[entry.node];
        for (std::uint32_t i = 0; i < node.count && i < tree_width; ++i) {
            const std::uint32_t child = node.child[i];
            const bool is_leaf = (child & leaf_bit) != 0;
            if (!is_leaf && (child <= entry.node || child >= view.nodes.size())) continue;
            const Box3 box = box_of_child(node, i);
            if (count < found.size()) {
                found[count] = {
                    .bounds = {dvec3(box.min.x, box.min.y, box.min.z), dvec3(box.max.x, box.max.y, box.max.z)},
                    .depth = entry.depth,
                    .triangles = is_leaf ? view.leaf(child & ~leaf_bit).count : 0};
            }
            ++count;
            if (!is_leaf && size < room) stack[size++] = {child, entry.depth + 1};
        }
    }
    return count;
}

}  // namespace v0
}  // namespace surefoot
