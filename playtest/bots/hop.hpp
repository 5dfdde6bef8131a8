/// Over to somewhere that no path leads to: run, jump where it has to be, jump again and dash where that is not enough,
/// and steer until the feet are there. The same controller is rehearsed and done.
#pragma once

#include <surefoot/world.hpp>

#include "game/hero.hpp"
#include "playtest/bots/hands.hpp"

namespace surefoot::playtest {

struct HopStyle {
    bool jumps = true;    ///< else it runs, or drops
    double takeoff = 0;   ///< so far before the aim [m]; 0: where the ground ends
    int air_jumps = 0;    ///< so many may be used
    bool late = false;    ///< the second jump as late as it helps, for width; else at the top of the first, for height
    bool dashes = false;  ///< where nothing else will do
};

/// Where to, as it is in this tick.
struct HopAim {
    dvec3 place{0, 0, 0};     ///< of feet
    dvec3 velocity{0, 0, 0};  ///< of the ground there [m/s]
};

class Hop {
public:
    explicit Hop(const HopStyle& style = {}) : style_(style) {}

    [[nodiscard]] Intent tick(const game::Hero& hero, const dvec3& feet, const CharacterSettings& settings,
                              const World& world, const HopAim& aim);

    [[nodiscard]] bool is_under_way() const { return jumped_ || left_ground_; }
    [[nodiscard]] int ticks() const { return ticks_; }

private:
    [[nodiscard]] bool ground_ends(const game::Hero& hero, const dvec3& feet, const World& world,
                                   const dvec3& way) const;

    HopStyle style_;
    int ticks_ = 0;
    int held_ = 0;         ///< 1: the button is held while it rises
    int presses_for_ = 0;  ///< ticks
    int released_ = 0;     ///< for so many ticks
    int air_jumps_ = 0;
    bool jumped_ = false;
    bool left_ground_ = false;
    bool dashed_ = false;
};

}  // namespace surefoot::playtest
