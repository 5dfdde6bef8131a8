#include "platformer/sound/voices.hpp"

#include <algorithm>
#include <cmath>

namespace surefoot::sound {

double heard(const Voice& voice, const dvec3& listener) {
    if (!voice.place) return voice.gain;
    const dvec3 apart = *voice.place - listener;
    const double distance = std::sqrt(apart.x * apart.x + apart.y * apart.y + apart.z * apart.z);
    return voice.gain * near_enough / std::clamp(distance, near_enough, far_enough);
}

std::optional<VoiceHandle> Voices::admit(const Voice& voice, const dvec3& listener) {
    if (voices_.size() == voices_.capacity()) {
        VoiceHandle quietest;
        double least = heard(voice, listener);
        for (auto it = voices_.begin(); it != voices_.end(); ++it) {
            const double loud = heard(*it, listener);
            // At a tie the older sound makes room: what has just happened is what people listen for.
            if (loud < least || (loud <= least && !quietest)) {
                least = loud;
                quietest = it.handle();
            }
        }
        if (!quietest) return std::nullopt;
        voices_.erase(quietest);
    }
    const VoiceHandle handle = voices_.insert(voice);
    return handle ? std::optional(handle) : std::nullopt;
}

}  // namespace surefoot::sound
