// Leaf blocks as view.hpp describes them.
#pragma once

#include <cstdint>
#include <span>

#include <surefoot/math.hpp>

#include "tree/wide_tree.hpp"

namespace surefoot::internal {

/// All that a leaf keeps of a triangle.
struct LeafTriangle {
    vec3 corners[3];
    std::uint32_t id;
    std::uint16_t tile;
    std::uint8_t edges;
};

/// Copies the triangles with these ids to `to`, which has room for as many.
void gather(std::span<const std::uint32_t> ids, const LeafInput& input, LeafTriangle* to) noexcept;

/// Writes leaf blocks one behind the other.
class LeafWriter {
public:
    LeafWriter(WideTree& tree, std::span<std::uint32_t> places) : tree_(tree), places_(places) {}

    /// Returns what a parent keeps: leaf_bit and the first word. Requires: 1 to 8 triangles of one tile.
    std::uint32_t add(std::span<const LeafTriangle> triangles);

private:
    WideTree& tree_;
    std::span<std::uint32_t> places_;
};

}  // namespace surefoot::internal
