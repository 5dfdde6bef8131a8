// Box against box, turned any way.
//
// The sum of two boxes is a polytope whose faces are square to the three axes of each and to the nine cross products
// (Gottschalk, Lin and Manocha, "OBBTree", 1996). The largest gap over these 15 axes is the signed distance inside, and
// outside it is positive exactly when they are apart.
#pragma once

#include <optional>

#include "pair/placed.hpp"

namespace surefoot::internal {

class BoxPair {
public:
    /// Nothing if one of the two is no box.
    static std::optional<BoxPair> of(const PlacedPair& pair) noexcept;

    [[nodiscard]] Gap gap_at(const Vec& x) const noexcept;

    /// When the last of the 15 slabs is entered.
    [[nodiscard]] double guess_entry(const Vec& x, const Vec& motion) const noexcept;

private:
    BoxPair() noexcept = default;

    Vec axis_[15];
    double reach_[15] = {};
    int count_ = 0;
};

}  // namespace surefoot::internal
