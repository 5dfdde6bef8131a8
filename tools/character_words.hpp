// What happened to a character, in words.
#pragma once

#include <string>

#include <surefoot/character.hpp>

namespace surefoot::tools {

/// "blocked, landed", or "none".
[[nodiscard]] std::string events_text(const CharacterEvents& events);

/// "on ground".
[[nodiscard]] std::string footing_text(Footing footing);

}  // namespace surefoot::tools
