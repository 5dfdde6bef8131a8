/// The band: it plays a score, again and again, as many samples at a time as are wanted.
#pragma once

#include <span>
#include <vector>

#include "platformer/sound/reverb.hpp"
#include "platformer/sound/score.hpp"

namespace surefoot::sound {

/// What rings at the end of the score rings on over its beginning, so that there is no seam.
class Band {
public:
    /// The score has to outlive it. Requires: its length is above 0.
    explicit Band(const Score& score);

    /// The next samples, left and right in turns. No sample passes 1.
    void play(std::span<float> stereo);

    /// How many samples a round of the score has.
    [[nodiscard]] std::size_t round() const { return round_; }

private:
    struct Sounding {
        Samples samples;
        std::size_t played;
        float left, right, room;
    };

    void begin_note(std::size_t index);
    void play_until_next_note(std::span<float> stereo);

    const Score* score_;
    std::size_t round_;
    std::size_t now_ = 0;   ///< in samples, within the round
    std::size_t next_ = 0;  ///< which note comes next
    std::vector<Sounding> sounding_;
    std::vector<float> to_room_;
    Reverb room_;
};

}  // namespace surefoot::sound
