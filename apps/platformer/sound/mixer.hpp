/// All that is said to OpenAL, by one thread. Games use `Speaker`, which is that thread.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include <surefoot/error.hpp>

#include "platformer/sound/pieces.hpp"
#include "platformer/sound/voices.hpp"

namespace surefoot::sound {

/// How a sound is to be played.
struct PlayOptions {
    std::optional<dvec3> place = {};  ///< [m] without one it is heard alike everywhere, and is not held by a pause
    dvec3 velocity{0.0};              ///< of what makes it [m/s]
    double gain = 1;                  ///< 0 to 1; what is beyond is taken for the nearer end
    double pitch = 1;                 ///< how much faster it is played [0.25 to 4]
};

struct Listener {
    dvec3 place{0.0};
    dvec3 velocity{0.0};
    dvec3 forward{0.0, 0.0, -1.0};
    dvec3 up{0.0, 1.0, 0.0};
};

/// Each 0 to 1, as sliders are; how they sound is for the mixer to say.
struct Volumes {
    double master = 0.8;
    double effects = 1;
    double music = 0.7;
};

/// Where the sound goes.
enum class Output {
    device,   ///< what the system gives
    memory,   ///< nowhere: `Mixer::mixed` gives it back, which is how tests listen
    nothing,  ///< as if there were no device
};

class Mixer {
public:
    /// Opens the device. May take a while. Fails with `not_found` if there is none and `unsupported` if it cannot do
    /// what is needed.
    [[nodiscard]] static Expected<Mixer> open(Output output = Output::device);

    Mixer(Mixer&&) noexcept;
    Mixer& operator=(Mixer&&) noexcept;
    ~Mixer();

    void play(Effect effect, const PlayOptions& options);
    void listen(const Listener& listener);
    void set_volumes(const Volumes& volumes);

    /// Begins a piece, or silence, while what was there fades in so many seconds. The piece that is playing goes on.
    void music(std::optional<Piece> piece, double fade);

    /// Holds the effects that have a place, and lowers the music.
    void pause(bool paused);

    /// Feeds the music and lets go of sounds that have ended. Requires: called at least every 0.3 s. Returns false once
    /// the device is gone.
    bool update(double seconds);

    /// Makes one more variation of an effect ready, so that the first `play` of it takes no time. Returns false when
    /// all are.
    bool prepare_one();

    /// How many effects are heard.
    [[nodiscard]] std::uint32_t playing() const;

    /// The next samples as they would go to the device, left and right in turns. Requires: `Output::memory`.
    void mixed(std::span<float> stereo);

private:
    struct Parts;
    explicit Mixer(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> parts_;
};

}  // namespace surefoot::sound
