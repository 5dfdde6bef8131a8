#include "playground/debugger_room/drawn_world.hpp"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "debugger/support.hpp"

namespace surefoot::playground {
namespace {

Bounds both(const Bounds& a, const Bounds& b) {
    return {glm::min(a.min, b.min), glm::max(a.max, b.max)};
}

}  // namespace

DrawnWorld real_world(const Volume& volume) {
    return {.volume = volume};
}

DrawnWorld world_beside(const Volume& volume, const Motion& motion, double s, const dvec3& offset) {
    DrawnWorld world{.squash = debugger::squash_at(volume, s, motion.from), .offset = offset};
    world.volume = Volume(Ellipsoid{world.squash.radii}, world.squash.orientation);
    return world;
}

Bounds bounds_in(const DrawnWorld& world, const Motion& motion, std::span<const Triangle> triangles) {
    Bounds bounds = both(debugger::bounds_of(world.volume, world.point(motion.from)),
                         debugger::bounds_of(world.volume, world.point(motion.to)));
    for (const Triangle& t : triangles)
        for (const dvec3& corner : {t.a, t.b, t.c})
            bounds = both(bounds, debugger::bounds_of(world.volume, world.point(corner)));
    return bounds;
}

dvec3 offset_beside(const Volume& volume, const Motion& motion, std::span<const Triangle> triangles,
                    const std::optional<Bounds>& level) {
    constexpr int steps = 16;
    Bounds real = bounds_in(real_world(volume), motion, triangles);
    if (level) real = both(real, *level);
    Bounds beside = bounds_in(world_beside(volume, motion, 0, {0, 0, 0}), motion, triangles);
    for (int i = 1; i <= steps; ++i)
        beside = both(beside, bounds_in(world_beside(volume, motion, double(i) / steps, {0, 0, 0}), motion, triangles));
    // Of its own size, for a level may be any: wide enough for what lies between two steps, too.
    const double air = 0.12 * glm::length(beside.max - beside.min);
    if (level) return {0, real.max.y - beside.min.y + air, 0};
    return {0, real.min.y - beside.max.y - air, 0};
}

}  // namespace surefoot::playground
