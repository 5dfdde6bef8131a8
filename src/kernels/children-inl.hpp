// The children of nodes that a search has chosen, on their way to being opened. Which of eight are chosen is as good as
// random, so a branch for each would be guessed wrong half the time; they are packed by the register instead. Included
// once for each SIMD target.
#if defined(SUREFOOT_CHILDREN_INL_HPP) == defined(HWY_TARGET_TOGGLE)
#ifdef SUREFOOT_CHILDREN_INL_HPP
#undef SUREFOOT_CHILDREN_INL_HPP
#else
#define SUREFOOT_CHILDREN_INL_HPP
#endif

#include <bit>
#include <cstdint>
#include <hwy/highway.h>
#include <span>

#include "tree/binary_tree.hpp"
#include "tree/view.hpp"

HWY_BEFORE_NAMESPACE();
namespace surefoot::internal {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// Each level leaves at most seven siblings behind.
constexpr std::size_t stack_size = 7 * (deepest_tree + 1) + tree_width;

#if HWY_TARGET == HWY_AVX2
// For each choice of eight, which they are, first to last.
struct Packed {
    std::uint8_t order[256][tree_width] = {};
    constexpr Packed() noexcept {
        for (unsigned bits = 0; bits < 256; ++bits) {
            int count = 0;
            for (unsigned i = 0; i < tree_width; ++i) {
                if ((bits >> i & 1) != 0) order[bits][count++] = static_cast<std::uint8_t>(i);
            }
        }
    }
};
constexpr Packed packed;
#endif

// The chosen ones of a node's children (a bit each), leaves apart from nodes.
class ChosenChildren {
public:
    HWY_INLINE ChosenChildren(const WideNode& node, std::uint32_t index, std::size_t nodes, std::uint32_t bits) noexcept
        : node_(node) {
        const hn::CappedTag<std::int32_t, tree_width> d;
        std::uint32_t leaves = 0;
        std::uint32_t sound = 0;
        for (std::size_t i = 0; i < tree_width; i += hn::Lanes(d)) {
            const auto child = hn::LoadU(d, reinterpret_cast<const std::int32_t*>(node.child) + i);
            // A child lies behind its parent and within the array, unless the bytes are nobody's.
            const auto is_sound = hn::And(hn::Gt(child, hn::Set(d, static_cast<std::int32_t>(index))),
                                          hn::Lt(child, hn::Set(d, static_cast<std::int32_t>(nodes))));
            leaves |= bits_of(d, hn::Lt(child, hn::Zero(d))) << i;
            sound |= bits_of(d, is_sound) << i;
        }
        leaves_ = bits & leaves;
        nodes_ = bits & ~leaves & sound;
    }

    // They write up to a whole node's worth, and return how many of those count.
    HWY_INLINE std::size_t put_leaves(std::uint32_t* room) const noexcept { return put(leaves_, room, ~leaf_bit); }
    HWY_INLINE std::size_t put_nodes(std::uint32_t* room) const noexcept { return put(nodes_, room, ~0U); }

private:
    template <class D, class Mask>
    static HWY_INLINE std::uint32_t bits_of(D d, Mask mask) noexcept {
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(d, mask, bytes);
        return bytes[0] & ((1U << hn::Lanes(d)) - 1);
    }

    HWY_INLINE std::size_t put(std::uint32_t bits, std::uint32_t* room, std::uint32_t keep) const noexcept {
#if HWY_TARGET <= HWY_AVX2 && HWY_TARGET >= HWY_AVX3_DL
        const hn::FixedTag<std::uint32_t, tree_width> d;
        const auto child = hn::And(hn::LoadU(d, node_.child), hn::Set(d, keep));
#if HWY_TARGET <= HWY_AVX3
        const auto chosen = static_cast<std::uint8_t>(bits);
        hn::CompressBitsStore(child, &chosen, d, room);
#else
        // Highway 1.0.3 keeps its table of such permutations where g++ copies it to the stack at each use.
        const hn::Rebind<std::uint8_t, decltype(d)> bytes;
        const auto order = hn::PromoteTo(hn::Rebind<std::int32_t, decltype(d)>(), hn::LoadU(bytes, packed.order[bits]));
        hn::StoreU(hn::TableLookupLanes(child, hn::IndicesFromVec(d, order)), d, room);
#endif
        return static_cast<std::size_t>(std::popcount(bits));
#else
        std::size_t count = 0;
        while (bits != 0) {
            room[count++] = node_.child[std::countr_zero(bits)] & keep;
            bits &= bits - 1;
        }
        return count;
#endif
    }

    const WideNode& node_;
    std::uint32_t leaves_;
    std::uint32_t nodes_;
};

// Nodes to be opened. First in, first out, so that what was prefetched has time to arrive; when many wait, the last
// first, so that there is a bound on how many.
class NodeQueue {
public:
    NodeQueue() noexcept {}  // what is not written is not read
    HWY_INLINE void push_root() noexcept { nodes_[end_++] = 0; }
    [[nodiscard]] HWY_INLINE bool is_empty() const noexcept { return begin_ == end_; }

    [[nodiscard]] HWY_INLINE bool has_overflowed() const noexcept { return has_overflowed_; }
    HWY_INLINE void clear() noexcept { begin_ = end_ = 0; }

    HWY_INLINE std::uint32_t pop() noexcept {
        if (end_ - begin_ > most_waiting) return nodes_[--end_];
        const std::uint32_t node = nodes_[begin_++];
        if (begin_ == end_) begin_ = end_ = 0;
        return node;
    }

    // Returns those that were added. None are, and it says so, where more wait than in any tree that was built: one of
    // bytes that nobody wrote may be deeper.
    HWY_INLINE std::span<const std::uint32_t> add(const ChosenChildren& children) noexcept {
        if (end_ + tree_width > room) {
            for (std::size_t i = begin_; i < end_; ++i) nodes_[i - begin_] = nodes_[i];
            end_ -= begin_;
            begin_ = 0;
            has_overflowed_ = end_ + tree_width > room;
            if (has_overflowed_) return {};
        }
        const std::size_t count = children.put_nodes(nodes_ + end_);
        end_ += count;
        return {nodes_ + end_ - count, count};
    }

private:
    static constexpr std::size_t most_waiting = 256;
    static constexpr std::size_t room = 2 * most_waiting + stack_size;

    std::size_t begin_ = 0;
    std::size_t end_ = 0;
    bool has_overflowed_ = false;
    std::uint32_t nodes_[room];
};

// Leaves to be looked into, once the nodes are done with.
class LeafList {
public:
    LeafList() noexcept {}  // what is not written is not read
    HWY_INLINE std::span<const std::uint32_t> add(const ChosenChildren& children) noexcept {
        const std::size_t count = children.put_leaves(leaves_ + count_);
        count_ += count;
        return {leaves_ + count_ - count, count};
    }
    [[nodiscard]] HWY_INLINE bool is_full() const noexcept { return count_ + tree_width > room; }
    [[nodiscard]] HWY_INLINE std::span<const std::uint32_t> get() const noexcept { return {leaves_, count_}; }
    HWY_INLINE void clear() noexcept { count_ = 0; }

private:
    static constexpr std::size_t room = 64;

    std::size_t count_ = 0;
    std::uint32_t leaves_[room];
};

}  // namespace HWY_NAMESPACE
}  // namespace surefoot::internal
HWY_AFTER_NAMESPACE();

#endif
