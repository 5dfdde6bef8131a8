#include "platformer/camera/placing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "platformer/camera/sight.hpp"
#include "platformer/camera/vantage.hpp"
#include "platformer/hero/frame.hpp"
#include "platformer/hero/pose.hpp"

namespace surefoot::platformer {
namespace {

constexpr double look_height = 0.55;     // of what it looks at, over the reference point [m]
constexpr double quick_in = 14;          // towards the hero [1/s]
constexpr double side_room = 2.2;        // farther away than this a wall at its side makes nothing narrow [m]
constexpr double corridor_share = 0.38;  // of the distance, that a corridor takes away
constexpr double fastest_eye = 26;       // relative to the hero [m/s]
constexpr double longest_hidden = 0.5;   // [s]
constexpr double stride = 0.4;           // from place to place of the trail [m]
constexpr double fastest_in = 22;        // [m/s]
constexpr double steer_rate = 2.2;       // around what is about to come between [rad/s]
constexpr double slow_out = 1.6;         // [1/s]
constexpr double quick_out = 5;          // [1/s]
constexpr double cramped_at = 1.7;       // nearer than that the hero fills the picture [m]
constexpr double fastest_out = 5;        // [m/s]
constexpr double seek_below = 0.55;      // of `worth_of`: another direction is looked for
constexpr double rest_above = 0.75;      // and the usual one is good enough again
constexpr double seek_yaw = 2.6;         // to where it sees better [rad/s]
constexpr double seek_rise = 2.2;        // likewise
constexpr double slightest = 0.45;       // a board, a post [m]
constexpr double longest_behind = 0.35;  // something like that, and then it goes where nothing is between [s]
constexpr double stays_strict = 1.0;     // once it was so, as long as its place would be behind something, and on [s]
constexpr double longest_veiled = 0.3;   // then it looks for another direction, too [s]
constexpr double quick_door = 8;         // [1/s]
constexpr double slow_door = 3;          // [1/s]
constexpr double fastest_rise = 1.5;     // of the head, where the hero stands up [m/s]
constexpr double fastest_crouch = 4;     // [m/s]
constexpr double lowest = -1.0;          // that it stands while it seeks [rad]
constexpr double highest = 1.3;

/// Where the eye stands about the hero: what is wished, and what was added to see better.
Vantage vantage_of(const CameraState& s) {
    return {s.yaw, std::clamp(s.pitch + s.dip + s.rise, lowest, highest)};
}

/// How thick something may be along a look that is looked through: nothing, where it has been for too long.
double slight_of(const CameraState& s) {
    return s.strict > 0 ? 0 : slightest;
}

/// Not so steep that a picture would not know where up is.
dvec3 upright(const dvec3& forward) {
    constexpr double steepest = 0.985;  // sine of 80 degrees
    if (std::abs(forward.y) <= steepest) return glm::normalize(forward);
    const double across = std::hypot(forward.x, forward.z);
    if (!(across > 1e-9)) return forward;
    const double flatten = std::sqrt(1 - steepest * steepest) / across;
    return {forward.x * flatten, std::copysign(steepest, forward.y), forward.z * flatten};
}

/// Where the head would be so much later, if it went on as it does; who stands rises no further [s].
dvec3 head_soon(const CameraTarget& target, const dvec3& head, double soon) {
    const dvec3 course = target.velocity - target.carried;
    return head + dvec3(course.x, target.on_ground ? 0 : 0.5 * course.y, course.z) * soon;
}

/// How much of the way is allowed, now and where the hero will be soon.
Sight look_ahead(const CameraScene& scene, const CameraTarget& target, const dvec3& anchor, const dvec3& way,
                 double slight, const WorldQuery& query) {
    const double length = glm::length(way);
    const dvec3 direction = way / length;
    Sight sight = look_back(scene.world, anchor, direction, length, slight, query);
    for (const double soon : {0.10, 0.22, 0.36}) {
        const dvec3 step_to = head_soon(target, anchor, soon);
        if (glm::length(step_to - anchor) < 0.05) continue;
        const dvec3 there = anchor + (step_to - anchor) * sight_share(scene.world, anchor, step_to, slight, query);
        const Sight then = look_back(scene.world, there, direction, length, slight, query);
        sight.allowed = std::min(sight.allowed, then.allowed + fastest_in * soon);
        if (std::abs(then.to_left) > std::abs(sight.to_left)) sight.to_left = then.to_left;
    }
    return sight;
}

/// Where the ball of the eye gets from `from` on its way after the hero, whom it does not see: to the latest place of
/// their head that it reaches.
dvec3 on_trail(const CameraState& s, const CameraScene& scene, const dvec3& from, const dvec3& moved, double most,
               const WorldQuery& query) {
    for (const dvec3& place : s.trail) {
        if (ball_share(scene.world, from, place, query) < 1) continue;
        const double length = glm::length(place - from);
        if (!(length > 1e-9)) continue;
        const dvec3 way = (place - from) / length;
        // So far that it moves by `most` relative to the hero, who moved too.
        const double with = glm::dot(way, moved);
        const double reach = with + std::sqrt(std::max(most * most - glm::dot(moved, moved) + with * with, 0.0));
        return from + way * std::clamp(reach, 0.0, length);
    }
    return from;
}

/// No faster than it may, and through nothing. What it cannot follow quickly enough, because the hero went behind a
/// corner at its side, it loses from sight for a moment, and goes after them; in the end it cuts.
void go_to(CameraState& s, const CameraScene& scene, const dvec3& anchor, const dvec3& best, const WorldQuery& query,
           double dt) {
    const World& world = scene.world;
    const double slight = slight_of(s);
    const double most = fastest_eye * dt;
    const dvec3 along = moved_ball(world, s.eye, s.eye + (anchor - s.head), query);
    const dvec3 to_best = best - along;
    if (glm::length(to_best) <= most && moved_ball(world, along, best, query) == best) {
        s.eye = best;
        s.hidden = 0;
        return;
    }
    const double share = std::min(most / std::max(glm::length(to_best), 1e-9), 1.0);
    dvec3 next = moved_ball(world, along, along + to_best * share, query);
    if (sight_share(world, anchor, next, slight, query) < 1) {
        next = on_trail(s, scene, s.eye, anchor - s.head, most, query);
        s.hidden = sight_share(world, anchor, next, slight, query) < 1 ? s.hidden + dt : 0;
    } else {
        s.hidden = 0;
    }
    next = pushed_out(world, next, query);
    const bool has_room = roomy_share(world, anchor, next, 1, query) == 1;
    if (s.hidden > longest_hidden || !has_room) {
        next = best;
        s.hidden = 0;
    }
    s.eye = next;
    // It orbits on from where it is, and not from where it would have liked to be.
    const dvec3 looks = flat(anchor - s.eye);
    if (glm::length(looks) > 0.4 && s.since_turn > 0)
        s.yaw += turn_between(s.yaw, std::atan2(looks.x, looks.z)) * eased(6, dt);
    const dvec3 out = s.eye - s.look_at;
    if (s.hidden > 0 && glm::length(out) > 0.4) {
        const double stands = std::asin(std::clamp(out.y / glm::length(out), -1.0, 1.0));
        s.rise += (stands - vantage_of(s).pitch) * eased(6, dt);
    }
}

/// How narrow it is where the hero stands, across the look: 1 between walls that nearly touch it, 0 in the open.
double narrowness(const CameraState& s, const CameraScene& scene, const dvec3& anchor, const WorldQuery& query) {
    const dvec3 forward = forward_of(s.yaw);
    const dvec3 to_left(forward.z, 0, -forward.x);
    double width = 0;
    for (const double side : {1.0, -1.0})
        width += side_room * seen_share(scene.world, anchor, anchor + to_left * (side * side_room), query);
    return std::clamp((2 * side_room - width) / (2 * side_room - 1.6), 0.0, 1.0);
}

/// Towards what it looks at, but never so that the hero leaves the picture: from near its edge on it turns with them.
dvec3 framed(const CameraState& s, const CameraTarget& target) {
    // Near the hero the way to what it looks at may be short, or straight down.
    const dvec3 plain = -outward(vantage_of(s));
    const dvec3 way = s.look_at - s.eye;
    const double trust = std::clamp((glm::length(way) - 0.8) / 1.2, 0.0, 1.0);
    const dvec3 wished = trust > 0 ? plain * (1 - trust) + glm::normalize(way) * trust : plain;
    const dvec3 forward = glm::length(wished) > 1e-6 ? glm::normalize(wished) : plain;
    const dvec3 to_hero = target.position - s.eye;
    const double away = glm::length(to_hero);
    if (!(away > 0.3)) return forward;
    const double room = std::max(0.46 * s.field_of_view - std::atan2(target.half_height, away), 0.05);
    const dvec3 hero = to_hero / away;
    const double angle = std::acos(std::clamp(glm::dot(forward, hero), -1.0, 1.0));
    const double free = 0.6 * room;
    if (angle <= free) return upright(forward);
    // An eye that is nearly in the hero has no way to turn after them.
    const double firm = std::clamp((away - 0.3) / 0.7, 0.0, 1.0);
    const double bounded = free + (room - free) * std::tanh((angle - free) / (room - free));
    const double kept = angle + (bounded - angle) * firm;
    const dvec3 aside = forward - hero * glm::dot(forward, hero);
    if (!(glm::length(aside) > 1e-9)) return upright(hero);
    return upright(hero * std::cos(kept) + glm::normalize(aside) * std::sin(kept));
}

/// Turns to where there is more room and sight, if there is too little; and back, up and down, where there is enough.
void seek(CameraState& s, const Surroundings& around, const CameraSettings& settings, double dt) {
    const Vantage now = vantage_of(s);
    const Vantage usual{s.yaw, std::clamp(s.pitch + s.dip, lowest, highest)};
    const double here = worth_of(reach(around, now), around.distance);
    const double there = worth_of(reach(around, usual), around.distance);
    const bool by_hand = s.since_turn < settings.patience;
    if (here < seek_below || s.hidden > 0.1 || s.veiled > longest_veiled)
        s.seeks = true;
    else if (there > rest_above && s.veiled == 0)
        s.seeks = false;
    double turn = 0;
    double rise = there > rest_above ? 0 : s.rise;
    if (s.seeks) {
        const auto chosen = s.has_goal ? std::optional<Vantage>({s.goal_yaw, s.goal_pitch}) : std::nullopt;
        const Vantage goal = best_vantage(around, usual, by_hand, chosen);
        s.has_goal = true;
        s.goal_yaw = goal.yaw;
        s.goal_pitch = goal.pitch;
        // Where the hero fills the picture there is little to be seen of a turn.
        const double most = seek_yaw * (1 + std::clamp((cramped_at - s.share * around.distance) / 0.5, 0.0, 1.0));
        turn = std::clamp(4 * turn_between(s.yaw, goal.yaw), -most, most);
        rise = goal.pitch - usual.pitch;
    } else {
        s.has_goal = false;
    }
    s.seek += (turn - s.seek) * eased(10, dt);
    s.yaw = std::remainder(s.yaw + s.seek * dt, 2 * std::numbers::pi);
    const double step = (rise - s.rise) * eased(s.seeks ? 5 : 1.2, dt);
    s.rise += std::clamp(step, -seek_rise * dt, seek_rise * dt);
}

/// Where the eye starts from: a hero who stands up lifts it slowly, and one who crouches lowers it as slowly as the
/// roof allows.
dvec3 eased_head(CameraState& s, const CameraScene& scene, const CameraTarget& target, const WorldQuery& query,
                 bool at_once, double dt) {
    const dvec3 feet = target.position - dvec3(0, target.half_height, 0);
    const double wanted = target.half_height + target.anchor;
    if (at_once) {
        s.head_height = wanted;
    } else {
        s.head_height += std::clamp(wanted - s.head_height, -fastest_crouch * dt, fastest_rise * dt);
        const dvec3 head = feet + dvec3(0, s.head_height, 0);
        if (s.head_height > wanted && ball_share(scene.world, feet + dvec3(0, wanted, 0), head, query) < 1)
            s.head_height = wanted;
    }
    return feet + dvec3(0, s.head_height, 0);
}

/// How much of the hero is behind something that is drawn, for how long, and what is done about it.
void look_through(CameraState& s, const Surroundings& around, bool at_once, double dt) {
    const int veiled = veiled_points(around, s.eye);
    std::array<Overlap, 1> leaves;
    s.in_leaves = around.decor != nullptr && around.decor->overlap(Sphere{leaves_reach}, s.eye, leaves) > 0;
    s.veiled = veiled >= 3 ? s.veiled + dt : 0;
    const double door = veiled >= 2 ? 1 : 0;
    s.door = at_once ? door : std::clamp(s.door + (door > s.door ? quick_door : -slow_door) * dt, 0.0, 1.0);
}

}  // namespace

void place_eye(CameraState& s, const CameraScene& scene, const CameraTarget& target, const CameraSettings& settings,
               bool at_once, double dt) {
    const auto is_solid = [&](std::uint32_t, std::uint32_t, std::uint32_t surface) {
        return !scene.surfaces[surface].one_way;
    };
    const WorldQuery query{.triangles = is_solid, .begin = 1, .end = 1};
    const dvec3 anchor = eased_head(s, scene, target, query, at_once, dt);
    s.look_at = flat(target.position) + dvec3(0, s.height + look_height, 0) + s.ahead;
    s.narrow += (narrowness(s, scene, anchor, query) - s.narrow) * (at_once ? 1 : eased(1.5, dt));
    // One wall beside the hero changes little, two are a corridor.
    const double distance = s.distance * (1 - corridor_share * s.narrow * s.narrow);
    const dvec3 step_to = head_soon(target, anchor, 0.25);
    const double slight = slight_of(s);
    const double free = sight_share(scene.world, anchor, step_to, slight, query);
    const Surroundings around{.world = scene.world,
                              .decor = scene.decor,
                              .slight = slight,
                              .query = query,
                              .head = anchor,
                              .soon = anchor + (step_to - anchor) * free,
                              .middle = target.position,
                              .half_height = target.half_height,
                              .look_at = s.look_at,
                              .distance = distance};
    if (!at_once) seek(s, around, settings, dt);
    const dvec3 wished = s.look_at + outward(vantage_of(s)) * distance;
    const dvec3 way = wished - anchor;
    const double length = glm::length(way);
    if (!(length > 1e-6)) return;
    const Sight sight = look_ahead(scene, target, anchor, way, slight, query);
    const double allowed = sight.allowed / length;
    if (at_once) {
        s.share = allowed;
    } else if (allowed < s.share) {
        s.share += std::max((allowed - s.share) * eased(quick_in, dt), -fastest_in * dt / length);
    } else {
        // From where the hero fills the picture it goes sooner.
        const double cramped = std::clamp((cramped_at - s.share * length) / 0.5, 0.0, 1.0);
        s.share += std::min((allowed - s.share) * eased(slow_out + quick_out * cramped, dt), fastest_out * dt / length);
    }
    // Whatever was eased: never beyond what is in the way.
    s.share = std::clamp(std::min(s.share, sight.free / length), 0.0, 1.0);
    s.share = roomy_share(scene.world, anchor, wished, s.share, query);
    const dvec3 best = anchor + way * s.share;
    if (at_once) {
        s.eye = best;
        s.hidden = 0;
    } else {
        go_to(s, scene, anchor, best, query, dt);
    }
    s.head = anchor;
    s.behind = seen_share(scene.world, anchor, s.eye, query) < 1 ? s.behind + dt : 0;
    if (s.behind > longest_behind || (s.strict > 0 && seen_share(scene.world, anchor, wished, query) < 1))
        s.strict = stays_strict;
    else
        s.strict = std::max(s.strict - dt, 0.0);
    if (at_once) s.trail.fill(anchor);
    if (glm::length(anchor - s.trail[0]) > stride) {
        std::copy_backward(s.trail.begin(), s.trail.end() - 1, s.trail.end());
        s.trail[0] = anchor;
    }
    look_through(s, around, at_once, dt);
    const double near = glm::length(s.eye - anchor);
    s.opacity = std::clamp((near - 0.45) / 0.4, 0.0, 1.0);
    s.forward = framed(s, target);
    // It goes out of the way of what is about to come between, as long as the player leaves that to it.
    const double steer = s.since_turn >= settings.patience && !s.seeks ? sight.to_left : 0;
    s.steer += (steer - s.steer) * eased(8, dt);
    s.yaw = std::remainder(s.yaw + s.steer * steer_rate * dt, 2 * std::numbers::pi);
}

}  // namespace surefoot::platformer
