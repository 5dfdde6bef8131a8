// What is under a body, and whether it can be stood on: one rule for going up, going down and standing.
#pragma once

#include <cstdint>

#include <surefoot/character.hpp>
#include <surefoot/character_trace.hpp>

#include "character/slide.hpp"
#include "character/surroundings.hpp"

namespace surefoot::internal {

/// What a body comes to rest on when it is let down.
struct Ground {
    Footing footing = Footing::air;
    double distance = 0;  ///< how far down it is [m]
    Vec normal;           ///< of the surface, unit; zero in the air
    Vec contact_normal;   ///< of the touch, unit
    Vec point;            ///< of the touch [m]
    std::uint32_t body = 0;
    std::uint32_t triangle = 0;
    std::uint32_t surface = 0;
    StepRule rule = StepRule::none;  ///< why it is not ground, with what was held against what
    double value = 0;
    double limit = 0;
    bool trusted = true;  ///< false where a query could not be answered
};

/// Where ground may hold a body.
struct GroundRule {
    double perch_distance;  ///< from the axis, for edges [m]
    Vec towards;            ///< where the body is walking, unit or zero: on to an edge there it may climb
    double follows = 0;     ///< how far down from an edge that it walks off it keeps to the ground [m]
};

/// What is below `position`, down to `depth` [m]. Ground is what is not too steep, by the surface's own normal and by
/// that of the touch; an edge that is touched too steeply still holds within the perch distance.
[[nodiscard]] Ground ground_under(Surroundings& surroundings, const Body& body, const Gait& gait,
                                  const GroundRule& rule, const Vec& position, double depth) noexcept;

/// Held by steep things on all sides, as in a funnel or between walls, a body cannot go down: then it stands.
void stand_if_wedged(Surroundings& surroundings, const Body& body, const Gait& gait, const Vec& position,
                     Ground& ground) noexcept;

}  // namespace surefoot::internal
