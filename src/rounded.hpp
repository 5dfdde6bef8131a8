// Rounding to float and back. A cast should do, but g++ 12 drops it: where two casts double -> float -> double stand
// side by side, its vectoriser makes one vector of each, and then takes two conversions between vectors of two for none
// at all. So the float is shown to the compiler as something that an unknown instruction may have changed.
#pragma once

#include <bit>
#include <cstdint>

namespace surefoot::internal {

/// The double nearest to `value` that is a float. Requires: within the range of floats.
[[nodiscard]] inline double rounded_to_float(double value) noexcept {
    auto rounded = static_cast<float>(value);
#if defined(__GNUC__) && !defined(__clang__)
#if defined(__x86_64__)
    asm("" : "+x"(rounded));
#elif defined(__aarch64__)
    asm("" : "+w"(rounded));
#else
    asm("" : "+m"(rounded));
#endif
#endif
    return rounded;
}

/// The next float below a finite one.
[[nodiscard]] inline float next_below(float value) noexcept {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    if (value == 0) return std::bit_cast<float>(0x80000001U);
    return std::bit_cast<float>(value > 0 ? bits - 1 : bits + 1);
}

/// The largest float that is not above, and the smallest that is not below `value`. Requires: within the range of
/// floats.
[[nodiscard]] inline float float_at_most(double value) noexcept {
    const auto nearest = static_cast<float>(value);
    return static_cast<double>(nearest) <= value ? nearest : next_below(nearest);
}
[[nodiscard]] inline float float_at_least(double value) noexcept {
    return -float_at_most(-value);
}

}  // namespace surefoot::internal
