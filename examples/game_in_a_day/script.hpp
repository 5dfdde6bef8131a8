// The run that wins: what the autopilot of step 3 has to know about this level.
#pragma once

#include "autopilot.hpp"
#include "game.hpp"

namespace day {

// [script]
class Script {
public:
    /// What a player would press in the next tick.
    [[nodiscard]] surefoot::CharacterInput input(const Game& game) {
        surefoot::CharacterInput input{.wish = autopilot_.wish(game.world, game.movers, game.hero)};
        const dvec3 feet = feet_of(game.hero);
        // The crate with the coin is too high to step on.
        input.jump = is_near(feet, {-2.5, 0, -4}, 2) && feet.z > -4;
        for (const Enemy& enemy : game.enemies) {  // wait for whoever comes, and jump on its head
            if (is_near(feet, feet_of(enemy.state), 4)) input.wish = {0, 0, 0};
            if (is_near(feet, feet_of(enemy.state), 1.5)) input.jump = true;
        }
        return input;
    }

private:
    Autopilot autopilot_{{{.to = {0, 0, -1}},
                          {.to = {-2.5, 1, -4}},
                          {.to = {0, 0, -9}},
                          {.to = {0, 0, -13}},
                          {.to = {}, .rides = 0},
                          {.to = {0, 0, -25.5}},
                          {.to = {6, 0, -27}},
                          {.to = {6, 0.7, -31}},
                          {.to = {-3, 0, -34}},
                          {.to = {0, 0, -36}},
                          {.to = {}, .rides = 1},
                          {.to = {0, 4, -43}},
                          {.to = {0, 4, -47}}}};
};
// [/script]

}  // namespace day
