/// Sound as numbers: one channel, 44,100 a second, from -1 to 1.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "platformer/sound/maths.hpp"

namespace surefoot::sound {

using Samples = std::vector<float>;

[[nodiscard]] inline std::size_t samples_in(double seconds) {
    return static_cast<std::size_t>(seconds * rate + 0.5);
}

/// So many seconds of what `next(t)` says, t being the time in seconds. It is asked once a sample, in order.
template <typename Next>
[[nodiscard]] Samples generate(double seconds, Next&& next) {
    Samples made(samples_in(seconds));
    for (std::size_t i = 0; i < made.size(); ++i) made[i] = static_cast<float>(next(double(i) / rate));
    return made;
}

/// Adds a sound to another, from so many seconds on; makes room for it.
void add(Samples& to, std::span<const float> from, double at = 0, double gain = 1);

/// Brings a sound up from nothing and back to it within so many seconds at its ends, so that they do not click.
void fade_ends(Samples& samples, double in, double out);

/// Takes away what is below hearing and would only push the membrane: the mean above all.
void remove_rumble(Samples& samples, double below = 30);

/// Cuts off the end from where nothing is louder than this share of the peak.
void trim(Samples& samples, double share = 0.002);

/// Makes the loudest twentieth of a second this loud (RMS, dB below full scale), unless a peak would pass `highest`.
void set_loudness(Samples& samples, double db, double highest = 0.9);

/// Linear up to 0.7, then bends so that nothing passes 1.
[[nodiscard]] double soft_limit(double x);

[[nodiscard]] std::int16_t to_16_bits(double x);

}  // namespace surefoot::sound
