/// The sound of a game. Every call returns at once; where there is no device nothing is heard and nothing fails.
#pragma once

#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "platformer/sound/mixer.hpp"

namespace surefoot::sound {

/// A thread that opens the device, makes the sounds, streams the music, and does what it is told to between two of
/// those. Those who call it only write down what they want. Any thread may call; one speaker at a time.
class Speaker {
public:
    enum class State {
        opening,  ///< what is asked for now is heard once the device is there
        playing,
        silent,  ///< there is no device, or there is no longer
    };

    explicit Speaker(Output output = Output::device);
    Speaker(const Speaker&) = delete;
    Speaker& operator=(const Speaker&) = delete;
    ~Speaker();

    void play(Effect effect, const PlayOptions& options = {});
    void listen(const Listener& listener);
    void set_volumes(const Volumes& volumes);

    /// Fades to a piece, or to silence, in so many seconds.
    void music(std::optional<Piece> piece, double fade = 1.5);

    /// Holds the effects that have a place, and lowers the music; menus are heard.
    void pause(bool paused);

    [[nodiscard]] State state() const;

    /// Why there is no sound, once; empty if there is, and when it has been said.
    [[nodiscard]] std::string take_notice();

    /// Waits until the device is open or known to be missing. For tests: a game need not care.
    [[nodiscard]] State wait_until_open();

private:
    struct Play {
        Effect effect;
        PlayOptions options;
    };
    struct Music {
        std::optional<Piece> piece;
        double fade;
    };
    struct Pause {
        bool paused;
    };
    using Wish = std::variant<Play, Listener, Volumes, Music, Pause>;

    void ask(Wish wish);
    void work(Output output);
    void fall_silent(const std::string& why);

    mutable std::mutex mutex_;
    std::condition_variable asked_, opened_;
    std::vector<Wish> wishes_;
    State state_ = State::opening;
    std::string notice_;
    bool ending_ = false;
    std::thread thread_;  ///< last, so that all the rest is there when it begins
};

}  // namespace surefoot::sound
