#include "platformer/sound/samples.hpp"

#include <algorithm>
#include <cmath>

#include "platformer/sound/filter.hpp"
#include "platformer/sound/measure.hpp"

namespace surefoot::sound {

void add(Samples& to, std::span<const float> from, double at, double gain) {
    const std::size_t start = samples_in(at);
    if (to.size() < start + from.size()) to.resize(start + from.size());
    for (std::size_t i = 0; i < from.size(); ++i) to[start + i] += static_cast<float>(gain) * from[i];
}

void fade_ends(Samples& samples, double in, double out) {
    const std::size_t size = samples.size();
    const std::size_t up = std::min(size, samples_in(in)), down = std::min(size, samples_in(out));
    for (std::size_t i = 0; i < up; ++i) samples[i] *= static_cast<float>(double(i) / double(up));
    for (std::size_t i = 0; i < down; ++i) samples[size - 1 - i] *= static_cast<float>(double(i) / double(down));
}

void remove_rumble(Samples& samples, double below) {
    Filter filter(below, 0.7);
    for (float& sample : samples) sample = static_cast<float>(filter.next(sample).high);
}

void trim(Samples& samples, double share) {
    const double floor = peak(samples) * share;
    while (!samples.empty() && std::abs(samples.back()) <= floor) samples.pop_back();
}

void set_loudness(Samples& samples, double db, double highest) {
    const double loud = loudest(samples, 0.05), top = peak(samples);
    if (top <= 0) return;
    const double gain = std::min(decibels(db) / loud, highest / top);
    for (float& sample : samples) sample = static_cast<float>(gain * sample);
}

double soft_limit(double x) {
    const double size = std::abs(x);
    if (size <= 0.7) return x;
    const double over = (size - 0.7) / 0.3;
    return std::copysign(0.7 + 0.3 * over / (1 + over), x);
}

std::int16_t to_16_bits(double x) {
    const double scaled = std::clamp(x, -1.0, 1.0) * 32767;
    return static_cast<std::int16_t>(scaled + (scaled < 0 ? -0.5 : 0.5));
}

}  // namespace surefoot::sound
