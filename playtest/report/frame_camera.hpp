/// From where a frame of a run is seen: behind the hero, as the game's camera stands, by where the player looks.
#pragma once

#include "game/game.hpp"

namespace surefoot::playtest {

struct FrameCamera {
    dvec3 eye{0, 0, 0};        ///< [m]
    dvec3 forward{0, 0, -1};   ///< unit
    dvec3 right{1, 0, 0};      ///< unit, level
    dvec3 up{0, 1, 0};         ///< unit
    double field_of_view = 1;  ///< of the picture's height [rad]
};

/// `input`: of the tick that the game has just done; its look is the player's. Who looks level, as bots do, gets the
/// height at which the camera likes to stand. The eye comes nearer where something is between it and the hero; where
/// there is no room behind the hero, it looks down from above.
[[nodiscard]] FrameCamera frame_camera(const game::Game& game, const game::HeroInput& input);

}  // namespace surefoot::playtest
