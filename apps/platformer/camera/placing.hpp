/// Where the eye of a game's camera gets in one tick, and which way it looks from there.
#pragma once

#include "platformer/camera/game_camera.hpp"

namespace surefoot::platformer {

/// Puts the eye where the state wants it as far as there is room and sight, `at_once` or as fast as it may.
void place_eye(CameraState& s, const CameraScene& scene, const CameraTarget& target, const CameraSettings& settings,
               bool at_once, double dt);

}  // namespace surefoot::platformer
