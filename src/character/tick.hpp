// One tick of a character, or a part of a long one.
#pragma once

#include <surefoot/character.hpp>

#include "character/carry.hpp"

namespace surefoot::internal {

/// Requires: valid arguments. `tick` is all of the world's tick [s], `part` what is done of it here.
[[nodiscard]] StepResult tick_once(const World& world, const CharacterSettings& settings, const CharacterInput& input,
                                   double tick, const TickPart& part, const CharacterState& state,
                                   StepTrace* trace) noexcept;

}  // namespace surefoot::internal
