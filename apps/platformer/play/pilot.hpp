/// The bot that knows its way, as a pilot of a run.
#pragma once

#include "platformer/play/run.hpp"

namespace surefoot::platformer {

/// To study a level takes it seconds the first time. Where it gives up it stands still.
[[nodiscard]] Pilot bot_pilot(std::uint64_t seed = 1);

}  // namespace surefoot::platformer
