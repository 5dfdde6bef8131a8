// An enemy that finds its way to the hero.
#pragma once

#include <surefoot/navigation_build.hpp>
#include <surefoot/navigation_follow.hpp>
#include <surefoot/navigation_mesh.hpp>
#include <surefoot/navigation_query.hpp>

#include "level.hpp"

namespace day {

// [ground]
/// The ground of the still level, for feet like the hero's; enemies have the same body.
inline surefoot::Expected<surefoot::NavigationMesh> find_ground(const Level& level) {
    surefoot::World still;
    if (const auto added = still.add(level.still); !added) return tl::unexpected(added.error());
    return surefoot::NavigationMesh::build(still, hero_settings());
}
// [/ground]

// [enemy]
constexpr double enemy_sight = 9;    // m
constexpr double enemy_speed = 3.5;  // m/s; the hero runs 6

struct Enemy {
    dvec3 home;
    surefoot::CharacterState state = standing_at(home);
    surefoot::CharacterState before = state;
    surefoot::NavigationFollower follower{surefoot::NavigationFollowOptions{.speed = enemy_speed}};
};

/// One tick: after the prey if it is in sight, else home.
inline void move_enemy(Enemy& enemy, const surefoot::World& world, const surefoot::NavigationQuery& ground,
                       const dvec3& prey) {
    const bool sees = glm::distance(feet_of(enemy.state), prey) < enemy_sight;
    enemy.follower.go(ground, sees ? prey : enemy.home);
    enemy.before = enemy.state;
    const surefoot::CharacterSettings settings = hero_settings();
    const auto input = enemy.follower.input(ground, enemy.state, settings, tick_seconds);
    enemy.state = surefoot::step(world, settings, input, tick_seconds, enemy.state).state;
}
// [/enemy]

// [meet]
enum class Meeting { none, stomped, caught };

/// Who comes down on a head stomps on it; whose feet are lower than that is caught.
inline Meeting meet(const Enemy& enemy, const surefoot::CharacterState& hero) {
    const dvec3 apart = hero.position - enemy.state.position;
    const bool is_beside = glm::length(dvec3{apart.x, 0, apart.z}) < 0.8;
    if (!is_beside || glm::abs(apart.y) > 2 * hero_half_height) return Meeting::none;
    if (apart.y < hero_half_height) return Meeting::caught;
    return hero.velocity.y < 0 ? Meeting::stomped : Meeting::none;
}
// [/meet]

}  // namespace day
