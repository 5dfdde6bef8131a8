// Going on foot: along the ground, up steps, down with it where it falls away.
#pragma once

#include <surefoot/character.hpp>

#include "character/ground.hpp"
#include "character/slide.hpp"

namespace surefoot::internal {

struct WalkResult {
    Vec position;
    Ground ground;      ///< air if it was left
    Vec velocity;       ///< what is left of the level velocity [m/s]
    double done = 1;    ///< share of the way that was gone when the ground was left [0, 1]
    Obstacle obstacle;  ///< met the most squarely
    std::array<Obstacle, 4> met{};
    std::size_t met_count = 0;
    bool stepped_up = false;
    bool snapped_down = false;
    bool met_ceiling = false;
    bool overflow = false;
};

/// Goes by `way`, which is across `up`, beginning on `ground`.
[[nodiscard]] WalkResult walk(Surroundings& surroundings, const Body& body, const Gait& gait,
                              const CharacterSettings& settings, const OwnRule<MetOnTheWay>& respond, const Vec& from,
                              const Ground& ground, const Vec& way, const Vec& velocity) noexcept;

}  // namespace surefoot::internal
