/// Random numbers of our own: the same on every machine.
#pragma once

#include <cstdint>

#include <surefoot/random.hpp>

namespace surefoot::sound {

class Random {
public:
    /// Seeds that are neighbours give sequences that have nothing in common: so the seed is stirred before it is used,
    /// for by itself a seed one higher would be the same sequence one number on.
    explicit Random(std::uint64_t seed) : state_(seed) { state_ = bits() ^ 0x243F6A8885A308D3U; }

    [[nodiscard]] std::uint64_t bits() { return next_random(state_); }

    /// At least `low`, below `high`.
    [[nodiscard]] double between(double low, double high) { return low + (high - low) * next_share(state_); }

    /// White noise, from -1 to 1.
    [[nodiscard]] double noise() { return between(-1, 1); }

private:
    std::uint64_t state_;
};

}  // namespace surefoot::sound
