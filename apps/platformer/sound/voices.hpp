/// Which sounds are heard when there are more of them than can be: pure bookkeeping, without OpenAL.
#pragma once

#include <optional>

#include <surefoot/math.hpp>
#include <surefoot/slab.hpp>

#include "platformer/sound/effects.hpp"

namespace surefoot::sound {

/// A sound that is playing.
struct Voice {
    Effect effect = Effect::coin;
    double gain = 1;
    std::optional<dvec3> place;  ///< without one it is everywhere, as menus are
};

using VoiceHandle = SlabHandle<Voice>;

inline constexpr double near_enough = 4;  ///< up to here a sound is as loud as it gets [m]
inline constexpr double far_enough = 60;  ///< from here on it gets no quieter [m]

/// How loud a voice is where the listener is: its gain, halved at twice `near_enough`, and so on.
[[nodiscard]] double heard(const Voice& voice, const dvec3& listener);

/// As many voices as there are sources. Slots have the numbers 0 to `capacity()` - 1.
class Voices {
public:
    /// Makes room for at least this many, rounded up to a power of two. [1 to 256]
    explicit Voices(std::uint32_t count) : voices_(count) {}

    /// Lets a voice in. If all slots are taken the quietest has to go, unless the newcomer is quieter still: then there
    /// is nothing. Its slot is the handle's index.
    [[nodiscard]] std::optional<VoiceHandle> admit(const Voice& voice, const dvec3& listener);

    void end(VoiceHandle handle) {
        if (voices_.contains(handle)) voices_.erase(handle);
    }

    [[nodiscard]] const Slab<Voice>& playing() const { return voices_; }
    [[nodiscard]] std::uint32_t capacity() const { return voices_.capacity(); }

private:
    Slab<Voice> voices_;
};

}  // namespace surefoot::sound
