/// A piece on its way to OpenAL.
#pragma once

#include <AL/al.h>
#include <array>
#include <vector>

#include "platformer/sound/band.hpp"
#include "platformer/sound/pieces.hpp"

namespace surefoot::sound {

/// Plays a piece through a source of its own, some tenths of a second ahead. Requires a current OpenAL context, as long
/// as it lives.
class MusicStream {
public:
    explicit MusicStream(Piece piece);
    MusicStream(const MusicStream&) = delete;
    MusicStream& operator=(const MusicStream&) = delete;
    ~MusicStream();

    [[nodiscard]] Piece piece() const { return piece_; }

    /// Where the fade leads to, and how long the whole way from silence to full takes. [0 or 1, s]
    void fade_to(double share, double seconds);

    /// One step of the fade, and as much music as is wanted. Returns false once it has faded away.
    bool update(double seconds, double gain);

private:
    void feed(ALuint buffer);

    static constexpr std::size_t block = 4096;  // 93 ms: the first is there after a hundredth of that
    Piece piece_;
    Band band_;
    ALuint source_ = 0;
    std::array<ALuint, 8> buffers_{};
    std::size_t filled_ = 0;  ///< how many of them were ever filled
    std::vector<float> samples_;
    std::vector<std::int16_t> converted_;
    double share_ = 0, target_ = 1, speed_ = 1;
};

}  // namespace surefoot::sound
