#include "platformer/sound/measure.hpp"

#include <algorithm>
#include <cmath>

#include "platformer/sound/maths.hpp"

namespace surefoot::sound {

double peak(std::span<const float> samples) {
    double highest = 0;
    for (const float sample : samples) highest = std::max(highest, std::abs(double(sample)));
    return highest;
}

double rms(std::span<const float> samples) {
    double sum = 0;
    for (const float sample : samples) sum += double(sample) * sample;
    return samples.empty() ? 0 : std::sqrt(sum / double(samples.size()));
}

double loudest(std::span<const float> samples, double seconds) {
    const auto window = static_cast<std::size_t>(seconds * rate);
    double sum = 0, highest = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        sum += double(samples[i]) * samples[i];
        if (i >= window) sum -= double(samples[i - window]) * samples[i - window];
        highest = std::max(highest, sum);
    }
    return std::sqrt(highest / double(window));
}

double steepest(std::span<const float> samples) {
    double most = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        most = std::max(most, std::abs(double(samples[i]) - samples[i - 1]));
    }
    return most;
}

double amount_of(std::span<const float> samples, double frequency) {
    // A vector that turns by one step a sample: two products instead of two sines.
    const double size = double(samples.size()), step = frequency / rate, turn = 1 / size;
    const double c = sine(step + 0.25), s = sine(step), wc = sine(turn + 0.25), ws = sine(turn);
    double x = 1, y = 0, wx = 1, wy = 0, real = 0, imaginary = 0;
    for (const float sample : samples) {
        const double value = sample * (1 - wx);
        real += value * x;
        imaginary += value * y;
        const double turned = x * c - y * s;
        y = x * s + y * c;
        x = turned;
        const double window = wx * wc - wy * ws;
        wy = wx * ws + wy * wc;
        wx = window;
    }
    return 2 * std::sqrt(real * real + imaginary * imaginary) / size;
}

double brightness(std::span<const float> samples) {
    // The centre by energy: the mean square of the slope against the mean square of the sound gives the root mean
    // square of the frequency, without a transform.
    double slope = 0, sum = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const double step = double(samples[i]) - samples[i - 1];
        slope += step * step;
        sum += double(samples[i]) * samples[i];
    }
    return sum > 0 ? std::sqrt(slope / sum) * rate / (2 * std::numbers::pi) : 0;
}

double strongest_frequency(std::span<const float> samples, double low, double high) {
    double best = low, most = -1;
    const double step = power_of_two(1.0 / 120);
    for (double frequency = low; frequency <= high; frequency *= step) {
        const double amount = amount_of(samples, frequency);
        if (amount > most) {
            most = amount;
            best = frequency;
        }
    }
    return best;
}

}  // namespace surefoot::sound
