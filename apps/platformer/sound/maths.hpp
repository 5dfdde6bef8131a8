/// The few functions that sound is made of, by our own arithmetic: so that every build makes the same samples.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace surefoot::sound {

inline constexpr int rate = 44100;  ///< samples a second, everywhere

/// sin(2 pi turns), within 1e-7. [turns: any number whose magnitude is below 1e15]
[[nodiscard]] inline double sine(double turns) {
    turns -= double(static_cast<std::int64_t>(turns + (turns < 0 ? -0.5 : 0.5)));
    if (turns > 0.25) turns = 0.5 - turns;
    if (turns < -0.25) turns = -0.5 - turns;
    const double x = 2 * std::numbers::pi * turns, x2 = x * x;
    // Taylor's series: the first term left out is 6e-8 at a quarter turn.
    double sum = -1.0 / 39916800;
    sum = sum * x2 + 1.0 / 362880;
    sum = sum * x2 - 1.0 / 5040;
    sum = sum * x2 + 1.0 / 120;
    sum = sum * x2 - 1.0 / 6;
    return x + x * x2 * sum;
}

/// 2 to the power of x, within 3e-10 of its value. [-1000 to 1000]
[[nodiscard]] inline double power_of_two(double x) {
    const int whole = static_cast<int>(x + (x < 0 ? -0.5 : 0.5));
    const double e = (x - whole) * std::numbers::ln2;
    double sum = 1.0 / 40320;
    for (const double factor : {1.0 / 5040, 1.0 / 720, 1.0 / 120, 1.0 / 24, 1.0 / 6, 0.5, 1.0, 1.0}) {
        sum = sum * e + factor;
    }
    return std::ldexp(sum, whole);
}

/// The factor by which so many decibels multiply.
[[nodiscard]] inline double decibels(double db) {
    return power_of_two(db * 0.16609640474436813);
}

/// What a value is multiplied by at every sample to fall to a half in so many seconds. [above 0]
[[nodiscard]] inline double half_in(double seconds) {
    return power_of_two(-1 / (seconds * rate));
}

/// The frequency of a pitch in semitones, 69 being the a of 440 Hz, 60 the c below. [Hz]
[[nodiscard]] inline double hertz(double pitch) {
    return 440 * power_of_two((pitch - 69) / 12);
}

[[nodiscard]] constexpr double mix(double a, double b, double share) {
    return a + (b - a) * share;
}

}  // namespace surefoot::sound
