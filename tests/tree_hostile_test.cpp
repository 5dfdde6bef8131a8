// Trees that no builder made: whatever their bytes say, a search stays within its bounds and says so.
#include <gtest/gtest.h>
#include <vector>

#include "kernels/mesh_search.hpp"

namespace surefoot::internal {
namespace {

WideNode node_with(const std::vector<std::uint32_t>& children) {
    WideNode node{};
    for (int axis = 0; axis < 3; ++axis) {
        node.exponent[axis] = 127;
        for (std::uint8_t& high : node.high[axis]) high = 255;
    }
    node.count = static_cast<std::uint8_t>(children.size());
    for (std::size_t i = 0; i < children.size(); ++i) node.child[i] = children[i];
    return node;
}

// Two levels of eight, so that many nodes wait; below each of them a chain that is deeper than any tree that is built,
// and that leaves seven waiting at each level.
std::vector<WideNode> deep_tree(std::uint32_t depth) {
    const std::uint32_t chain = 1 + 8 + 64;
    const std::uint32_t last = chain + depth;
    std::vector<WideNode> nodes;
    for (std::uint32_t i = 0; i < 9; ++i) {
        std::vector<std::uint32_t> children;
        for (std::uint32_t k = 1; k <= 8; ++k) children.push_back(8 * i + k);
        nodes.push_back(node_with(children));
    }
    while (nodes.size() < chain) nodes.push_back(node_with(std::vector<std::uint32_t>(8, chain)));
    while (nodes.size() < last) {
        std::vector<std::uint32_t> children(7, last);
        children.push_back(static_cast<std::uint32_t>(nodes.size()) + 1);
        nodes.push_back(node_with(children));
    }
    nodes.push_back(node_with({}));
    return nodes;
}

MeshSearch search_in(const MeshView& view) {
    MeshSearch search;
    search.view = &view;
    search.region = search.extent = {{0, 0, 0}, {10, 10, 10}};
    search.take = [](void*, std::span<Candidate>) noexcept { return 1.0F; };
    return search;
}

TEST(HostileTree, deeper_than_any_that_is_built_overflows_and_writes_nothing_beside) {
    const std::vector<WideNode> nodes = deep_tree(400);
    MeshView view;
    view.nodes = nodes;
    MeshSearch boxes = search_in(view);
    search_boxes(boxes);
    EXPECT_TRUE(boxes.overflowed);
    MeshSearch region = search_in(view);
    search_region(region);
    EXPECT_TRUE(region.overflowed);
    std::vector<MeshSearch> many(most_regions, search_in(view));
    search_regions(many);
    for (const MeshSearch& search : many) {
        EXPECT_TRUE(search.overflowed);
        EXPECT_LT(search.nodes, nodes.size()) << "by what waits, before every node was opened";
    }
}

}  // namespace
}  // namespace surefoot::internal
