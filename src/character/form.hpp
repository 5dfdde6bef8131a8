// The bodies of one character: standing, crouched, in the air, on a ramp.
#pragma once

#include <surefoot/character.hpp>

namespace surefoot::internal {

/// The volume of a form; where the settings give none, that of standing.
[[nodiscard]] const Volume& volume_of(const CharacterSettings& settings, CharacterForm form) noexcept;

}  // namespace surefoot::internal
