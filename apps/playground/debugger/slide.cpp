#include "debugger/slide.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace surefoot::debugger {

Slid slide(const Arena& arena, const Volume& volume, const dvec3& from, const dvec3& way,
           const SlideSettings& settings) {
    Slid slid{from, {}};
    dvec3 rest = way;
    for (int pass = 0; pass < settings.passes; ++pass) {
        const double length = glm::length(rest);
        if (length == 0) break;
        const dvec3 direction = rest / length;
        const double looked = length + 2 * settings.skin;
        const auto hit = arena.sweep(volume, {slid.position, slid.position + direction * looked}, settings.one_sided);
        if (hit && hit->status != HitStatus::ok) break;
        const double approach = hit ? -glm::dot(direction, hit->normal) : 0;
        const double go = approach > 0 ? std::max(0.0, hit->t * looked - settings.skin / approach) : length;
        if (go >= length) {
            slid.position += rest;
            break;
        }
        slid.position += direction * go;
        slid.normals.push_back(hit->normal);
        rest = direction * (length - go);
        rest -= hit->normal * std::min(0.0, glm::dot(hit->normal, rest));
    }
    return slid;
}

Mover tick(const Arena& arena, const Volume& volume, const Mover& mover, const dvec3& wish,
           const SlideSettings& settings) {
    const Slid walked = slide(arena, volume, mover.position, wish * settings.tick, settings);
    const double speed = mover.fall_speed + settings.gravity * settings.tick;
    const Slid fallen = slide(arena, volume, walked.position, {0, -speed * settings.tick, 0}, settings);
    Mover after{fallen.position, speed, false};
    after.on_ground = std::any_of(fallen.normals.begin(), fallen.normals.end(),
                                  [&](const dvec3& normal) { return normal.y >= settings.flattest_ground; });
    if (after.on_ground) after.fall_speed = 0;
    return after;
}

std::vector<Mover> track(const Arena& arena, const Volume& volume, const dvec3& start, const dvec3& wish, int ticks,
                         const SlideSettings& settings) {
    std::vector<Mover> places{Mover{.position = start}};
    for (int i = 0; i < ticks; ++i) places.push_back(tick(arena, volume, places.back(), wish, settings));
    return places;
}

}  // namespace surefoot::debugger
