/// The bot that knows nothing: it runs about, presses everything, and goes where it has not been.
#pragma once

#include <array>
#include <map>

#include "playtest/bots/bot.hpp"
#include "playtest/bots/hands.hpp"

namespace surefoot::playtest {

class Explorer final : public Bot {
public:
    explicit Explorer(std::uint64_t seed) : hands_(seed * 3 + 2), dice_(seed * 11 + 3) {}

    [[nodiscard]] game::HeroInput decide(const game::Game& game) override;
    [[nodiscard]] const std::string& gave_up() const override { return never_; }
    [[nodiscard]] std::string name() const override { return "explorer"; }

private:
    enum class Mood : std::uint8_t { runs, spins, mashes, hugs_walls, looks_for_new, stands };

    void choose_mood(const game::Game& game);
    void look_for_new(const game::Game& game);

    Hands hands_;
    Dice dice_;
    std::string never_;
    Mood mood_ = Mood::stands;
    int left_ = 0;  ///< ticks of this mood
    double heading_ = 0;
    double turning_ = 0;  ///< [rad a tick]
    int jump_for_ = 0;
    int dash_for_ = 0;
    int crouch_for_ = 0;
    double jumps_ = 0;                                  ///< chance in a tick
    std::map<std::array<int, 3>, std::uint32_t> been_;  ///< by cells of two metres, how many ticks
};

}  // namespace surefoot::playtest
