// Numbers that look random.
#pragma once

#include <cstdint>

namespace surefoot::navigation {

/// The next of a row (SplitMix64).
[[nodiscard]] inline std::uint64_t next_random(std::uint64_t& state) {
    state += 0x9e3779b97f4a7c15U;
    std::uint64_t bits = state;
    bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31);
}

/// The same in [0, 1).
[[nodiscard]] inline double next_share(std::uint64_t& state) {
    return static_cast<double>(next_random(state) >> 11) * 0x1p-53;
}

}  // namespace surefoot::navigation
