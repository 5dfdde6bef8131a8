// The bodies of one character: standing, crouched, in the air, on a ramp, on an edge.
#pragma once

#include <surefoot/character.hpp>

#include "character/tick.hpp"

namespace surefoot::internal {

/// The volume of a form; where the settings give none, that of standing.
[[nodiscard]] const Volume& volume_of(const CharacterSettings& settings, CharacterForm form) noexcept;

/// Is there room for the body, half a skin from everything?
[[nodiscard]] bool has_room(Tick& tick, const Body& body, const Vec& position) noexcept;

}  // namespace surefoot::internal
