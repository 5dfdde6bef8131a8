// Seeded random numbers that are the same on every machine (Steele, Lea, Flood: splitmix64).
#pragma once

#include <cstdint>

#include <surefoot/math.hpp>

namespace surefoot::tests {

class SplitMix {
public:
    explicit SplitMix(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15ULL;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
        return z ^ (z >> 31);
    }
    double in(double low, double high) { return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53); }
    dvec3 point(double size) {
        const double x = in(-size, size);
        const double y = in(-size, size);
        return dvec3(x, y, in(-size, size));
    }
    dquat turn() {
        const double w = in(-1, 1);
        const double x = in(-1, 1);
        const double y = in(-1, 1);
        return dquat(w, x, y, in(-1, 1));
    }

private:
    std::uint64_t state_;
};

}  // namespace surefoot::tests
