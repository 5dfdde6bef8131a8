// A camera that follows the hero and is never inside of anything.
#pragma once

#include <cmath>

#include "hero.hpp"

namespace day {

// [camera]
struct Camera {
    double yaw = 0;        // radians: 0 looks north, -Z; a quarter turn to the left looks west
    double pitch = -0.35;  // radians: below 0 it looks down
    double length = 6;     // m, from the hero's head: as it is now
    dvec3 target{0, 0, 0};

    [[nodiscard]] dvec3 forward() const { return {-std::sin(yaw), 0, -std::cos(yaw)}; }
    [[nodiscard]] dvec3 right() const { return {std::cos(yaw), 0, -std::sin(yaw)}; }
    [[nodiscard]] dvec3 view() const { return forward() * std::cos(pitch) + dvec3{0, std::sin(pitch), 0}; }
    [[nodiscard]] dvec3 eye() const { return target - view() * length; }
};

/// After each tick. It comes near at once, so that no wall is between; it goes away again slowly, so that it does not
/// jump.
inline void follow(Camera& camera, const surefoot::World& world, const dvec3& hero) {
    constexpr double wanted = 6;
    const surefoot::Sphere lens{.radius = 0.2};  // wider than the picture where it begins, 0.1 m before the eye
    camera.target = hero + dvec3{0, 0.5, 0};     // the lens fits into the hero there, so it begins in nothing else
    const surefoot::Motion back{camera.target, camera.target - camera.view() * wanted};
    const auto hit = world.sweep(lens, back, {.begin = 1, .end = 1});  // as the world stands at the end of the tick
    const double room = hit ? hit->t * wanted : wanted;
    camera.length = glm::min(room, camera.length + 3 * tick_seconds);
}
// [/camera]

}  // namespace day
