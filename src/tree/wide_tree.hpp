// From a binary tree to the eight-wide one of view.hpp.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <surefoot/math.hpp>

#include "tree/binary_tree.hpp"
#include "tree/view.hpp"

namespace surefoot::internal {

/// The triangles that go into the leaves.
struct LeafInput {
    std::span<const vec3> vertices;          ///< relative to their triangle's tile
    std::span<const std::uint32_t> indices;  ///< three a triangle
    std::span<const std::uint8_t> edges{};   ///< kinds of the edges, two bits each; empty: all open
    std::span<const std::uint16_t> tiles{};  ///< which tile each triangle is in; empty: the first

    [[nodiscard]] vec3 corner(std::uint32_t triangle, std::uint32_t i) const noexcept {
        return vertices[indices[3 * std::size_t{triangle} + i]];
    }
};

struct WideTree {
    std::vector<WideNode> nodes;
    std::vector<std::uint32_t> leaves;
    std::vector<std::uint32_t> places;
    bool too_large = false;  ///< the leaves would need more than most_leaf_words
};

[[nodiscard]] WideTree collapse(const BinaryTree& binary, const LeafInput& input);

/// The same tree around triangles that have moved: every box is made anew from the leaves upwards.
/// `boxes` are those of the triangles, by id. Requires: a view that `collapse` made, of as many triangles.
[[nodiscard]] WideTree refit(const MeshView& view, const LeafInput& input, std::span<const FloatBox> boxes);

}  // namespace surefoot::internal
