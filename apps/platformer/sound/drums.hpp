/// The drums: from noise, and from sines that fall.
#pragma once

#include "platformer/sound/instruments.hpp"

namespace surefoot::sound {

/// Requires: `is_drum(instrument)`.
[[nodiscard]] Samples drum(Instrument instrument, const Strike& strike);

}  // namespace surefoot::sound
