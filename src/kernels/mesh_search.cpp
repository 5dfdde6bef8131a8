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

#include "kernels/boxes-inl.hpp"
#include "kernels/triangle_filter-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace surefoot::internal {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t most_candidates = 128;
constexpr std::size_t most_leaves = 64;
// Each level leaves at most seven siblings behind.
constexpr std::size_t stack_size = 7 * (deepest_tree + 1) + tree_width;

// Hands candidates on when there are many, and at the end.
class Outbox {
public:
    explicit Outbox(MeshSearch& search) noexcept : search_(search) {}
    void add(const Candidate& candidate) noexcept {
        if (count_ == most_candidates) flush();
        candidates_[count_++] = candidate;
    }
    void flush() noexcept {
        if (count_ == 0) return;
        search_.limit = search_.take(search_.context, {candidates_, count_});
        count_ = 0;
    }

    // Hands on, one by one and the earliest first, those that may begin by `until`: what lies behind them cannot come
    // before them.
    void settle(float until) noexcept {
        while (count_ > 0) {
            std::size_t next = 0;
            for (std::size_t i = 1; i < count_; ++i) {
                if (candidates_[i].t < candidates_[next].t) next = i;
            }
            if (candidates_[next].t > until) return;
            Candidate candidate = candidates_[next];
            candidates_[next] = candidates_[--count_];
            if (candidate.t <= search_.limit) search_.limit = search_.take(search_.context, {&candidate, 1});
        }
    }

private:
    MeshSearch& search_;
    std::size_t count_ = 0;
    Candidate candidates_[most_candidates];
};

// The corners of up to eight triangles, relative to `from`, on their way into the filter.
class Batch {
public:
    Batch(const MeshSearch& search) noexcept : search_(search) {}

    // Returns true when it is full.
    HWY_INLINE bool add(const LeafBlock& block, std::uint32_t slot, std::uint32_t place,
                        const float (&from)[3]) noexcept {
        for (int i = 0; i < 3; ++i) {
            const std::uint32_t named = block.corner(i)[slot];
            const std::uint32_t index = named < block.vertices ? named : 0;
            for (int axis = 0; axis < 3; ++axis) corners_[i][axis][count_] = block.axis(axis)[index] - from[axis];
        }
        from_size_ = std::max(from_size_, std::max(std::abs(from[0]), std::max(std::abs(from[1]), std::abs(from[2]))));
        places_[count_] = place;
        return ++count_ == tree_width;
    }

    HWY_INLINE void filter(Outbox& out) noexcept {
        if (count_ == 0) return;
        for (std::size_t i = count_; i < tree_width; ++i) {
            for (auto& corner : corners_) {
                for (auto& axis : corner) axis[i] = axis[0];
            }
        }
        float times[tree_width];
        const FilterTag d;
        const auto load = [&](int i, std::size_t lane) HWY_ATTR {
            return Vec3{hn::Load(d, corners_[i][0] + lane), hn::Load(d, corners_[i][1] + lane),
                        hn::Load(d, corners_[i][2] + lane)};
        };
        std::uint32_t bits = survivors<false>(search_.filter, load, from_size_, search_.limit, times);
        bits &= (1U << count_) - 1;
        while (bits != 0) {
            const int lane = std::countr_zero(bits);
            bits &= bits - 1;
            out.add({times[lane], places_[lane]});
        }
        count_ = 0;
        from_size_ = 0;
    }

private:
    const MeshSearch& search_;
    std::size_t count_ = 0;
    float from_size_ = 0;
    std::uint32_t places_[tree_width];
    alignas(32) float corners_[3][3][tree_width];
};

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

// Calls `visit(leaf word)` for the leaves whose boxes meet the region.
template <class Visit>
HWY_INLINE void visit_region(MeshSearch& search, const Visit& visit) noexcept {
    const MeshView& view = *search.view;
    if (view.nodes.empty()) return;
    const FloatRegion region = region_about(search.region, {});
    std::uint32_t stack[stack_size];
    std::size_t size = 0;
    stack[size++] = 0;
    // Every node has one parent, so no more than all of them can be opened.
    std::size_t left = view.nodes.size();
    while (size > 0) {
        const std::uint32_t index = stack[--size];
        const WideNode& node = view.nodes[index];
        ++search.nodes;
        if (left-- == 0) {
            search.overflowed = true;
            return;
        }
        std::uint32_t bits = children_in(node, region);
        while (bits != 0) {
            const std::uint32_t child = node.child[std::countr_zero(bits)];
            bits &= bits - 1;
            if ((child & leaf_bit) != 0) {
                prefetch_leaf(view, child & ~leaf_bit);
                visit(child & ~leaf_bit);
            } else if (child > index && child < view.nodes.size() && size < stack_size) {
                hwy::Prefetch(&view.nodes[child]);
                stack[size++] = child;
            }
        }
    }
}

void SearchRegion(MeshSearch& search) {
    const MeshView& view = *search.view;
    Outbox out(search);
    Batch batch(search);
    std::uint32_t leaves[most_leaves];
    std::size_t count = 0;
    std::uint32_t tile = ~0U;
    FloatRegion region{};
    float from[3] = {};
    const auto look_into_leaves = [&]() HWY_ATTR {
        for (std::size_t i = 0; i < count; ++i) {
            const LeafBlock block = view.leaf(leaves[i]);
            if (block.count == 0) continue;
            if (block.tile != tile) {
                tile = block.tile;
                region = region_about(search.region, view.origin_of(tile));
                from_about(search, view.origin_of(tile), from);
            }
            std::uint32_t bits = triangles_in(block, region);
            while (bits != 0) {
                const auto slot = static_cast<std::uint32_t>(std::countr_zero(bits));
                bits &= bits - 1;
                if (batch.add(block, slot, leaves[i] << 3 | slot, from)) batch.filter(out);
            }
        }
        count = 0;
    };
    visit_region(search, [&](std::uint32_t word) HWY_ATTR {
        if (count == most_leaves) look_into_leaves();
        leaves[count++] = word;
    });
    look_into_leaves();
    batch.filter(out);
    out.flush();
}

void SearchBoxes(MeshSearch& search) {
    const MeshView& view = *search.view;
    Outbox out(search);
    visit_region(search, [&](std::uint32_t word) HWY_ATTR {
        const LeafBlock block = view.leaf(word);
        if (block.count == 0) return;
        std::uint32_t bits = triangles_in(block, region_about(search.region, view.origin_of(block.tile)));
        while (bits != 0) {
            const auto slot = static_cast<std::uint32_t>(std::countr_zero(bits));
            bits &= bits - 1;
            out.add({0, word << 3 | slot});
        }
    });
    out.flush();
}

// All triangles of a leaf at once.
HWY_INLINE void filter_leaf(const MeshSearch& search, const LeafBlock& block, std::uint32_t word,
                            const float (&from)[3], Outbox& out) noexcept {
    const FilterTag d;
    const hn::Rebind<std::int32_t, FilterTag> ints;
    const hn::Rebind<std::uint8_t, FilterTag> bytes;
    const auto load = [&](int i, std::size_t lane) HWY_ATTR {
        // Behind the last triangle lie other bytes of the leaf, or the padding.
        const auto named = hn::PromoteTo(ints, hn::LoadU(bytes, block.corner(i) + lane));
        const auto is_sound = hn::Lt(named, hn::Set(ints, static_cast<std::int32_t>(block.vertices)));
        const auto index = hn::IfThenElseZero(is_sound, named);
        const auto at = [&](int axis) HWY_ATTR {
            return hn::Sub(hn::GatherIndex(d, block.axis(axis), index), hn::Set(d, from[axis]));
        };
        return Vec3{at(0), at(1), at(2)};
    };
    const float from_size = std::max(std::abs(from[0]), std::max(std::abs(from[1]), std::abs(from[2])));
    float times[tree_width];
    std::uint32_t bits = survivors<true>(search.filter, load, from_size, search.limit, times);
    bits &= (1U << block.count) - 1;
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
