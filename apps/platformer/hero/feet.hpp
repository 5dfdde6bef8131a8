/// Feet that stay where they were put down: each stands still in the world until its turn comes to swing forward, and
/// its turn comes by the distance that was walked.
#pragma once

#include <array>

#include <surefoot/math.hpp>

namespace surefoot::platformer {

struct Foot {
    dvec3 at{0, 0, 0};    ///< of the sole, in the world [m]
    dvec3 from{0, 0, 0};  ///< where it was lifted, relative to the walker [m]
    double swing = 0;     ///< of the way to where it is put down next [0 to 1]; 0: it stands
    double toes = 0;      ///< how far they point down [rad]
};

using Feet = std::array<Foot, 2>;

struct Walk {
    dvec3 place{0, 0, 0};    ///< of the walker's soles, in the world [m]
    dvec3 carried{0, 0, 0};  ///< by what it stands on, in this tick [m]
    dvec3 ground_normal{0, 1, 0};
    double facing = 0;        ///< [rad]
    dvec3 velocity{0, 0, 0};  ///< relative to the ground [m/s]
    double stride = 0;        ///< how many pairs of steps were made
    double wide = 0.13;       ///< of either foot from the middle [m]
};

/// On by `dt` [s].
[[nodiscard]] Feet advance(const Feet& feet, const Walk& walk, double dt);

}  // namespace surefoot::platformer
