#include "platformer/sound/quiet.hpp"

namespace surefoot::sound {

void quieten_alsa() {}

}  // namespace surefoot::sound
