/// "Why did I stop?" A trace is a sink of plain records into memory that you own: what a query tried, what it met and
/// what it decided. Nothing is allocated, and a query without a trace pays nothing for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// What the analytic test made of one candidate.
enum class Verdict : std::uint8_t {
    separates,  ///< this plane keeps shape and triangle apart over the whole motion: no hit, and this is the proof
    enters,     ///< the motion crosses this plane inwards, at `t`; the last of these is the answer
    leaves,     ///< the motion crosses this plane outwards, at `t`
    inside,     ///< the motion is behind this plane all along: it decides nothing
    contact,    ///< at `from` they touch or overlap, here the least; whether the motion goes deeper is decided exactly
    decided,    ///< the final answer of the query
};

/// One candidate: a plane between the shape and the triangle, proposed by one feature of the triangle.
struct TraceRecord {
    dvec3 normal{0, 0, 0};            ///< of the plane, in the world, from the triangle towards the shape; unit
    double gap_from = 0;              ///< signed gap along `normal` at `from` [m]
    double gap_to = 0;                ///< signed gap along `normal` at `to` [m]
    double t = 0;                     ///< when the gap closes or opens, if it does
    std::uint32_t triangle = 0;       ///< which triangle
    std::uint8_t feature_index = 0;   ///< which face, edge (0: ab, 1: bc, 2: ca) or vertex (0: a, 1: b, 2: c)
    Feature feature = Feature::face;  ///< the kind of feature that proposed the plane
    Verdict verdict = Verdict::inside;
    std::uint8_t reserved = 0;
};

static_assert(std::is_trivially_copyable_v<TraceRecord> && sizeof(TraceRecord) == 56);

/// Writes records into the caller's memory until it is full, and counts the ones that found no room.
class Trace {
public:
    explicit Trace(std::span<TraceRecord> room) noexcept : room_(room) {}

    void push(const TraceRecord& record) noexcept {
        if (count_ < room_.size()) room_[count_] = record;
        ++count_;
    }

    [[nodiscard]] std::span<const TraceRecord> records() const noexcept {
        return room_.first(count_ < room_.size() ? count_ : room_.size());
    }

    /// The same, to be changed by whoever owns the trace.
    [[nodiscard]] std::span<TraceRecord> records() noexcept {
        return room_.first(count_ < room_.size() ? count_ : room_.size());
    }

    /// How many records found no room.
    [[nodiscard]] std::size_t dropped() const noexcept { return count_ < room_.size() ? 0 : count_ - room_.size(); }

    void clear() noexcept { count_ = 0; }

private:
    std::span<TraceRecord> room_;
    std::size_t count_ = 0;
};

}  // namespace v0
}  // namespace surefoot
