// What a character pressed against, with the impulse that it owes to it.
#pragma once

#include <span>

#include <surefoot/character.hpp>

#include "character/slide.hpp"

namespace surefoot::internal {

struct Tick;

/// What a motion with this velocity pressed against, each by as much of the velocity as it took away.
void press(Tick& tick, std::span<const Obstacle> met, const Vec& velocity) noexcept;

/// Its weight on what it stands on.
void weigh(Tick& tick) noexcept;

/// The contacts of two ticks, one after the other.
[[nodiscard]] CharacterContacts merged(const CharacterContacts& first, const CharacterContacts& second) noexcept;

}  // namespace surefoot::internal
