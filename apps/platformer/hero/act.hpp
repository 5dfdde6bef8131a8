/// What a hero is doing, read off the state of its volume.
#pragma once

#include "platformer/hero/pose.hpp"

namespace surefoot::platformer {

[[nodiscard]] HeroAct act_of(const HeroPose& pose, const CharacterState& before, const CharacterState& after,
                             const CharacterEvents& events, const CharacterSettings& settings, const HeroFlags& flags);

}  // namespace surefoot::platformer
