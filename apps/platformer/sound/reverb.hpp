/// A small room.
#pragma once

#include <array>
#include <vector>

#include "platformer/sound/samples.hpp"

namespace surefoot::sound {

/// Four delay lines that feed each other through a Hadamard matrix (Jot's feedback delay network), darker each time
/// round. Two ears hear different lines.
class Reverb {
public:
    /// `seconds` until it has faded by 60 dB; `damping` [0 to 1): how much darker each echo is.
    explicit Reverb(double seconds, double damping = 0.35);

    struct Heard {
        double left, right;
    };
    [[nodiscard]] Heard next(double in);

private:
    struct Line {
        std::vector<double> past;
        std::size_t at = 0;
        double gain = 0;
        double dark = 0;
    };
    std::array<Line, 4> lines_;
    double damping_;
};

/// The same sound, in a room: `share` of what the room gives back is added, and rings on for as long as it does.
[[nodiscard]] Samples in_room(const Samples& dry, double seconds, double share);

}  // namespace surefoot::sound
