/// What the display over the picture is told of a run.
#pragma once

#include "platformer/hud/hud.hpp"
#include "platformer/play/run.hpp"
#include "platformer/screens/screens.hpp"

namespace surefoot::platformer {

[[nodiscard]] HudView hud_of(const Run& run, const Screens& screens, const view::Camera& camera,
                             const view::ivec2& window);

/// The level from above, for the minimap.
[[nodiscard]] Plan plan_of(const game::Level& level);

}  // namespace surefoot::platformer
