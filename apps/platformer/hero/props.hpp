/// What lies about in a level: to collect, to reach, to beware of. All of it is a function of the time.
#pragma once

#include <surefoot/math.hpp>
#include <surefoot/world.hpp>

#include "view/renderer.hpp"

namespace surefoot::platformer {

struct PropMoment {
    double clock = 0;   ///< [s]
    double shown = 1;   ///< 1: it is there; less: it was taken and shrinks [0 to 1]
    bool calm = false;  ///< reduced motion: it turns, but does not bob
};

/// A disc that spins; the middle is at `place`. Each a little later than the one before it, by where it is.
void draw_coin(view::Renderer& renderer, const dvec3& place, const PropMoment& moment);

/// With five points. One that was found in an earlier run is pale.
void draw_star(view::Renderer& renderer, const dvec3& place, const PropMoment& moment, bool found_before = false);

void draw_heart(view::Renderer& renderer, const dvec3& place, const PropMoment& moment);

void draw_key(view::Renderer& renderer, const dvec3& place, const PropMoment& moment, view::Colour colour);

/// A pole with a flag; `raised` is how high that is [0 to 1]. The foot is at `place`.
void draw_checkpoint(view::Renderer& renderer, const dvec3& place, const PropMoment& moment, double raised);

/// A beacon of rings that rise; `open`: one may go through. The foot is at `place`.
void draw_goal(view::Renderer& renderer, const dvec3& place, const PropMoment& moment, double radius, bool open = true);

void draw_bullet(view::Renderer& renderer, const dvec3& place, const dvec3& velocity, double radius);

/// A round shade on the ground under what jumps, so that one sees where it will land. `reach` is how far below the
/// soles ground is looked for [m].
void draw_ground_shade(view::Renderer& renderer, const World& world, const dvec3& soles, double radius,
                       double reach = 12, const WorldQuery& query = {});

}  // namespace surefoot::platformer
