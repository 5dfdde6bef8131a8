#include "kernels/mesh_search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "tree/binary_tree.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "kernels/mesh_search.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>  // compiles this file once for each target, so no header below may be left unguarded
#include <hwy/highway.h>

#include "kernels/batch-inl.hpp"
#include "kernels/boxes-inl.hpp"
#include "kernels/children-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace surefoot::internal {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

HWY_INLINE void from_about(const MeshSearch& search, const Vec& origin, float (&from)[3]) noexcept {
    from[0] = static_cast<float>(search.motion.from.x - origin.x);
    from[1] = static_cast<float>(search.motion.from.y - origin.y);
    from[2] = static_cast<float>(search.motion.from.z - origin.z);
}

HWY_INLINE void prefetch_leaf(const MeshView& view, std::uint32_t word) noexcept {
    if (word >= view.leaves.size()) return;
    const std::uint32_t* const words = &view.leaves[word];
    hwy::Prefetch(words);
    hwy::Prefetch(words + 16);  // of 64 bytes each; a leaf has two to six
    hwy::Prefetch(words + 32);
}

// Calls `visit(leaf words)` for the leaves whose boxes meet the region, many at a time.
template <class Visit>
HWY_INLINE void visit_region(MeshSearch& search, const Visit& visit) noexcept {
    const MeshView& view = *search.view;
    if (view.nodes.empty()) return;
    const FloatRegion region = region_about(search.region, {});
    NodeQueue nodes;
    LeafList leaves;
    nodes.push_root();
    // Every node has one parent, so no more than all of them can be opened.
    std::size_t left = view.nodes.size();
    while (!nodes.is_empty()) {
        const std::uint32_t index = nodes.pop();
        const WideNode& node = view.nodes[index];
        ++search.nodes;
        if (left-- == 0) {
            search.overflowed = true;
            return;
        }
        const ChosenChildren children(node, index, view.nodes.size(), children_in(node, region));
        for (const std::uint32_t word : leaves.add(children)) prefetch_leaf(view, word);
        for (const std::uint32_t child : nodes.add(children)) {
            hwy::Prefetch(&view.nodes[child]);
            hwy::Prefetch(reinterpret_cast<const char*>(&view.nodes[child]) + 64);  // a node may lie across two lines
        }
        if (leaves.is_full()) {
            visit(leaves.get());
            leaves.clear();
        }
    }
    visit(leaves.get());
}

void SearchRegion(MeshSearch& search) {
    const MeshView& view = *search.view;
    Outbox out(search);
    Batch batch(search);
    std::uint32_t tile = ~0U;
    FloatRegion region{};
    float from[3] = {};
    visit_region(search, [&](std::span<const std::uint32_t> leaves) HWY_ATTR {
        for (const std::uint32_t word : leaves) {
            const LeafBlock block = view.leaf(word);
            if (block.count == 0) continue;
            if (block.tile != tile) {
                tile = block.tile;
                region = region_about(search.region, view.origin_of(tile));
                from_about(search, view.origin_of(tile), from);
            }
            batch.add(block, word, triangles_in(block, region), from, out);
        }
    });
    batch.filter(out);
    out.flush();
}

void SearchBoxes(MeshSearch& search) {
    const MeshView& view = *search.view;
    Outbox out(search);
    visit_region(search, [&](std::span<const std::uint32_t> leaves) HWY_ATTR {
        for (const std::uint32_t word : leaves) {
            const LeafBlock block = view.leaf(word);
            if (block.count == 0) continue;
            std::uint32_t bits = triangles_in(block, region_about(search.region, view.origin_of(block.tile)));
            while (bits != 0) {
                const auto slot = static_cast<std::uint32_t>(std::countr_zero(bits));
                bits &= bits - 1;
                out.add({0, word << 3 | slot});
            }
        }
    });
    out.flush();
}

// All triangles of a leaf at once.
HWY_INLINE void filter_leaf(const MeshSearch& search, const LeafBlock& block, std::uint32_t word,
                            const float (&from)[3], Outbox& out) noexcept {
    const Corners corners(block, from);
    const auto load = [&](int i, std::size_t lane) HWY_ATTR { return corners.at(i, lane); };
    float times[tree_width];
    std::uint32_t bits = survivors<true>(search.filter, load, block.count, size_of(from), search.limit, times);
    while (bits != 0) {
        const auto slot = static_cast<std::uint32_t>(std::countr_zero(bits));
        bits &= bits - 1;
        out.add({times[slot], word << 3 | slot});
    }
}

void SearchAlong(MeshSearch& search) {
    const MeshView& view = *search.view;
    if (view.nodes.empty()) return;
    struct Entry {
        float t;
        std::uint32_t child;
    };
    Outbox out(search);
    const Slabs slabs = slabs_of(search);
    Entry stack[stack_size];
    std::size_t size = 0;
    stack[size++] = {0, 0};
    std::size_t left = view.nodes.size();
    std::uint32_t tile = ~0U;
    float from[3] = {};
    while (size > 0) {
        const Entry entry = stack[--size];
        out.settle(entry.t);
        if (entry.t > search.limit) continue;
        if ((entry.child & leaf_bit) != 0) {
            const std::uint32_t word = entry.child & ~leaf_bit;
            const LeafBlock block = view.leaf(word);
            if (block.count == 0) continue;
            if (block.tile != tile) {
                tile = block.tile;
                from_about(search, view.origin_of(tile), from);
            }
            filter_leaf(search, block, word, from, out);
            continue;
        }
        const WideNode& node = view.nodes[entry.child];
        ++search.nodes;
        if (left-- == 0) {
            search.overflowed = true;
            return;
        }
        float times[tree_width];
        std::uint32_t bits = children_along(node, slabs, search.limit, times);
        const std::size_t first = size;
        while (bits != 0 && size < stack_size) {
            const int i = std::countr_zero(bits);
            bits &= bits - 1;
            const std::uint32_t child = node.child[i];
            if ((child & leaf_bit) == 0 && (child <= entry.child || child >= view.nodes.size())) continue;
            // The farthest lowest, so that the nearest comes off first.
            std::size_t place = size++;
            while (place > first && stack[place - 1].t < times[i]) {
                stack[place] = stack[place - 1];
                --place;
            }
            stack[place] = {times[i], child};
        }
        if (size > first) {
            const std::uint32_t next = stack[size - 1].child;
            if ((next & leaf_bit) != 0) {
                prefetch_leaf(view, next & ~leaf_bit);
            } else {
                hwy::Prefetch(&view.nodes[next]);
            }
        }
    }
    out.flush();
}

}  // namespace HWY_NAMESPACE
}  // namespace surefoot::internal
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace surefoot::internal {

HWY_EXPORT(SearchRegion);
HWY_EXPORT(SearchAlong);
HWY_EXPORT(SearchBoxes);

void search_region(MeshSearch& search) noexcept {
    HWY_DYNAMIC_DISPATCH(SearchRegion)(search);
}
void search_along(MeshSearch& search) noexcept {
    HWY_DYNAMIC_DISPATCH(SearchAlong)(search);
}
void search_boxes(MeshSearch& search) noexcept {
    HWY_DYNAMIC_DISPATCH(SearchBoxes)(search);
}

}  // namespace surefoot::internal

#endif
