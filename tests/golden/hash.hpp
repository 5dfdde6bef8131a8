// The hash of what the library answers.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>

#include <surefoot/surefoot.hpp>

namespace golden {

// Field by field, so that padding never counts, and bit by bit, so that -0 is not 0.
class Hash {
public:
    Hash& operator<<(std::uint64_t word) {
        state_ = (std::rotl(state_, 23) ^ word) * 0x9fb21c651e98df25u;
        state_ ^= state_ >> 29;
        return *this;
    }
    Hash& operator<<(double value) {
        std::uint64_t word = 0;
        std::memcpy(&word, &value, sizeof word);
        return *this << word;
    }
    Hash& operator<<(const surefoot::dvec3& v) { return *this << v.x << v.y << v.z; }
    Hash& operator<<(const surefoot::Hit& hit) {
        return *this << hit.t << hit.point << hit.normal << std::uint64_t{hit.triangle} << std::uint64_t{hit.surface}
                     << std::uint64_t{hit.body} << static_cast<std::uint64_t>(hit.feature)
                     << static_cast<std::uint64_t>(hit.status) << static_cast<std::uint64_t>(hit.started_inside);
    }
    Hash& operator<<(const surefoot::Overlap& found) {
        return *this << found.point << found.normal << found.depth << std::uint64_t{found.triangle}
                     << std::uint64_t{found.surface} << std::uint64_t{found.body}
                     << static_cast<std::uint64_t>(found.feature) << static_cast<std::uint64_t>(found.status);
    }
    Hash& operator<<(const surefoot::PairHit& hit) {
        return *this << hit.t << hit.point << hit.normal << static_cast<std::uint64_t>(hit.status)
                     << static_cast<std::uint64_t>(hit.started_inside);
    }
    Hash& operator<<(const surefoot::PairOverlap& found) {
        return *this << found.point << found.normal << found.depth << static_cast<std::uint64_t>(found.status);
    }
    Hash& operator<<(const surefoot::MarchHit& met) {
        return *this << met.hit << met.position << std::uint64_t{met.step};
    }
    template <typename T>
    Hash& operator<<(const std::optional<T>& answer) {
        *this << std::uint64_t{answer.has_value()};
        if (answer) {
            *this << *answer;
            ++hits_;
        }
        return *this;
    }

    std::uint64_t value() const { return state_; }
    int hits() const { return hits_; }

private:
    std::uint64_t state_ = 0x243f6a8885a308d3u;
    int hits_ = 0;
};

}  // namespace golden
