// Looking farther than a step goes, for the trace alone: how high is what could not be stepped on, how deep is what
// could not be followed? What a character does never depends on what is seen here.
#pragma once

#include "character/stairs.hpp"

namespace surefoot::internal {

/// Why a step was refused.
struct Refusal {
    StepRule rule;
    double value;
    double limit;
    Ground at;
};

/// What is ahead of a body that something blocks.
struct Ahead {
    double height = 0;        ///< how much higher it is than what is stood on [m]; 0 if that is not known
    bool is_reached = false;  ///< a body that steps so high stands there
    Ground landing;           ///< what it stands on, if it is reached
};

/// Looks with ever higher steps, and where there is no head room for them, with a ray.
[[nodiscard]] Ahead look_ahead(const Surroundings& surroundings, const Body& body, const Gait& gait,
                               const GroundRule& rule, const StepSettings& settings, const Vec& position,
                               const Vec& level) noexcept;

/// The ground below, however steep, down to a few times the body's height; in the air if there is none.
[[nodiscard]] Ground look_down(const Surroundings& surroundings, const Body& body, const Gait& gait,
                               const Vec& position) noexcept;

}  // namespace surefoot::internal
