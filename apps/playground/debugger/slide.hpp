/// Collide and slide as textbooks have it, to compare shapes with: sweep, stop a skin short, remove the part of the
/// motion that leads into what was hit, go on with the rest. It is the simplest that works, and it has the flaws that
/// the simplest has: it creeps down slopes, and it knows no steps.
#pragma once

#include <vector>

#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

#include "debugger/arena.hpp"

namespace surefoot::debugger {

struct SlideSettings {
    double skin = 0.005;           ///< how far from everything it stops, along the normal [m]
    int passes = 4;                ///< how often a move may be turned aside
    double gravity = 9.81;         ///< [m/s^2]
    double tick = 1.0 / 60;        ///< [s]
    double flattest_ground = 0.5;  ///< a normal that points up by at least this is ground, and ends a fall
    bool one_sided = false;        ///< triangles exist for what comes from their front only
};

/// Where a move ended.
struct Slid {
    dvec3 position{0, 0, 0};
    std::vector<dvec3> normals;  ///< of what turned it aside, in order
};

/// One move. It looks two skins further than it goes, so that it stops a skin short of what it meets at 30 degrees or
/// more, and a part of a skin short of what it meets at less.
[[nodiscard]] Slid slide(const Arena& arena, const Volume& volume, const dvec3& from, const dvec3& way,
                         const SlideSettings& settings = {});

struct Mover {
    dvec3 position{0, 0, 0};
    double fall_speed = 0;  ///< downwards [m/s]
    bool on_ground = false;
};

/// One tick: first the wish, then the fall. Depends on its arguments alone.
[[nodiscard]] Mover tick(const Arena& arena, const Volume& volume, const Mover& mover, const dvec3& wish,
                         const SlideSettings& settings = {});

/// `ticks` of them in a row; the first place is the start.
[[nodiscard]] std::vector<Mover> track(const Arena& arena, const Volume& volume, const dvec3& start, const dvec3& wish,
                                       int ticks, const SlideSettings& settings = {});

}  // namespace surefoot::debugger
