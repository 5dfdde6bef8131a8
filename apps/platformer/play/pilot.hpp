/// The bot that knows its way, as a pilot of a run.
#pragma once

#include "platformer/play/run.hpp"

namespace surefoot::platformer {

/// It studies a level when it is asked for the first input of a game, which takes seconds, and is kept for the next
/// time. Where it gives up it stands still.
[[nodiscard]] Pilot bot_pilot(std::uint64_t seed = 1);

}  // namespace surefoot::platformer
