#include "platformer/sound/reverb.hpp"

namespace surefoot::sound {

Reverb::Reverb(double seconds, double damping) : damping_(damping) {
    // Prime lengths near 28, 34, 41 and 49 ms: their echoes do not fall together.
    constexpr std::array<std::size_t, 4> lengths{1237, 1499, 1811, 2161};
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        lines_[i].past.assign(lengths[i], 0.0);
        lines_[i].gain = decibels(-60 * double(lengths[i]) / (seconds * rate));
    }
}

Reverb::Heard Reverb::next(double in) {
    std::array<double, 4> out;
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        Line& line = lines_[i];
        line.dark = mix(line.past[line.at], line.dark, damping_);
        out[i] = line.dark * line.gain;
    }
    const double a = out[0] + out[1], b = out[0] - out[1], c = out[2] + out[3], d = out[2] - out[3];
    const std::array<double, 4> back{0.5 * (a + c), 0.5 * (b + d), 0.5 * (a - c), 0.5 * (b - d)};
    for (std::size_t i = 0; i < lines_.size(); ++i) {
        Line& line = lines_[i];
        line.past[line.at] = in + back[i];
        line.at = line.at + 1 == line.past.size() ? 0 : line.at + 1;
    }
    return {0.5 * (out[0] + out[2]), 0.5 * (out[1] - out[3])};
}

Samples in_room(const Samples& dry, double seconds, double share) {
    Reverb room(seconds);
    Samples wet(dry.size() + samples_in(seconds));
    for (std::size_t i = 0; i < wet.size(); ++i) {
        const double in = i < dry.size() ? dry[i] : 0;
        wet[i] = static_cast<float>(in + share * room.next(in).left);
    }
    return wet;
}

}  // namespace surefoot::sound
