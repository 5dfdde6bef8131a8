// Getting out of what a body begins inside of, or too close to.
#pragma once

#include "character/slide.hpp"

namespace surefoot::internal {

/// How fast a body gets out of what it begins inside of [m/s].
inline constexpr double recovery_speed = 10;

struct Recovery {
    Vec position;
    bool moved = false;
    bool stuck = false;     ///< it is inside of something, and there is no way out within reach
    bool overflow = false;  ///< more is near than can be looked at
};

/// Moves the body, by at most `farthest` [m], until it is a skin away from everything, if it is nearer than half of
/// that to anything. Its centre crosses no triangle on the way.
[[nodiscard]] Recovery recover(Surroundings& surroundings, const Body& body, const Gait& gait, const Vec& from,
                               double farthest) noexcept;

}  // namespace surefoot::internal
