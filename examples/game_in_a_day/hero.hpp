// The hero, and how long a tick is.
#pragma once

#include <algorithm>
#include <glm/geometric.hpp>

#include <surefoot/surefoot.hpp>

namespace day {

using surefoot::dvec3;

// [hero]
constexpr double tick_seconds = 1.0 / 60;
constexpr double hero_half_height = 0.8;

inline surefoot::CharacterSettings hero_settings() {
    return {.volume = surefoot::Ellipsoid{{0.35, hero_half_height, 0.35}}, .jump_height = 1.5};
}

/// Where its feet are: the position of a body is that of its middle, and it is kept a skin above the ground.
inline dvec3 feet_of(const surefoot::CharacterState& state) {
    return state.position - dvec3{0, hero_half_height + hero_settings().skin, 0};
}

/// A character that stands at `place`.
inline surefoot::CharacterState standing_at(const dvec3& place) {
    return {.position = place + dvec3{0, hero_half_height + hero_settings().skin, 0}};
}
// [/hero]

// [towards]
/// The velocity of somebody who runs to `place`, level, and slows down before it.
inline dvec3 towards(const dvec3& from, const dvec3& place, double speed) {
    const dvec3 way{place.x - from.x, 0, place.z - from.z};
    const double distance = glm::length(way);
    return distance > 0 ? way * (std::min(speed, 8 * distance) / distance) : dvec3{0, 0, 0};
}
// [/towards]

}  // namespace day
