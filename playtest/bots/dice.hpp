/// Seeded random numbers that are the same on every machine.
#pragma once

#include <cstdint>

#include <surefoot/random.hpp>

namespace surefoot::playtest {

class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() { return next_random(state_); }
    double in(double low, double high) { return low + (high - low) * next_share(state_); }
    /// From low to high, both included.
    int whole(int low, int high) { return low + static_cast<int>(next() % static_cast<std::uint64_t>(high - low + 1)); }
    bool chance(double share) { return in(0, 1) < share; }

private:
    std::uint64_t state_;
};

}  // namespace surefoot::playtest
