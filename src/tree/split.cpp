// Binned surface area heuristic: Wald, "On fast Construction of SAH-based Bounding Volume Hierarchies" (2007). Of a few
// items all splits are tried, as in Wald, Boulos, Shirley, "Ray Tracing Deformable Scenes Using Dynamic Bounding Volume
// Hierarchies" (2007), section 4.1.
//
// Boxes are vectors of four floats here, of which three count. Sums, products, minima and maxima are the same on every
// machine: nothing is fused, there is no NaN among the boxes and no -0.
#include "tree/split.hpp"

#include <cstring>
#include <limits>

// Vectors whose length is known when the program runs cannot be kept in bins: those machines have NEON as well.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "tree/split.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each target
#include <hwy/highway.h>

#include "tree/four-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace surefoot::internal {
namespace HWY_NAMESPACE {

constexpr float far_away = std::numeric_limits<float>::max();
constexpr float infinite = std::numeric_limits<float>::infinity();

struct Box4 {
    HWY_INLINE Box4() noexcept {}
    HWY_INLINE Box4(const Four& low, const Four& high) noexcept : min(low), max(high) {}

    Four min;
    Four max;

    HWY_INLINE void include_min(const Four& other) noexcept { min = HWY_NAMESPACE::min(min, other); }
    HWY_INLINE void include_max(const Four& other) noexcept { max = HWY_NAMESPACE::max(max, other); }
    HWY_INLINE void include(const Four& other_min, const Four& other_max) noexcept {
        include_min(other_min);
        include_max(other_max);
    }
};

HWY_INLINE Box4 nothing() noexcept {
    return {all(far_away), all(-far_away)};
}

HWY_INLINE FloatBox to_box(const Box4& box) noexcept {
    alignas(16) float low[4];
    alignas(16) float high[4];
    store(box.min, low);
    store(box.max, high);
    return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

// Doubled; the last one is the tile.
HWY_INLINE Four middle_of(const Four& low, const Four& high) noexcept {
    return first_three(low) + high;
}

// Of four boxes, halved; infinite for one without anything in it.
HWY_INLINE Four areas(const float* extents) noexcept {
    Four x;
    Four y;
    Four z;
    load_columns(extents, x, y, z);
    return x * y + y * z + z * x;
}

// What `count` splits of one axis cost: area times count on both sides. A side without items makes NaN of it, which is
// less than nothing. Returns the first of the least.
struct Cheapest {
    float cost = infinite;
    std::uint32_t split = 0;
};

template <std::uint32_t room>
struct Sides {
    static_assert(room % 4 == 0);
    alignas(16) float left_extents[4 * room];
    alignas(16) float right_extents[4 * room];
    alignas(16) float left_counts[room];
    alignas(16) float right_counts[room];

    HWY_INLINE void set_left(std::uint32_t split, const Box4& box, float count) noexcept {
        store(box.max - box.min, left_extents + 4 * split);
        left_counts[split] = count;
    }
    HWY_INLINE void set_right(std::uint32_t split, const Box4& box, float count) noexcept {
        store(box.max - box.min, right_extents + 4 * split);
        right_counts[split] = count;
    }

    [[nodiscard]] HWY_INLINE Cheapest cheapest(std::uint32_t splits) noexcept {
        alignas(16) float costs[room];
        // What fills up the last four is not looked at, but nothing is read that was not written.
        for (std::uint32_t i = splits; i % 4 != 0; ++i) {
            set_left(i, {all(0), all(0)}, 0);
            set_right(i, {all(0), all(0)}, 0);
        }
        for (std::uint32_t i = 0; i < splits; i += 4) {
            const Four left = areas(left_extents + 4 * i) * load(left_counts + i);
            const Four right = areas(right_extents + 4 * i) * load(right_counts + i);
            store(left + right, costs + i);
        }
        Cheapest best;
        for (std::uint32_t i = 0; i < splits; ++i) {
            if (costs[i] < best.cost) best = {costs[i], i};
        }
        return best;
    }
};

HWY_INLINE ItemSummary to_summary(const FloatBox& box, const Box4& middles) noexcept {
    alignas(16) float lowest[4];
    alignas(16) float highest[4];
    store(middles.min, lowest);
    store(middles.max, highest);
    return {box, to_box(middles), lowest[3], highest[3]};
}

struct Parted {
    std::uint32_t left;
    Box4 middles[2];
};

template <typename IsLeft>
HWY_INLINE Parted part(std::span<TreeItem> items, TreeItem* scratch, const IsLeft& is_left) noexcept {
    // Every item is written to both sides, and one of them moves on: which one cannot be foreseen, so no jump asks. On
    // the other side its middle is infinitely far, which widens nothing.
    alignas(16) static constexpr float out[2][4] = {{infinite, infinite, infinite, infinite}, {0, 0, 0, 0}};
    Box4 left_middles = nothing();
    Box4 right_middles = nothing();
    std::size_t left = 0;
    std::size_t right = 0;
    for (const TreeItem& item : items) {
        const std::size_t goes_left = is_left(item) ? 1 : 0;
        const Four low = load(item.min);
        const Four high = load(item.max);
        const Four middle = middle_of(low, high);
        const Four out_left = load(out[goes_left]);
        const Four out_right = load(out[1 - goes_left]);
        left_middles.include_min(middle + out_left);
        left_middles.include_max(middle - out_left);
        right_middles.include_min(middle + out_right);
        right_middles.include_max(middle - out_right);
        store(low, items[left].min);
        store(high, items[left].max);
        store(low, scratch[right].min);
        store(high, scratch[right].max);
        left += goes_left;
        right += 1 - goes_left;
    }
    if (right != 0) std::memcpy(items.data() + left, scratch, right * sizeof(TreeItem));
    return {static_cast<std::uint32_t>(left), {left_middles, right_middles}};
}

struct Grid {
    alignas(16) float low[4] = {};
    alignas(16) float per_bin[4] = {};  // 0 where the middles have no extent

    [[nodiscard]] int bin_of(const TreeItem& item, int axis) const noexcept {
        return static_cast<int>((item.min[axis] + item.max[axis] - low[axis]) * per_bin[axis]);
    }
};

struct Split {
    int axis = -1;  // -1: there is none
    int bin = 0;    // the first bin of the right side
    FloatBox sides[2]{};
};

template <std::uint32_t bins>
Grid grid_over(const FloatBox& middles) noexcept {
    Grid grid;
    for (int axis = 0; axis < 3; ++axis) {
        grid.low[axis] = middles.min[axis];
        const float per_bin = static_cast<float>(bins) * 0.9999F / (middles.max[axis] - middles.min[axis]);
        grid.per_bin[axis] = per_bin <= far_away ? per_bin : 0;
    }
    return grid;
}

template <std::uint32_t bins>
Split best_split(std::span<const TreeItem> items, const Grid& grid) noexcept {
    struct Bin {
        alignas(16) float min[4];
        alignas(16) float max[4];
    };
    Bin box[3][bins];
    std::uint32_t count[3][bins] = {};
    for (auto& axis : box) {
        for (Bin& bin : axis) {
            store(all(far_away), bin.min);
            store(all(-far_away), bin.max);
        }
    }
    const Four origin = load(grid.low);
    const Four per_bin = load(grid.per_bin);
    for (const TreeItem& item : items) {
        const Four low = load(item.min);
        const Four high = load(item.max);
        alignas(16) std::int32_t at[4];
        store_whole((middle_of(low, high) - origin) * per_bin, at);
        for (int axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<std::uint32_t>(at[axis]) % bins;
            Bin& bin = box[axis][i];
            store(min(load(bin.min), low), bin.min);
            store(max(load(bin.max), high), bin.max);
            ++count[axis][i];
        }
    }
    Split best;
    float least = infinite;
    for (int axis = 0; axis < 3; ++axis) {
        if (!(grid.per_bin[axis] > 0)) continue;
        // Split i has the bins up to i on the left.
        Sides<bins> sides;
        Box4 left = nothing();
        Box4 right = nothing();
        std::uint32_t left_count = 0;
        std::uint32_t right_count = 0;
        for (std::uint32_t i = 0; i + 1 < bins; ++i) {
            const Bin& l = box[axis][i];
            left.include(load(l.min), load(l.max));
            left_count += count[axis][i];
            sides.set_left(i, left, static_cast<float>(left_count));
            const std::uint32_t k = bins - 1 - i;
            const Bin& r = box[axis][k];
            right.include(load(r.min), load(r.max));
            right_count += count[axis][k];
            sides.set_right(k - 1, right, static_cast<float>(right_count));
        }
        const Cheapest found = sides.cheapest(bins - 1);
        if (found.cost < least) {
            least = found.cost;
            best.axis = axis;
            best.bin = static_cast<int>(found.split) + 1;
        }
    }
    if (best.axis < 0) return best;
    Box4 sides[2] = {nothing(), nothing()};
    for (int i = 0; i < static_cast<int>(bins); ++i) {
        const Bin& bin = box[best.axis][i];
        sides[i < best.bin ? 0 : 1].include(load(bin.min), load(bin.max));
    }
    for (int i = 0; i < 2; ++i) best.sides[i] = to_box(sides[i]);
    return best;
}

template <std::uint32_t bins>
Division divide_into_bins(std::span<TreeItem> items, const FloatBox& middles, TreeItem* scratch) noexcept {
    const Grid grid = grid_over<bins>(middles);
    const Split split = best_split<bins>(items, grid);
    if (split.axis < 0) return {};
    const Parted parted =
        part(items, scratch, [&](const TreeItem& item) { return grid.bin_of(item, split.axis) < split.bin; });
    return {parted.left,
            {to_summary(split.sides[0], parted.middles[0]), to_summary(split.sides[1], parted.middles[1])}};
}

ItemSummary Summarise(std::span<const TreeItem> items) {
    Box4 box = nothing();
    Box4 middles = nothing();
    for (const TreeItem& item : items) {
        const Four low = load(item.min);
        const Four high = load(item.max);
        const Four middle = middle_of(low, high);
        box.include(low, high);
        middles.include(middle, middle);
    }
    return to_summary(to_box(box), middles);
}

Division DivideByArea(std::span<TreeItem> items, const FloatBox& middles, TreeItem* scratch) {
    constexpr std::size_t few = 32;
    return items.size() <= few ? divide_into_bins<8>(items, middles, scratch)
                               : divide_into_bins<16>(items, middles, scratch);
}

Division halves_at(std::span<const TreeItem> items, std::uint32_t left) noexcept {
    return {left, {Summarise(items.first(left)), Summarise(items.subspan(left))}};
}

template <std::uint32_t room>
Division divide_few(std::span<TreeItem> items) noexcept {
    const auto count = static_cast<std::uint32_t>(items.size());
    std::uint32_t order[3][room];
    std::uint32_t best_axis = 0;
    Cheapest best;
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        // An item's rank is how many middles come before its own; of equal ones the earlier item's.
        float middle[room];
        std::uint32_t rank[room];
        for (std::uint32_t i = 0; i < count; ++i) {
            middle[i] = items[i].min[axis] + items[i].max[axis];
            std::uint32_t before = 0;
            for (std::uint32_t k = 0; k < i; ++k) {
                const std::uint32_t is_before = middle[k] <= middle[i] ? 1 : 0;
                before += is_before;
                rank[k] += 1 - is_before;
            }
            rank[i] = before;
        }
        for (std::uint32_t i = 0; i < count; ++i) order[axis][rank[i]] = i;
        // Split i has the first i + 1 on the left.
        Sides<room> sides;
        Box4 left = nothing();
        Box4 right = nothing();
        for (std::uint32_t i = 0; i + 1 < count; ++i) {
            const TreeItem& l = items[order[axis][i]];
            left.include(load(l.min), load(l.max));
            sides.set_left(i, left, static_cast<float>(i + 1));
            const std::uint32_t k = count - 1 - i;
            const TreeItem& r = items[order[axis][k]];
            right.include(load(r.min), load(r.max));
            sides.set_right(k - 1, right, static_cast<float>(i + 1));
        }
        const Cheapest found = sides.cheapest(count - 1);
        if (found.cost < best.cost) {
            best = found;
            best_axis = axis;
        }
    }
    if (!(best.cost < infinite)) return {};
    TreeItem sorted[room];
    for (std::uint32_t i = 0; i < count; ++i) sorted[i] = items[order[best_axis][i]];
    std::memcpy(items.data(), sorted, items.size_bytes());
    return halves_at(items, best.split + 1);
}

Division DivideFewByArea(std::span<TreeItem> items) {
    return items.size() <= 4 ? divide_few<4>(items) : divide_few<most_to_sort>(items);
}

Division DivideByTile(std::span<TreeItem> items, float highest, TreeItem* scratch) {
    return halves_at(items, part(items, scratch, [&](const TreeItem& item) { return item.max[3] <= highest; }).left);
}

}  // namespace HWY_NAMESPACE
}  // namespace surefoot::internal
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace surefoot::internal {

HWY_EXPORT(Summarise);
HWY_EXPORT(DivideByArea);
HWY_EXPORT(DivideFewByArea);
HWY_EXPORT(DivideByTile);

ItemSummary summarise(std::span<const TreeItem> items) noexcept {
    return HWY_DYNAMIC_DISPATCH(Summarise)(items);
}
Division divide_by_area(std::span<TreeItem> items, const FloatBox& middles, TreeItem* scratch) noexcept {
    return HWY_DYNAMIC_DISPATCH(DivideByArea)(items, middles, scratch);
}
Division divide_few_by_area(std::span<TreeItem> items) noexcept {
    return HWY_DYNAMIC_DISPATCH(DivideFewByArea)(items);
}
Division divide_by_tile(std::span<TreeItem> items, float highest, TreeItem* scratch) noexcept {
    return HWY_DYNAMIC_DISPATCH(DivideByTile)(items, highest, scratch);
}

}  // namespace surefoot::internal

#endif
