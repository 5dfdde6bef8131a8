#include "platformer/camera/game_camera.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "platformer/camera/placing.hpp"
#include "platformer/hero/frame.hpp"
#include "platformer/hero/pose.hpp"

namespace surefoot::platformer {
namespace {

constexpr double lowest_pitch = -0.35;  // [rad]
constexpr double highest_pitch = 1.25;
constexpr double jump_room = 1.7;    // a jump of less than this leaves the height alone [m]
constexpr double fall_room = 0.5;    // a fall of less, too [m]
constexpr double ahead_time = 0.22;  // how far it looks ahead, as a part of the way that is run in it [s]
constexpr double most_ahead = 1.3;   // [m]
constexpr double drop_depth = 2.2;   // an edge with less below is none to look down from [m]
constexpr double drop_dip = 0.26;    // [rad]

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

bool drop_ahead(const CameraScene& scene, const CameraTarget& target) {
    const dvec3 way = flat(target.velocity - target.carried);
    const double speed = glm::length(way);
    if (!target.on_ground || speed < 0.5) return false;
    const dvec3 from = target.position + way / speed * (0.8 + 0.12 * speed);
    const dvec3 foot = target.position;
    const WorldQuery now{.begin = 1, .end = 1};
    if (scene.world.ray_any({foot, from}, now)) return false;  // a wall is ahead, and no drop
    return !scene.world.ray_any({from, from - dvec3(0, target.half_height + drop_depth, 0)}, now);
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

CameraState camera_behind(const CameraScene& scene, const CameraTarget& target, const CameraSettings& settings,
                          double yaw) {
    CameraState s;
    s.yaw = yaw;
    s.pitch = settings.pitch;
    s.height = s.floor = target.position.y + (0.8 - target.half_height);
    s.distance = settings.distance;
    s.field_of_view = settings.field_of_view;
    s.target = target.position;
    place_eye(s, scene, target, settings, true, 1.0 / 60);
    return s;
}

CameraState advance(const CameraState& state, const CameraScene& scene, const CameraTarget& target,
                    const CameraSettings& settings, const CameraInput& input, const std::optional<CameraHint>& hint,
                    double dt) {
    if (!(dt > 0)) return state;
    if (glm::length(target.position - state.target) > teleport_distance) {
        CameraState there = camera_behind(scene, target, settings, state.yaw);
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
    const double dip = drop_ahead(scene, target) ? drop_dip : 0;
    s.dip += (dip - s.dip) * eased(dip > s.dip ? 3.5 : 1.2, dt);
    const double kick = target.dashes && !settings.reduced_motion ? 0.16 : 0;
    s.widened += (kick - s.widened) * eased(kick > s.widened ? 18 : 5, dt);
    s.field_of_view = settings.field_of_view + s.widened;
    place_eye(s, scene, target, settings, false, dt);
    s.target = target.position;
    return s;
}

view::Camera camera_between(const CameraState& before, const CameraState& after, double blend) {
    const bool teleported = glm::length(after.target - before.target) > teleport_distance;
    const double share = teleported ? 1 : blend;
    view::Camera camera;
    camera.eye = before.eye + (after.eye - before.eye) * share;
    const dvec3 forward = before.forward + (after.forward - before.forward) * share;
    camera.forward = glm::length(forward) > 1e-6 ? glm::normalize(forward) : after.forward;
    camera.field_of_view = before.field_of_view + (after.field_of_view - before.field_of_view) * share;
    camera.nearest = 0.09;  // the corners of the picture are within the ball
    return camera;
}

}  // namespace surefoot::platformer
