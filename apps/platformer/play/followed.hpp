/// What of a game its camera is told: whom it follows, and how it likes to stand there.
#pragma once

#include <optional>

#include "game/game.hpp"
#include "platformer/camera/game_camera.hpp"

namespace surefoot::platformer {

/// `facing` as that of a hero's pose.
[[nodiscard]] CameraTarget followed(const game::Game& game, double facing);

/// As the level asks for where the hero is; none where it leaves that to the camera.
[[nodiscard]] std::optional<CameraHint> hint_at(const game::Level& level, const dvec3& place);

}  // namespace surefoot::platformer
