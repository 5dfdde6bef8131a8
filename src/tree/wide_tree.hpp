// From a binary tree to the eight-wide one of view.hpp.
#pragma once

#include <cstdint>
#include <memory>
#include <new>
#include <span>
#include <utility>
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

// New elements are left as they are, so that whoever writes them is the first to touch their memory.
template <typename T>
struct LeavesUnset : std::allocator<T> {
    template <typename U>
    struct rebind {
        using other = LeavesUnset<U>;
    };
    void construct(T* element) noexcept { ::new (static_cast<void*>(element)) T; }
    template <typename... Arguments>
    void construct(T* element, Arguments&&... arguments) noexcept {
        ::new (static_cast<void*>(element)) T(std::forward<Arguments>(arguments)...);
    }
};
template <typename T>
using UnsetVector = std::vector<T, LeavesUnset<T>>;

struct WideTree {
    UnsetVector<WideNode> nodes;
    UnsetVector<std::uint32_t> leaves;
    UnsetVector<std::uint32_t> places;
    bool too_large = false;  ///< the leaves would need more than most_leaf_words
};

/// The same tree whatever the number of threads [1, 64].
[[nodiscard]] WideTree collapse(const BinaryTree& binary, const LeafInput& input, int threads);

/// The same tree around triangles that have moved: every box is made anew from the leaves upwards.
/// `boxes` are those of the triangles, by id. Requires: a view that `collapse` made, of as many triangles.
[[nodiscard]] WideTree refit(const MeshView& view, const LeafInput& input, std::span<const FloatBox> boxes);

}  // namespace surefoot::internal
