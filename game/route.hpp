/// Where something that moves by itself is, as a function of its clock alone.
#pragma once

#include <surefoot/math.hpp>

#include "game/level.hpp"

namespace surefoot::game {

/// Relative to its first stop, after `clock` seconds of its route [m]. It leaves and reaches stops gently.
[[nodiscard]] dvec3 place_on(const Route& route, double clock);

/// How long a whole round takes, there and back again where it goes back [s]; 0 for who has no stops.
[[nodiscard]] double round_time(const Route& route);

/// Turned on by `deg` about +Y.
[[nodiscard]] dquat turned(const dquat& orientation, double deg);

}  // namespace surefoot::game
