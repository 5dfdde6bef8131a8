#include "kernels/mesh_search.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <new>

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

// The leaves whose boxes meet a region, a node at a time.
class RegionWalk {
public:
    explicit RegionWalk(MeshSearch& search) noexcept
        : search_(search), region_(region_about(search.region, {})), left_(search.view->nodes.size()) {
        if (left_ > 0) nodes_.push_root();
    }

    [[nodiscard]] HWY_INLINE bool is_done() const noexcept { return nodes_.is_empty(); }
    [[nodiscard]] HWY_INLINE LeafList& leaves() noexcept { return leaves_; }

    /// Requires: not is_done(), room for leaves.
    HWY_INLINE void open_next() noexcept {
        const MeshView& view = *search_.view;
        const std::uint32_t index = nodes_.pop();
        const WideNode& node = view.nodes[index];
        ++search_.nodes;
        // Every node has one parent, so no more than all of them can be opened.
        if (left_-- == 0) return give_up();
        const ChosenChildren children(node, index, view.nodes.size(), children_in(node, region_));
        for (const std::uint32_t word : leaves_.add(children)) prefetch_leaf(view, word);
        for (const std::uint32_t child : nodes_.add(children)) {
            hwy::Prefetch(&view.nodes[child]);
            hwy::Prefetch(reinterpret_cast<const char*>(&view.nodes[child]) + 64);  // a node may lie across two lines
        }
        if (nodes_.has_overflowed()) give_up();
    }

private:
    HWY_INLINE void give_up() noexcept {
        search_.overflowed = true;
        nodes_.clear();
    }

    MeshSearch& search_;
    FloatRegion region_;
    std::size_t left_;
    NodeQueue nodes_;
    LeafList leaves_;
};

// Calls `visit(leaf words)` for all of them, many at a time.
template <class Visit>
HWY_INLINE void visit_region(MeshSearch& search, const Visit& visit) noexcept {
    RegionWalk walk(search);
    while (!walk.is_done()) {
        walk.open_next();
        if (walk.leaves().is_full()) {
            visit(walk.leaves().get());
            walk.leaves().clear();
        }
    }
    visit(walk.leaves().get());
}

// From leaves to candidates.
class LeafSearch {
public:
    explicit LeafSearch(MeshSearch& search) noexcept : search_(search), out_(search), batch_(search) {}

    HWY_INLINE void look_into(std::span<const std::uint32_t> leaves) noexcept {
        const MeshView& view = *search_.view;
        for (const std::uint32_t word : leaves) {
            const LeafBlock block = view.leaf(word);
            if (block.count == 0) continue;
            if (block.tile != tile_) {
                tile_ = block.tile;
                region_ = region_about(search_.region, view.origin_of(tile_));
                from_about(search_, view.origin_of(tile_), from_);
            }
            batch_.add(block, word, triangles_in(block, region_), from_, out_);
        }
    }
    HWY_INLINE void finish() noexcept {
        batch_.filter(out_);
        out_.flush();
    }

private:
    MeshSearch& search_;
    std::uint32_t tile_ = ~0U;
    FloatRegion region_{};
    float from_[3] = {};
    Outbox out_;
    Batch batch_;
};

void SearchRegion(MeshSearch& search) {
    LeafSearch leaves(search);
    visit_region(search, [&](std::span<const std::uint32_t> words) HWY_ATTR { leaves.look_into(words); });
    leaves.finish();
}

// A region whose leaves come to more than a list holds is gone through on its own, after the others.
void SearchRegions(std::span<MeshSearch> searches) {
    union Walks {
        Walks() noexcept {}
        RegionWalk walk[most_regions];
    } walks;
    const std::size_t count = std::min(searches.size(), most_regions);
    std::uint32_t going = 0;
    std::uint32_t crowded = 0;
    for (std::size_t i = 0; i < count; ++i) {
        ::new (&walks.walk[i]) RegionWalk(searches[i]);
        if (!walks.walk[i].is_done()) going |= 1U << i;
    }
    while (going != 0) {
        for (std::uint32_t turn = going; turn != 0; turn &= turn - 1) {
            const int i = std::countr_zero(turn);
            RegionWalk& walk = walks.walk[i];
            walk.open_next();
            if (walk.is_done()) {
                going &= ~(1U << i);
            } else if (walk.leaves().is_full()) {
                going &= ~(1U << i);
                crowded |= 1U << i;
            }
        }
    }
    for (std::size_t i = 0; i < count; ++i) {
        RegionWalk& walk = walks.walk[i];
        LeafSearch leaves(searches[i]);
        leaves.look_into(walk.leaves().get());
        if ((crowded >> i & 1) != 0) {
            walk.leaves().clear();
            while (!walk.is_done()) {
                walk.open_next();
                if (!walk.is_done() && !walk.leaves().is_full()) continue;
                leaves.look_into(walk.leaves().get());
                walk.leaves().clear();
            }
        }
        leaves.finish();
    }
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
HWY_EXPORT(SearchRegions);
HWY_EXPORT(SearchAlong);
HWY_EXPORT(SearchBoxes);

void search_region(MeshSearch& search) noexcept {
    HWY_DYNAMIC_DISPATCH(SearchRegion)(search);
}
void search_regions(std::span<MeshSearch> searches) noexcept {
    HWY_DYNAMIC_DISPATCH(SearchRegions)(searches);
}
void search_along(MeshSearch& search) noexcept {
    HWY_DYNAMIC_DISPATCH(SearchAlong)(search);
}
void search_boxes(MeshSearch& search) noexcept {
    HWY_DYNAMIC_DISPATCH(SearchBoxes)(search);
}

}  // namespace surefoot::internal

#endif
