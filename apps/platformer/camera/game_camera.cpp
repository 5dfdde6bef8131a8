#include "platformer/camera/game_camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "platformer/camera/sight.hpp"
#include "platformer/hero/frame.hpp"
#include "platformer/hero/pose.hpp"

namespace surefoot::platformer {
namespace {

constexpr double lowest_pitch = -0.35;  // [rad]
constexpr double highest_pitch = 1.25;
constexpr double look_height = 0.55;     // of what it looks at, over the reference point [m]
constexpr double jump_room = 1.7;        // a jump of less than this leaves the height alone [m]
constexpr double fall_room = 0.5;        // a fall of less, too [m]
constexpr double ahead_time = 0.22;      // how far it looks ahead, as a part of the way that is run in it [s]
constexpr double most_ahead = 1.3;       // [m]
constexpr double drop_depth = 2.2;       // an edge with less below is none to look down from [m]
constexpr double drop_dip = 0.26;        // [rad]
constexpr double quick_in = 14;          // towards the hero [1/s]
constexpr double side_room = 2.2;        // farther away than this a wall at its side makes nothing narrow [m]
constexpr double corridor_share = 0.38;  // of the distance, that a corridor takes away
constexpr double fastest_eye = 26;       // relative to the hero [m/s]
constexpr double longest_hidden = 0.4;   // [s]
constexpr double fastest_in = 22;        // [m/s]
constexpr double steer_rate = 2.2;       // around what is about to come between [rad/s]
constexpr double slow_out = 1.6;         // [1/s]
constexpr double fastest_out = 5;        // [m/s]

dvec3 flat(const dvec3& v) {
    return {v.x, 0, v.z};
}

/// From the hero to the eye.
dvec3 outward(double yaw, double pitch) {
    return dvec3(0, std::sin(pitch), 0) - forward_of(yaw) * std::cos(pitch);
}

dvec3 anchor_of(const CameraTarget& target) {
    return target.position + dvec3(0, target.anchor, 0);
}

void turn(CameraState& s, const CameraTarget& target, const CameraSettings& settings, const CameraInput& input,
          const std::optional<CameraHint>& hint, double dt) {
    const bool turned_by_player = input.turn_left != 0 || input.turn_up != 0;
    s.since_turn = turned_by_player ? 0 : std::min(s.since_turn + dt, 1e9);
    s.yaw = std::remainder(s.yaw + input.turn_left, 2 * std::numbers::pi);
    s.pitch = std::clamp(s.pitch + input.turn_up, lowest_pitch, highest_pitch);
    double wanted_distance = settings.distance;
    if (input.behind) s.yaw += turn_between(s.yaw, target.facing) * eased(9, dt);
    if (s.since_turn >= settings.patience) {
        // It begins gently.
        const double will = std::min((s.since_turn - settings.patience) / 0.5, 1.0);
        if (hint) {
            s.yaw += turn_between(s.yaw, hint->yaw) * eased(2.2 * will, dt);
            s.pitch += (hint->pitch - s.pitch) * eased(1.8 * will, dt);
        } else if (settings.auto_turn > 0) {
            const dvec3 way = flat(target.velocity - target.carried);
            const double speed = glm::length(way);
            if (speed > 0.5) {
                // The sideways part of a run turns it, so that who runs towards it is left alone.
                const double off = turn_between(s.yaw, std::atan2(way.x, way.z));
                const double pull = std::sin(off) * std::min(speed / 6.5, 1.0);
                s.yaw += std::clamp(pull * settings.auto_turn * will, -2.0, 2.0) * dt;
                s.pitch += (settings.pitch - s.pitch) * eased(0.8 * will * std::min(speed / 6.5, 1.0), dt);
            }
        }
    }
    if (hint) wanted_distance = hint->distance;
    s.distance += (wanted_distance - s.distance) * eased(2.5, dt);
}

/// The height is that of the ground that was stood on last, and comes after it smoothly: neither stairs nor jumps are
/// seen in it.
void follow_height(CameraState& s, const CameraTarget& target, double dt) {
    const double now = target.position.y + (0.8 - target.half_height);
    const double carried = target.carried.y * dt;
    s.height += carried;
    s.floor += carried;
    if (target.on_ground) {
        s.floor = now;
    } else {
        s.floor = std::clamp(s.floor, now - jump_room, now + fall_room);
    }
    // Critically damped, and quicker the farther it is behind, so that a fall is not lost from sight.
    const double behind = s.floor - s.height;
    const double rate = 6.5 + 5 * std::clamp(std::abs(behind) - 0.6, 0.0, 2.0);
    const double push = rate * rate * behind - 2 * rate * s.height_speed;
    s.height_speed += push * dt;
    s.height += s.height_speed * dt;
    const double most = 2.5;
    s.height = std::clamp(s.height, now - most, now + most);
}

bool drop_ahead(const World& world, const CameraTarget& target, const WorldQuery& query) {
    const dvec3 way = flat(target.velocity - target.carried);
    const double speed = glm::length(way);
    if (!target.on_ground || speed < 0.5) return false;
    const dvec3 from = target.position + way / speed * (0.8 + 0.12 * speed);
    const dvec3 foot = target.position;
    WorldQuery now = query;
    now.begin = now.end = 1;
    if (world.ray_any({foot, from}, now)) return false;  // a wall is ahead, and no drop
    return !world.ray_any({from, from - dvec3(0, target.half_height + drop_depth, 0)}, now);
}

/// How much of the way is allowed, now and where the hero will be soon.
Sight look_ahead(const World& world, const CameraTarget& target, const dvec3& way, const WorldQuery& query) {
    const dvec3 anchor = anchor_of(target);
    const double length = glm::length(way);
    const dvec3 direction = way / length;
    Sight sight = look_back(world, anchor, direction, length, query);
    const dvec3 course = target.velocity - target.carried;
    for (const double soon : {0.10, 0.22, 0.36}) {
        const dvec3 step_to = anchor + dvec3(course.x, target.on_ground ? 0 : 0.5 * course.y, course.z) * soon;
        if (glm::length(step_to - anchor) < 0.05) continue;
        const dvec3 there = anchor + (step_to - anchor) * seen_share(world, anchor, step_to, query);
        const Sight then = look_back(world, there, direction, length, query);
        sight.allowed = std::min(sight.allowed, then.allowed + fastest_in * soon);
        if (std::abs(then.to_left) > std::abs(sight.to_left)) sight.to_left = then.to_left;
    }
    return sight;
}

/// No faster than it may, and through nothing. What it cannot follow quickly enough, because the hero went behind a
/// corner at its side, it loses from sight for a moment, and goes to where it saw it last; in the end it cuts.
void go_to(CameraState& s, const World& world, const dvec3& anchor, const dvec3& best, const WorldQuery& query,
           double dt) {
    const double most = fastest_eye * dt;
    const dvec3 along = moved_ball(world, s.eye, s.eye + (anchor - s.head), query);
    const bool lost = s.hidden > 0;
    const dvec3 to_best = best - along;
    if (glm::length(to_best) <= most && moved_ball(world, along, best, query) == best) {
        s.eye = best;
        s.hidden = 0;
        return;
    }
    const auto towards = [&](const dvec3& goal) {
        const dvec3 way = goal - along;
        const double length = glm::length(way);
        return moved_ball(world, along, length > most ? along + way * (most / length) : goal, query);
    };
    dvec3 next = towards(best);
    if (seen_share(world, anchor, next, query) < 1) {
        if (!lost) s.last_seen = s.head;
        next = towards(s.last_seen);
        const bool sees = seen_share(world, anchor, next, query) == 1;
        s.hidden = sees ? 0 : s.hidden + dt;
    } else {
        s.hidden = 0;
    }
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
}

/// How narrow it is where the hero stands, across the look: 1 between walls that nearly touch it, 0 in the open.
double narrowness(const CameraState& s, const World& world, const CameraTarget& target, const WorldQuery& query) {
    const dvec3 anchor = anchor_of(target);
    const dvec3 forward = forward_of(s.yaw);
    const dvec3 to_left(forward.z, 0, -forward.x);
    double width = 0;
    for (const double side : {1.0, -1.0})
        width += side_room * seen_share(world, anchor, anchor + to_left * (side * side_room), query);
    return std::clamp((2 * side_room - width) / (2 * side_room - 1.6), 0.0, 1.0);
}

void place_eye(CameraState& s, const World& world, const CameraTarget& target, const CameraSettings& settings,
               const WorldQuery& query, bool at_once, double dt) {
    const dvec3 anchor = anchor_of(target);
    s.look_at = flat(target.position) + dvec3(0, s.height + look_height, 0) + s.ahead;
    const double pitch = std::clamp(s.pitch + s.dip + s.rise, lowest_pitch, highest_pitch);
    s.narrow += (narrowness(s, world, target, query) - s.narrow) * (at_once ? 1 : eased(1.5, dt));
    // One wall beside the hero changes little, two are a corridor.
    const double distance = s.distance * (1 - corridor_share * s.narrow * s.narrow);
    const dvec3 wished = s.look_at + outward(s.yaw, pitch) * distance;
    const dvec3 way = wished - anchor;
    const double length = glm::length(way);
    if (!(length > 1e-6)) return;
    const Sight sight = look_ahead(world, target, way, query);
    const double allowed = sight.allowed / length;
    if (at_once) {
        s.share = allowed;
    } else if (allowed < s.share) {
        s.share += std::max((allowed - s.share) * eased(quick_in, dt), -fastest_in * dt / length);
    } else {
        s.share += std::min((allowed - s.share) * eased(slow_out, dt), fastest_out * dt / length);
    }
    // Whatever was eased: never beyond what is in the way.
    s.share = std::clamp(std::min(s.share, sight.free / length), 0.0, 1.0);
    s.share = roomy_share(world, anchor, wished, s.share, query);
    const dvec3 best = anchor + way * s.share;
    if (at_once) {
        s.eye = best;
        s.hidden = 0;
    } else {
        go_to(s, world, anchor, best, query, dt);
    }
    s.head = anchor;
    const double near = glm::length(s.eye - anchor);
    s.opacity = std::clamp((near - 0.75) / 0.7, 0.0, 1.0);
    // With a wall at its back it stands higher and looks over the hero.
    const double wanted_rise = 0.55 * std::clamp((3.0 - near) / 2.0, 0.0, 1.0);
    s.rise += (wanted_rise - s.rise) * eased(wanted_rise > s.rise ? 3 : 1.2, dt);
    // It goes out of the way of what is about to come between, as long as the player leaves that to it.
    const double steer = s.since_turn >= settings.patience ? sight.to_left : 0;
    s.steer += (steer - s.steer) * eased(8, dt);
    s.yaw = std::remainder(s.yaw + s.steer * steer_rate * dt, 2 * std::numbers::pi);
}

}  // namespace

CameraTarget target_of(const CharacterState& state, const CharacterSettings& settings, double facing, bool floats) {
    CameraTarget target;
    target.position = state.position;
    const bool is_carried = state.footing != Footing::air;
    target.carried = is_carried ? state.ground_velocity : dvec3(0);
    target.velocity = state.velocity + target.carried;
    target.half_height = half_height_of(settings, state.form);
    target.facing = facing;
    target.on_ground = state.footing != Footing::air || floats;
    target.dashes = settings.dash_speed > 0 && state.since_dash < settings.dash_time;
    // The ball has to be inside of the volume: for the hero's ellipsoids of 0.8 and 0.45 m that is at 0.35 and 0.15 m.
    target.anchor = std::clamp((target.half_height - 0.30) * 0.7, 0.0, 0.35);
    return target;
}

CameraState camera_behind(const World& world, const CameraTarget& target, const CameraSettings& settings, double yaw,
                          const WorldQuery& query) {
    CameraState s;
    s.yaw = yaw;
    s.pitch = settings.pitch;
    s.height = s.floor = target.position.y + (0.8 - target.half_height);
    s.distance = settings.distance;
    s.field_of_view = settings.field_of_view;
    s.target = target.position;
    place_eye(s, world, target, settings, query, true, 1.0 / 60);
    return s;
}

CameraState advance(const CameraState& state, const World& world, const CameraTarget& target,
                    const CameraSettings& settings, const CameraInput& input, const std::optional<CameraHint>& hint,
                    double dt, const WorldQuery& query) {
    if (!(dt > 0)) return state;
    if (glm::length(target.position - state.target) > teleport_distance) {
        CameraState there = camera_behind(world, target, settings, state.yaw, query);
        there.since_turn = state.since_turn;
        return there;
    }
    CameraState s = state;
    turn(s, target, settings, input, hint, dt);
    follow_height(s, target, dt);
    dvec3 ahead = settings.reduced_motion ? dvec3(0) : flat(target.velocity - target.carried) * ahead_time;
    const double far = glm::length(ahead);
    if (far > most_ahead) ahead *= most_ahead / far;
    s.ahead += (ahead - s.ahead) * eased(2.2, dt);
    const double dip = drop_ahead(world, target, query) ? drop_dip : 0;
    s.dip += (dip - s.dip) * eased(dip > s.dip ? 3.5 : 1.2, dt);
    const double kick = target.dashes && !settings.reduced_motion ? 0.16 : 0;
    s.widened += (kick - s.widened) * eased(kick > s.widened ? 18 : 5, dt);
    s.field_of_view = settings.field_of_view + s.widened;
    place_eye(s, world, target, settings, query, false, dt);
    s.target = target.position;
    return s;
}

view::Camera camera_between(const CameraState& before, const CameraState& after, double blend) {
    const bool teleported = glm::length(after.target - before.target) > teleport_distance;
    const double share = teleported ? 1 : blend;
    view::Camera camera;
    camera.eye = before.eye + (after.eye - before.eye) * share;
    const dvec3 at = before.look_at + (after.look_at - before.look_at) * share;
    dvec3 forward = at - camera.eye;
    // Near the hero the way to what it looks at may be short, or straight down.
    const double yaw = before.yaw + turn_between(before.yaw, after.yaw) * share;
    const double pitch = before.pitch + (after.pitch - before.pitch) * share;
    const dvec3 plain = -outward(yaw, std::clamp(pitch, lowest_pitch, highest_pitch));
    const double trust = std::clamp((glm::length(forward) - 0.8) / 1.2, 0.0, 1.0);
    forward = glm::length(forward) > 1e-6 ? glm::normalize(forward) : plain;
    camera.forward = glm::normalize(plain * (1 - trust) + forward * trust);
    camera.field_of_view = before.field_of_view + (after.field_of_view - before.field_of_view) * share;
    camera.nearest = 0.09;  // the corners of the picture are within the ball
    return camera;
}

}  // namespace surefoot::platformer
