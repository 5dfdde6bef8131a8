/// Numbers that look random, out of a state of eight bytes that a game keeps, copies and goes back to with the rest of
/// its state. The same seed gives the same numbers on every machine.
#pragma once

#include <cstdint>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// The next of a row of numbers. At first `state` is the seed: any number, 0 too; the row repeats after 2^64 numbers.
/// For play, not for secrets: who sees one number knows all that follow.
[[nodiscard]] constexpr std::uint64_t next_random(std::uint64_t& state) noexcept {
    // SplitMix64: Steele, Lea and Flood, Fast Splittable Pseudorandom Number Generators (2014).
    state += 0x9e3779b97f4a7c15U;
    std::uint64_t bits = state;
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31U);
}

/// The same as a share [0, 1), of 53 bits. A range is made of it by the caller, whose compiler decides how that rounds.
[[nodiscard]] constexpr double next_share(std::uint64_t& state) noexcept {
    return static_cast<double>(next_random(state) >> 11U) * 0x1p-53;
}

}  // namespace v0
}  // namespace surefoot
