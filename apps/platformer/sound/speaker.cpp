#include "platformer/sound/speaker.hpp"

#include <chrono>
#include <utility>

namespace surefoot::sound {

namespace {

using Clock = std::chrono::steady_clock;

/// More than a game asks for in a frame by far. Who asks for more while the device opens is not heard.
constexpr std::size_t most_wishes = 256;

/// How often the music is looked after when nobody asks for anything.
constexpr std::chrono::milliseconds beat{30};

template <typename... Kinds>
struct Cases : Kinds... {
    using Kinds::operator()...;
};
template <typename... Kinds>
Cases(Kinds...) -> Cases<Kinds...>;

}  // namespace

Speaker::Speaker(Output output) {
    wishes_.reserve(most_wishes);
    thread_ = std::thread([this, output] { work(output); });
}

Speaker::~Speaker() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    asked_.notify_one();
    thread_.join();
}

void Speaker::play(Effect effect, const PlayOptions& options) {
    ask(Play{effect, options});
}
void Speaker::listen(const Listener& listener) {
    ask(listener);
}
void Speaker::set_volumes(const Volumes& volumes) {
    ask(volumes);
}
void Speaker::music(std::optional<Piece> piece, double fade) {
    ask(Music{piece, fade});
}
void Speaker::pause(bool paused) {
    ask(Pause{paused});
}

Speaker::State Speaker::state() const {
    const std::lock_guard lock(mutex_);
    return state_;
}

std::string Speaker::take_notice() {
    const std::lock_guard lock(mutex_);
    return std::exchange(notice_, {});
}

Speaker::State Speaker::wait_until_open() {
    std::unique_lock lock(mutex_);
    opened_.wait(lock, [&] { return state_ != State::opening; });
    return state_;
}

void Speaker::ask(Wish wish) {
    {
        const std::lock_guard lock(mutex_);
        if (state_ == State::silent) return;
        // What is set need be set once only: a listener moves every frame, and the device may take seconds to open.
        for (Wish& earlier : wishes_) {
            if (earlier.index() == wish.index() && !std::holds_alternative<Play>(wish)) {
                earlier = std::move(wish);
                return;
            }
        }
        if (wishes_.size() == most_wishes) return;
        wishes_.push_back(std::move(wish));
    }
    asked_.notify_one();
}

void Speaker::fall_silent(const std::string& why) {
    {
        const std::lock_guard lock(mutex_);
        state_ = State::silent;
        notice_ = why;
        wishes_.clear();
    }
    opened_.notify_all();
}

void Speaker::work(Output output) {
    Expected<Mixer> mixer = Mixer::open(output);
    if (!mixer) return fall_silent(mixer.error().text);
    {
        const std::lock_guard lock(mutex_);
        state_ = State::playing;
    }
    opened_.notify_all();

    const Cases act{
        [&](const Play& play) { mixer->play(play.effect, play.options); },
        [&](const Listener& listener) { mixer->listen(listener); },
        [&](const Volumes& volumes) { mixer->set_volumes(volumes); },
        [&](const Music& music) { mixer->music(music.piece, music.fade); },
        [&](const Pause& pause) { mixer->pause(pause.paused); },
    };
    std::vector<Wish> taken;
    taken.reserve(most_wishes);
    bool all_ready = false;
    auto last = Clock::now();
    while (true) {
        taken.clear();
        {
            std::unique_lock lock(mutex_);
            if (all_ready) asked_.wait_for(lock, beat, [&] { return ending_ || !wishes_.empty(); });
            if (ending_) return;
            taken.swap(wishes_);
        }
        for (const Wish& wish : taken) std::visit(act, wish);
        const auto now = Clock::now();
        if (!mixer->update(std::chrono::duration<double>(now - last).count())) {
            return fall_silent("No sound any more: the device is gone.");
        }
        last = now;
        if (!all_ready) all_ready = !mixer->prepare_one();
    }
}

}  // namespace surefoot::sound
