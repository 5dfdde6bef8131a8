// Check::structure: is every part of a mesh what building makes of it? Nothing depends on it but the trust in answers.
#include <vector>

#include "limits.hpp"
#include "mesh/sections.hpp"

namespace surefoot::internal {
namespace {

class StructureCheck {
public:
    StructureCheck(const MeshView& view, const Container& container)
        : view_(view),
          container_(container),
          node_seen_(view.nodes.size(), false),
          within_(view.nodes.size(), view.bounds),
          triangle_seen_(view.places.size(), false) {}

    [[nodiscard]] Expected<void> run() {
        if (view_.nodes.empty() && !view_.places.empty()) return fail("nodes", 0, "has triangles but no tree");
        for (std::size_t i = 0; i < view_.tiles.size(); ++i)
            if (!is_valid_point(view_.tiles[i])) return fail("tiles", i, "has a tile beyond 1e9 m");
        for (std::size_t i = 0; i < view_.nodes.size(); ++i) {
            if (i > 0 && !node_seen_[i]) return fail("nodes", i, "has a node that belongs to no other");
            if (auto sound = node(i); !sound) return sound;
        }
        if (triangles_ != view_.places.size()) return fail("places", triangles_, "has triangles that are in no leaf");
        return {};
    }

private:
    [[nodiscard]] Expected<void> node(std::size_t index) {
        const WideNode& node = view_.nodes[index];
        if (node.count == 0 || node.count > tree_width) return fail("nodes", index, "has a node with a wrong count");
        for (int k = 0; k < node.count; ++k) {
            const std::uint32_t child = node.child[k];
            // Boxes are rounded outwards on a grid of each node's own, so a child's may stick out a little; but what
            // is below has to lie in all of them.
            const Box3 box = common(box_of(node, k), within_[index]);
            if ((child & leaf_bit) != 0) {
                if (auto sound = leaf(child & ~leaf_bit, box); !sound) return sound;
                continue;
            }
            if (child <= index || child >= view_.nodes.size() || node_seen_[child])
                return fail("nodes", index, "has a node whose child is not behind it, or has two parents");
            node_seen_[child] = true;
            within_[child] = box;
        }
        return {};
    }

    [[nodiscard]] Expected<void> leaf(std::uint32_t word, const Box3& box) {
        const LeafBlock block = view_.leaf(word);
        if (block.count == 0) return fail("leaves", word, "has a leaf that is none");
        if (block.tile >= (view_.tiles.empty() ? 1 : view_.tiles.size()))
            return fail("leaves", word, "has a leaf in a tile that is not there");
        for (std::uint32_t slot = 0; slot < block.count; ++slot) {
            const std::uint32_t id = block.ids()[slot];
            if (id >= view_.places.size() || triangle_seen_[id] || view_.places[id] != word * 8 + slot)
                return fail("leaves", word, "has a leaf with a triangle that is elsewhere");
            triangle_seen_[id] = true;
            ++triangles_;
            for (int i = 0; i < 3; ++i)
                if (block.corner(i)[slot] >= block.vertices)
                    return fail("leaves", word, "has a triangle without all of its corners");
            const Triangle triangle = view_.triangle(block, slot);
            if (!is_valid_triangle(triangle))
                return fail("leaves", word, "has a vertex that is not finite or lies beyond 1e9 m");
            for (const dvec3& corner : {triangle.a, triangle.b, triangle.c}) {
                const Vec v = to_vec(corner);
                if (!contains(box, {v, v})) return fail("leaves", word, "has a triangle that sticks out of its box");
            }
        }
        return {};
    }

    [[nodiscard]] static Box3 box_of(const WideNode& node, int child) noexcept {
        const auto corner = [&](const std::uint8_t(&sides)[3][tree_width]) {
            return Vec{double{node.decoded(0, sides[0][child])}, double{node.decoded(1, sides[1][child])},
                       double{node.decoded(2, sides[2][child])}};
        };
        return {corner(node.low), corner(node.high)};
    }

    [[nodiscard]] static Box3 common(const Box3& a, const Box3& b) noexcept {
        return {{larger(a.min.x, b.min.x), larger(a.min.y, b.min.y), larger(a.min.z, b.min.z)},
                {smaller(a.max.x, b.max.x), smaller(a.max.y, b.max.y), smaller(a.max.z, b.max.z)}};
    }

    // False for NaN.
    [[nodiscard]] static bool contains(const Box3& outer, const Box3& inner) noexcept {
        return outer.min.x <= inner.min.x && outer.min.y <= inner.min.y && outer.min.z <= inner.min.z &&
               inner.max.x <= outer.max.x && inner.max.y <= outer.max.y && inner.max.z <= outer.max.z;
    }

    [[nodiscard]] tl::unexpected<Error> fail(std::string_view array, std::uint64_t item, const char* what) const {
        const Section* const section = container_.find(surefoot_owner, array);
        const std::uint64_t size = array == "nodes" ? sizeof(WideNode) : array == "tiles" ? sizeof(dvec3) : 4;
        const std::uint64_t begin = section == nullptr ? 0 : container_.offset_of(*section);
        return tl::unexpected(file_error(ErrorCode::unreadable, container_.file(), begin + size * item, what));
    }
    const MeshView& view_;
    const Container& container_;
    std::vector<bool> node_seen_;
    std::vector<Box3> within_;  ///< what all boxes above a node have in common
    std::vector<bool> triangle_seen_;
    std::size_t triangles_ = 0;
};

}  // namespace

Expected<void> check_structure(const MeshView& view, const Container& container) {
    return StructureCheck(view, container).run();
}

}  // namespace surefoot::internal
