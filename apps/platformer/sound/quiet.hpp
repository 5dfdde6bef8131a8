/// What lies below OpenAL, kept from writing to the terminal.
#pragma once

namespace surefoot::sound {

/// Where there is no sound card, ALSA says so in eight lines. `Mixer` says it in a sentence. Elsewhere than on Linux
/// there is nothing to do.
void quieten_alsa();

}  // namespace surefoot::sound
