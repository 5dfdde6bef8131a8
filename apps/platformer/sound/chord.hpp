/// Chords by the symbols of lead sheets, and how hands would lay them.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace surefoot::sound {

struct Chord {
    int root = 0;              ///< semitones above c, 0 to 11
    int bass = 0;              ///< the same for the lowest note: the root, or what stands behind the stroke
    std::vector<int> degrees;  ///< semitones above the root, ascending, beginning with 0

    /// What the nth degree of its scale is in this chord, in semitones above the root: 3 is the third that it has,
    /// minor or major. [1 to 8]
    [[nodiscard]] int degree(int number) const;
};

/// "C", "F#m7", "Bbmaj9", "C7sus4", "Ebmaj7/G". Nothing if it is none of those we know.
[[nodiscard]] std::optional<Chord> chord_named(std::string_view symbol);

/// Four pitches, low to high.
using Voicing = std::array<int, 4>;

/// Lays a chord so that the hands move as little as can be from where they were; without a place to come from, around
/// the middle c. Large chords leave the root to the bass.
[[nodiscard]] Voicing voiced(const Chord& chord, const std::optional<Voicing>& before);

}  // namespace surefoot::sound
