/// Light around what shines in a level, and on the ground below it.
#pragma once

#include <vector>

#include "game/level.hpp"
#include "view/renderer.hpp"

namespace surefoot::platformer {

/// Found once: each still thing whose material shines strongly has a halo, and a pool of light where there is ground a
/// little below it.
[[nodiscard]] std::vector<view::Disc> halos_of(const game::Level& level);

/// Those near the eye, `strength` [0 to 1] of the way.
void draw_halos(view::Renderer& renderer, const std::vector<view::Disc>& halos, double strength);

}  // namespace surefoot::platformer
