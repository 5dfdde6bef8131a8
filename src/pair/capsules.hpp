// Capsule against capsule, turned any way: the distance of two segments less two radii.
#pragma once

#include <optional>

#include "pair/placed.hpp"

namespace surefoot::internal {

class CapsulePair {
public:
    /// Nothing if one of the two is no capsule.
    static std::optional<CapsulePair> of(const PlacedPair& pair) noexcept;

    [[nodiscard]] Gap gap_at(const Vec& x) const noexcept;
    [[nodiscard]] double guess_entry(const Vec&, const Vec&) const noexcept { return 0; }

private:
    CapsulePair() noexcept = default;

    Vec half_a_;
    Vec half_b_;
    double radius_ = 0;  // both together
};

}  // namespace surefoot::internal
