/// Seeded random numbers that are the same on every machine (Steele, Lea, Flood: splitmix64).
#pragma once

#include <cmath>
#include <cstdint>

#include <surefoot/math.hpp>

namespace surefoot::bench {

/// Spreads the bits of `z` over all 64: two seeds that differ in one bit give unrelated numbers.
[[nodiscard]] constexpr std::uint64_t scramble(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
}

/// The upper bits of a number, as a double in [0, 1).
[[nodiscard]] constexpr double to_unit(std::uint64_t bits) {
    return static_cast<double>(bits >> 11) * 0x1p-53;
}

class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15ULL;
        return scramble(state_);
    }
    double in(double low, double high) { return low + (high - low) * to_unit(next()); }
    std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(((next() >> 32) * count) >> 32); }
    bool chance(double share) { return in(0, 1) < share; }

    /// Evenly over all directions: a point of the ball, pushed out. Roots are the same everywhere, sines are not.
    dvec3 direction() {
        for (;;) {
            const double x = in(-1, 1);
            const double y = in(-1, 1);
            const dvec3 p(x, y, in(-1, 1));
            const double square = p.x * p.x + p.y * p.y + p.z * p.z;
            if (square > 1e-4 && square <= 1) return p / std::sqrt(square);
        }
    }

private:
    std::uint64_t state_;
};

}  // namespace surefoot::bench
