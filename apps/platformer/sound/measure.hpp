/// What can be said about a sound in numbers.
#pragma once

#include <span>

namespace surefoot::sound {

/// The largest magnitude.
[[nodiscard]] double peak(std::span<const float> samples);

/// Root of the mean square.
[[nodiscard]] double rms(std::span<const float> samples);

/// The RMS of the loudest stretch of so many seconds; a shorter sound counts as followed by silence.
[[nodiscard]] double loudest(std::span<const float> samples, double seconds);

/// The largest step from one sample to the next.
[[nodiscard]] double steepest(std::span<const float> samples);

/// How much of a frequency there is: the amplitude of a sine of it, through a Hann window. [Hz]
[[nodiscard]] double amount_of(std::span<const float> samples, double frequency);

/// The centre of the spectrum: how bright it is. [Hz]
[[nodiscard]] double brightness(std::span<const float> samples);

/// The strongest frequency between two, found in steps of a tenth of a semitone. [Hz]
[[nodiscard]] double strongest_frequency(std::span<const float> samples, double low = 80, double high = 5000);

}  // namespace surefoot::sound
