/// The instruments of the band, and of those effects that are little tunes.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "platformer/sound/samples.hpp"

namespace surefoot::sound {

enum class Instrument : std::uint8_t {
    flute,       ///< soft, with breath and a late vibrato
    reed,        ///< a hollow square wave, like a clarinet in a toy box
    brass,       ///< saws whose filter opens with the attack
    pad,         ///< three saws out of tune behind a low filter: slow
    piano,       ///< electric, by frequency modulation
    vibraphone,  ///< struck metal bars that swell and fade
    marimba,     ///< struck wood
    ukulele,     ///< plucked strings
    bell,        ///< small and bright
    bass,        ///< plucked and round
    kick,        ///< from here on: drums, which have one pitch of their own
    snare,
    brush,
    hat,
    open_hat,
    shaker,
    ride,
    clap,
};

inline constexpr int instrument_count = static_cast<int>(Instrument::clap) + 1;

[[nodiscard]] constexpr bool is_drum(Instrument instrument) {
    return instrument >= Instrument::kick;
}

[[nodiscard]] std::string_view name_of(Instrument instrument);
[[nodiscard]] std::optional<Instrument> instrument_named(std::string_view name);

struct Strike {
    double pitch = 60;       ///< in semitones, 60 the middle c; drums do not care
    double seconds = 0.5;    ///< until it is let go; what is struck or plucked rings on a little
    double velocity = 0.8;   ///< how hard: 0 to 1
    std::uint64_t seed = 0;  ///< of its noise and its small imperfections
};

/// One note as it sounds, its end included. Same arguments, same samples.
[[nodiscard]] Samples play(Instrument instrument, const Strike& strike);

}  // namespace surefoot::sound
