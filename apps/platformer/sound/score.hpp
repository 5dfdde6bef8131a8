/// Music as it is written: parts in bars, for a band. docs/sound.md tells how to write it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <surefoot/error.hpp>

#include "platformer/sound/instruments.hpp"

namespace surefoot::sound {

/// Somebody in the band.
struct Part {
    std::string name;
    Instrument instrument = Instrument::piano;
    double gain = 0.5;
    double pan = 0;     ///< -1 left to 1 right
    double room = 0.2;  ///< how much of it the room hears
};

struct Note {
    double start = 0;   ///< from the beginning of the piece [s]
    double length = 0;  ///< [s]
    double pitch = 60;  ///< in semitones, 60 the middle c
    double velocity = 0.8;
    std::size_t part = 0;  ///< of `Score::parts`
};

struct Score {
    std::string title;
    double length = 0;  ///< after this it begins again [s]
    std::vector<Part> parts;
    std::vector<Note> notes;  ///< by their starts
};

/// Fails with `unreadable` and the line that is not understood.
[[nodiscard]] Expected<Score> read_score(std::string_view text);

}  // namespace surefoot::sound
