// Any two convex shapes: the distance of their cores by the algorithm of Gilbert, Johnson and Keerthi ("A fast
// procedure for computing the distance between complex objects", 1988), with both balls taken off it.
#pragma once

#include "pair/placed.hpp"

namespace surefoot::internal {

/// The closest points of two shapes, the second at the origin.
struct Closest {
    Gap gap;
    Vec on_a;  ///< of the cores; in the world, relative to b's reference point
    Vec on_b;
};

class GeneralPair {
public:
    /// `hair`: how well the distance has to be known [m].
    GeneralPair(const PlacedPair& pair, double hair) noexcept : pair_(pair), hair_(hair) {}

    [[nodiscard]] Closest closest_at(const Vec& x) const noexcept;
    [[nodiscard]] Gap gap_at(const Vec& x) const noexcept;
    [[nodiscard]] double guess_entry(const Vec&, const Vec&) const noexcept { return 0; }

private:
    const PlacedPair& pair_;
    double hair_;
};

}  // namespace surefoot::internal
