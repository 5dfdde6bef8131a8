// Triangles on their way from the leaves of a tree into the float filter, and what the filter leaves of them on its way
// out. Included once for each SIMD target.
#if defined(SUREFOOT_BATCH_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SUREFOOT_BATCH_INL_HPP
#undef SUREFOOT_BATCH_INL_HPP
#else
#define SUREFOOT_BATCH_INL_HPP
#endif

#include <algorithm>
#include <bit>
#include <cmath>
#include <hwy/highway.h>

#include "kernels/mesh_search.hpp"
#include "kernels/triangle_filter-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace surefoot::internal {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t most_candidates = 128;

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

// The corners of eight triangles of a leaf, or of as many as one register has lanes, from slot `lane` on.
class Corners {
public:
    Corners(const LeafBlock& block, const float (&from)[3]) noexcept : block_(block), from_(from) {}

    [[nodiscard]] HWY_INLINE Vec3 at(int corner, std::size_t lane) const noexcept {
        const hn::Rebind<std::int32_t, FilterTag> ints;
        const hn::Rebind<std::uint8_t, FilterTag> bytes;
        // Behind the last triangle lie other bytes of the leaf, or the padding.
        const auto named = hn::PromoteTo(ints, hn::LoadU(bytes, block_.corner(corner) + lane));
        const auto is_sound = hn::Lt(named, hn::Set(ints, static_cast<std::int32_t>(block_.vertices)));
        const auto index = hn::IfThenElseZero(is_sound, named);
        return {along(0, index), along(1, index), along(2, index)};
    }

private:
    template <class Ints>
    [[nodiscard]] HWY_INLINE Floats along(int axis, Ints index) const noexcept {
        const FilterTag d;
        const float* const table = block_.axis(axis);
#if HWY_TARGET <= HWY_AVX2 && HWY_TARGET >= HWY_AVX3_DL
        // A leaf has at most 24 vertices: three registers, looked up, which is quicker than gathering.
        const hn::Rebind<std::int32_t, FilterTag> ints;
        const auto indices = hn::IndicesFromVec(d, hn::And(index, hn::Set(ints, 7)));
        const auto within = [&](int part) HWY_ATTR {
            return hn::TableLookupLanes(hn::LoadU(d, table + part * tree_width), indices);
        };
        const auto is_behind = [&](int last) HWY_ATTR { return hn::RebindMask(d, hn::Gt(index, hn::Set(ints, last))); };
        auto found = hn::IfThenElse(is_behind(7), within(1), within(0));
        if (block_.vertices > 2 * tree_width) found = hn::IfThenElse(is_behind(15), within(2), found);
#else
        const auto found = hn::GatherIndex(d, table, index);
#endif
        return hn::Sub(found, hn::Set(d, from_[axis]));
    }

    const LeafBlock& block_;
    const float (&from_)[3];
};

HWY_INLINE float size_of(const float (&from)[3]) noexcept {
    return std::max(std::abs(from[0]), std::max(std::abs(from[1]), std::abs(from[2])));
}

// The corners of triangles out of several leaves, packed, relative to `from`, so that the filter's lanes are full. A
// few triangles of each leaf are wanted, so they are copied one by one.
class Batch {
public:
    explicit Batch(const MeshSearch& search) noexcept : search_(search) {}

    // Adds the triangles of a leaf whose bits are set.
    HWY_INLINE void add(const LeafBlock& block, std::uint32_t word, std::uint32_t bits, const float (&from)[3],
                        Outbox& out) noexcept {
        from_size_ = std::max(from_size_, size_of(from));
        while (bits != 0) {
            const auto slot = static_cast<std::uint32_t>(std::countr_zero(bits));
            bits &= bits - 1;
            for (int i = 0; i < 3; ++i) {
                const std::uint32_t named = block.corner(i)[slot];
                const std::uint32_t index = named < block.vertices ? named : 0;
                for (int axis = 0; axis < 3; ++axis) corners_[i][axis][count_] = block.axis(axis)[index] - from[axis];
            }
            places_[count_] = word << 3 | slot;
            if (++count_ == tree_width) filter(out);
        }
    }

    // Filters those that have not been.
    HWY_NOINLINE void filter(Outbox& out) noexcept {
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
        std::uint32_t bits = survivors<false>(search_.filter, load, count_, from_size_, search_.limit, times);
        while (bits != 0) {
            const int lane = std::countr_zero(bits);
            bits &= bits - 1;
            out.add({times[lane], places_[lane]});
        }
        count_ = 0;
    }

private:
    const MeshSearch& search_;
    std::size_t count_ = 0;
    float from_size_ = 0;
    std::uint32_t places_[tree_width];
    alignas(32) float corners_[3][3][tree_width];
};

}  // namespace HWY_NAMESPACE
}  // namespace surefoot::internal
HWY_AFTER_NAMESPACE();

#endif
