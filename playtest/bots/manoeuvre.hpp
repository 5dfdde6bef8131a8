/// The manoeuvres that a level names for bots: swim, climb, crawl, and up between two walls.
#pragma once

#include <surefoot/world.hpp>

#include "game/level.hpp"
#include "playtest/bots/hands.hpp"

namespace surefoot::playtest {

class Manoeuvring {
public:
    Manoeuvring() = default;
    Manoeuvring(game::Manoeuvre how, const dvec3& to) : how_(how), to_(to) {}

    [[nodiscard]] Intent tick(const game::Hero& hero, const dvec3& feet, const World& world);
    [[nodiscard]] double seconds() const { return ticks_ * game::tick_seconds; }

private:
    [[nodiscard]] Intent swim(const game::Hero& hero, const dvec3& feet, const World& world);
    [[nodiscard]] Intent climb(const game::Hero& hero, const dvec3& feet);
    [[nodiscard]] Intent wall_jump(const game::Hero& hero, const dvec3& feet, const World& world);

    game::Manoeuvre how_ = game::Manoeuvre::swim;
    dvec3 to_{0, 0, 0};
    dvec3 along_{0, 0, 0};  ///< between the walls; level, unit
    dvec3 wall_{0, 0, 0};   ///< towards the wall that it goes for next; level, unit
    int ticks_ = 0;
    int jump_for_ = 0;
    int rest_for_ = 0;
    int back_for_ = 0;
};

}  // namespace surefoot::playtest
