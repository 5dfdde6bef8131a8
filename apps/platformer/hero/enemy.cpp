#include "platformer/hero/enemy.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "platformer/hero/frame.hpp"

namespace surefoot::platformer {

EnemyPose enemy_at(EnemyKind kind, const dvec3& soles, double facing, double clock) {
    EnemyPose pose;
    pose.kind = kind;
    pose.soles = soles;
    pose.facing = facing;
    pose.clock = clock;
    return pose;
}

EnemyPose advance(const EnemyPose& last, const EnemySight& sight, bool reduced_motion, double dt) {
    if (!(dt > 0)) return last;
    EnemyPose pose = last;
    pose.clock += dt;
    pose.soles = sight.soles;
    pose.reduced_motion = reduced_motion;
    pose.mood = sight.mood;
    pose.mood_time = sight.mood == last.mood ? last.mood_time + dt : 0;
    pose.since_fire = sight.fires ? 0 : std::min(last.since_fire + dt, 1e9);
    const bool alert = sight.mood == EnemyMood::notice || sight.mood == EnemyMood::attack;
    const dvec3 to_hero = sight.looks_at - sight.soles - dvec3(0, 0.8, 0);
    const double level = std::hypot(to_hero.x, to_hero.z);
    const double speed = std::hypot(sight.velocity.x, sight.velocity.z);
    double facing = last.facing;
    if (alert && level > 0.1) {
        facing = std::atan2(to_hero.x, to_hero.z);
    } else if (speed > 0.2) {
        facing = std::atan2(sight.velocity.x, sight.velocity.z);
    }
    if (sight.mood != EnemyMood::stomped)
        pose.facing =
            std::remainder(last.facing + turn_between(last.facing, facing) * eased(9, dt), 2 * std::numbers::pi);
    const double pitch = alert && level > 0.1 ? std::clamp(std::atan2(to_hero.y, level), -0.7, 0.9) : 0;
    pose.pitch += (pitch - pose.pitch) * eased(8, dt);
    pose.alarm += ((sight.mood == EnemyMood::attack ? 1 : 0) - pose.alarm) * eased(7, dt);
    if (sight.on_ground) pose.stride += speed * dt;
    if (reduced_motion) {
        pose.squash = pose.squash_speed = 0;
    } else {
        const bool lands = sight.on_ground && !last.on_ground;
        const bool leaps = !sight.on_ground && last.on_ground && sight.velocity.y > 0;
        if (lands) pose.squash_speed -= 5.5;
        if (leaps) pose.squash_speed += 5;
        if (sight.mood == EnemyMood::notice && last.mood != EnemyMood::notice) pose.squash_speed += 5;
        pose.squash_speed += (-24.0 * 24 * pose.squash - 15 * pose.squash_speed) * dt;
        pose.squash = std::clamp(pose.squash + pose.squash_speed * dt, -0.35, 0.35);
    }
    pose.on_ground = sight.on_ground;
    return pose;
}

EnemyPose between(const EnemyPose& a, const EnemyPose& b, double share) {
    EnemyPose pose = b;
    const auto mix = [&](const auto& x, const auto& y) { return x + (y - x) * share; };
    if (glm::length(b.soles - a.soles) < 3) pose.soles = mix(a.soles, b.soles);
    pose.facing = a.facing + turn_between(a.facing, b.facing) * share;
    pose.clock = mix(a.clock, b.clock);
    pose.stride = mix(a.stride, b.stride);
    pose.squash = mix(a.squash, b.squash);
    pose.alarm = mix(a.alarm, b.alarm);
    pose.pitch = mix(a.pitch, b.pitch);
    if (a.mood == b.mood) pose.mood_time = mix(a.mood_time, b.mood_time);
    return pose;
}

void draw(view::Renderer& renderer, const EnemyPose& before, const EnemyPose& after, double blend) {
    std::vector<view::Piece> pieces;
    pieces.reserve(40);
    add_pieces(pieces, between(before, after, blend));
    for (const view::Piece& p : pieces) renderer.piece(p);
}

}  // namespace surefoot::platformer
