// Sphere, capsule, box and cylinder among themselves, axes agreeing.
#pragma once

#include <optional>

#include "pair/placed.hpp"

namespace surefoot::internal {

class UprightPair {
public:
    /// Nothing if the two are not of this family.
    static std::optional<UprightPair> of(const PlacedPair& pair) noexcept;

    [[nodiscard]] Gap gap_at(const Vec& x) const noexcept;

    /// A good guess at when a point that moves from `x` along `motion` enters; 0 without one.
    [[nodiscard]] double guess_entry(const Vec& x, const Vec& motion) const noexcept;

private:
    explicit UprightPair(const Frame& frame) noexcept : frame_(frame) {}
    [[nodiscard]] bool add(const Placed& placed) noexcept;

    Frame frame_;
    Vec half_;         // of the box
    double disc_ = 0;  // radius of the level disc
    double ball_ = 0;  // radius of the ball
};

}  // namespace surefoot::internal
