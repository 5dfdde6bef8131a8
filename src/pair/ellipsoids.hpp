// Two ellipsoids of the same proportions, turned alike: two characters of one kind.
#pragma once

#include <optional>

#include "pair/placed.hpp"

namespace surefoot::internal {

class SimilarEllipsoids {
public:
    /// Nothing if the two are not of this family.
    static std::optional<SimilarEllipsoids> of(const PlacedPair& pair) noexcept;

    [[nodiscard]] Gap gap_at(const Vec& x) const noexcept;
    [[nodiscard]] double guess_entry(const Vec& x, const Vec& motion) const noexcept;

private:
    SimilarEllipsoids(const Frame& frame, const Vec& radii) noexcept : frame_(frame), radii_(radii) {}

    Frame frame_;
    Vec radii_;  // of the sum
};

}  // namespace surefoot::internal
