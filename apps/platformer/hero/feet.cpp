#include "platformer/hero/feet.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "platformer/hero/frame.hpp"
#include "platformer/hero/stance.hpp"

namespace surefoot::platformer {
namespace {

constexpr double step_time = 0.16;      // of a small step to stand better [s]
constexpr double bad_footing = 0.10;    // from where it would stand: worth a step [m]
constexpr double reach = 0.75;          // no leg is longer [m]
constexpr double standing_speed = 0.3;  // [m/s]

/// How high the ground is at a place near the walker, by its slope.
double ground_at(const Walk& walk, const dvec3& place) {
    const dvec3 away = place - walk.place;
    const dvec3& n = walk.ground_normal;
    if (n.y < 0.3) return walk.place.y;
    return walk.place.y - std::clamp((n.x * away.x + n.z * away.z) / n.y, -0.3, 0.3);
}

dvec3 on_ground(const Walk& walk, dvec3 place) {
    place.y = ground_at(walk, place);
    return place;
}

/// Goes down to the ground quickly, but not in one tick.
void settle(Foot& foot, const Walk& walk, double dt) {
    foot.at.y += (ground_at(walk, foot.at) - foot.at.y) * eased(30, dt);
    foot.toes += (0 - foot.toes) * eased(20, dt);
}

void swing_to(Foot& foot, const Walk& walk, const dvec3& target, double share, double height) {
    const double s = share * share * (3 - 2 * share);
    foot.swing = share;
    foot.at = walk.place + foot.from + (target - walk.place - foot.from) * s;
    foot.at.y = std::max(foot.at.y, ground_at(walk, foot.at)) + height * std::sin(std::numbers::pi * share);
    foot.toes = height * (share < 0.5 ? 5.5 : -2.0) * std::sin(2 * std::numbers::pi * std::min(share, 1 - share));
}

}  // namespace

Feet advance(const Feet& feet, const Walk& walk, double dt) {
    Feet next = feet;
    const double speed = glm::length(flat(walk.velocity));
    const dvec3 to_left(std::cos(walk.facing), 0, -std::sin(walk.facing));
    const bool stands = speed < standing_speed;
    const dvec3 along = stands ? dvec3(0) : flat(walk.velocity) / speed;
    const double share = ground_share(speed);
    for (std::size_t i = 0; i < 2; ++i) {
        Foot& foot = next[i];
        foot.at += walk.carried;
        const dvec3 hip = walk.place + to_left * (i == 0 ? walk.wide : -walk.wide);
        if (stands) {
            const bool other_swings = next[1 - i].swing > 0;
            const double off = glm::length(flat(foot.at - hip));
            if (foot.swing == 0 && off > bad_footing && !other_swings) {
                foot.from = foot.at - walk.place;
                foot.swing = 1e-6;
            }
            if (foot.swing > 0 && foot.swing < 1) {
                swing_to(foot, walk, on_ground(walk, hip), std::min(foot.swing + dt / step_time, 1.0), 0.06);
            }
            if (foot.swing >= 1) foot.swing = 0;
            if (foot.swing == 0) settle(foot, walk, dt);
            continue;
        }
        const double length = stride_length(speed);
        const double turn = walk.stride + (i == 0 ? 0 : 0.5);
        const double phase = turn - std::floor(turn);
        const bool too_far = glm::length(flat(foot.at - hip)) > reach;
        if (phase < share && foot.swing == 0 && !too_far) {
            settle(foot, walk, dt);
        } else if (phase < share) {
            // Its turn to stand: it is put down where it is, or where it belongs if it was left far behind.
            if (too_far) foot.at = hip + along * (length * (share / 2 - phase));
            foot.at = on_ground(walk, foot.at);
            foot.swing = 0;
            foot.toes = 0;
        } else {
            if (foot.swing == 0) foot.from = foot.at - walk.place;
            const double progress = std::clamp((phase - share) / (1 - share), 1e-6, 1.0);
            const dvec3 target = on_ground(walk, hip + along * (length * share / 2));
            swing_to(foot, walk, target, progress, 0.05 + 0.028 * std::min(speed, 7.0));
        }
    }
    return next;
}

}  // namespace surefoot::platformer
