// Rounding to float and back. A cast should do, but g++ 12 drops it: where two casts double -> float -> double stand
// side by side, its vectoriser makes one vector of each, and then takes two conversions between vectors of two for none
// at all. So the float is shown to the compiler as something that an unknown instruction may have changed.
#pragma once

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

}  // namespace surefoot::internal
