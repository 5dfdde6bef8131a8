// Walking up a step: up, forwards, and down again on to something that can be stood on.
#pragma once

#include <optional>

#include "character/ground.hpp"

namespace surefoot::internal {

struct StepSettings {
    double step_up;     ///< [m]
    double step_depth;  ///< [m]
};

struct SteppedUp {
    Vec position;
    Ground ground;
};

/// Where a body gets straight up.
struct Raised {
    Vec position;
    double height;  ///< [m]
};

/// Straight up by `height`, as far as there is room.
[[nodiscard]] Raised raise(Surroundings& surroundings, const Body& body, const Gait& gait, const Vec& position,
                           double height) noexcept;

/// The box that most of what step_up asks lies in: one gather for all of it.
[[nodiscard]] Box3 box_of_step(const Body& body, const Gait& gait, const StepSettings& settings, const Vec& position,
                               const Vec& level, const Vec& wall) noexcept;

/// Tries to go on by `level`, which is across `up`, over what blocks it at `position`, from where it had
/// come as far as `stopped`. Whether there is a step is asked
/// `step_depth` ahead, square to the `wall` that blocks it and however short `level` is; then it is gone by `level`.
[[nodiscard]] std::optional<SteppedUp> step_up(Surroundings& surroundings, const Body& body, const Gait& gait,
                                               const GroundRule& rule, const StepSettings& settings,
                                               const Vec& position, const Vec& stopped, const Vec& level,
                                               const Vec& wall) noexcept;

}  // namespace surefoot::internal
