/// Somebody who plays: looks at a game and says what is pressed.
#pragma once

#include <string>

#include "game/game.hpp"

namespace surefoot::playtest {

class Bot {
public:
    Bot() = default;
    virtual ~Bot() = default;
    Bot(const Bot&) = delete;
    Bot& operator=(const Bot&) = delete;

    /// For the next tick. Looks at the game; does nothing to it.
    [[nodiscard]] virtual game::HeroInput decide(const game::Game& game) = 0;

    /// Why it plays on no longer; empty as long as it does.
    [[nodiscard]] virtual const std::string& gave_up() const = 0;

    [[nodiscard]] virtual std::string name() const = 0;
};

}  // namespace surefoot::playtest
