/// Random numbers of our own: the same on every machine.
#pragma once

#include <cstdint>

namespace surefoot::sound {

/// Steele, Lea and Flood's SplitMix64.
class Random {
public:
    /// Seeds that are neighbours give sequences that have nothing in common: so the seed is stirred before it is used,
    /// for by itself a seed one higher would be the same sequence one number on.
    explicit Random(std::uint64_t seed) : state_(seed) { state_ = bits() ^ 0x243F6A8885A308D3U; }

    [[nodiscard]] std::uint64_t bits() {
        std::uint64_t z = state_ += 0x9E3779B97F4A7C15U;
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9U;
        z = (z ^ z >> 27) * 0x94D049BB133111EBU;
        return z ^ z >> 31;
    }

    /// At least `low`, below `high`.
    [[nodiscard]] double between(double low, double high) {
        return low + (high - low) * (double(bits() >> 11) * 0x1p-53);
    }

    /// White noise, from -1 to 1.
    [[nodiscard]] double noise() { return between(-1, 1); }

private:
    std::uint64_t state_;
};

}  // namespace surefoot::sound
