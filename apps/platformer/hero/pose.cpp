#include "platformer/hero/pose.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <variant>

#include "platformer/hero/act.hpp"
#include "platformer/hero/frame.hpp"

namespace surefoot::platformer {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double image_pause = 0.045;  // between two after-images [s]

double yaw_of(const dvec3& direction) {
    return std::atan2(direction.x, direction.z);
}

bool is_on_feet(HeroAct act) {
    return act == HeroAct::idle || act == HeroAct::run || act == HeroAct::crouch;
}

struct LowestPoint {
    double operator()(const Sphere& s) const { return s.radius; }
    double operator()(const Ellipsoid& e) const { return e.radii.y; }
    double operator()(const Capsule& c) const { return c.radius + c.half_height; }
    double operator()(const Box& b) const { return b.half_extents.y; }
    double operator()(const Cylinder& c) const { return c.half_height; }
    double operator()(const Cone&) const { return 0; }
};

/// Where it would like to look: along its way, or at what holds it.
double wanted_facing(const HeroPose& pose, HeroAct act, const CharacterState& after) {
    const dvec3 wall = flat(after.wall_normal);
    const bool has_wall = glm::length(wall) > 0.3;
    if (act == HeroAct::hang || act == HeroAct::climb || (act == HeroAct::ladder && after.since_wall < 0.2))
        return has_wall ? yaw_of(-wall) : pose.facing;
    if (act == HeroAct::wall_slide) {
        // Along the wall, on the side that is nearer to how it looked before.
        const dvec3 along(wall.z, 0, -wall.x);
        const double one = yaw_of(along);
        const double other = yaw_of(-along);
        return std::abs(turn_between(pose.facing, one)) < std::abs(turn_between(pose.facing, other)) ? one : other;
    }
    if (act == HeroAct::hurt || act == HeroAct::dead || act == HeroAct::win) return pose.facing;
    const dvec3 way = flat(after.velocity);
    return glm::length(way) > 0.4 ? yaw_of(way) : pose.facing;
}

void turn_and_lean(HeroPose& pose, const HeroPose& last, const CharacterState& after, const dvec3& acceleration,
                   double dt) {
    const double rate = pose.act == HeroAct::dash || pose.act == HeroAct::hang ? 30 : 13;
    const double wanted = wanted_facing(last, pose.act, after);
    const double turn = turn_between(last.facing, wanted) * eased(rate, dt);
    pose.facing = std::remainder(last.facing + turn, 2 * pi);
    const dvec3 forward = forward_of(pose.facing);
    const dvec3 to_left(forward.z, 0, -forward.x);
    const bool free_to_lean = is_on_feet(pose.act) || pose.act == HeroAct::jump || pose.act == HeroAct::fall;
    const double speed = glm::length(flat(after.velocity));
    const double limit = pose.reduced_motion ? 0.12 : 0.30;
    const double push = glm::dot(acceleration, forward);
    const double wanted_forward = free_to_lean ? std::clamp(0.006 * push + 0.008 * speed, -limit, limit) : 0;
    const double into_turn = turn / dt * speed * 0.012 + 0.004 * glm::dot(acceleration, to_left);
    const double wanted_left = free_to_lean ? std::clamp(into_turn, -limit, limit) : 0;
    pose.lean_forward += (wanted_forward - pose.lean_forward) * eased(10, dt);
    pose.lean_left += (wanted_left - pose.lean_left) * eased(9, dt);
    const double ahead = speed > 0.4 && free_to_lean ? turn_between(pose.facing, yaw_of(flat(after.velocity))) : 0;
    pose.look_left += (std::clamp(ahead, -0.9, 0.9) - pose.look_left) * eased(12, dt);
    const double up = pose.act == HeroAct::fall || pose.act == HeroAct::jump ? after.velocity.y * 0.02 : 0;
    pose.look_up += (std::clamp(up, -0.35, 0.3) - pose.look_up) * eased(8, dt);
}

void squash_and_stretch(HeroPose& pose, const CharacterState& after, const CharacterEvents& events, double dt) {
    if (pose.reduced_motion) {
        pose.squash = pose.squash_speed = 0;
        return;
    }
    constexpr double stiffness = 24 * 24;  // of the spring [1/s^2]
    constexpr double friction = 2 * 24 * 0.34;
    if (events.has(CharacterEvent::landed)) pose.squash_speed -= 0.75 * std::min(events.landing_speed, 16.0);
    if (events.has(CharacterEvent::jumped)) pose.squash_speed += 4.5;
    const bool in_air = pose.act == HeroAct::jump || pose.act == HeroAct::fall;
    const double rest = in_air ? std::clamp(std::abs(after.velocity.y) * 0.010, 0.0, 0.14) : 0;
    pose.squash_speed += (-stiffness * (pose.squash - rest) - friction * pose.squash_speed) * dt;
    pose.squash = std::clamp(pose.squash + pose.squash_speed * dt, -0.40, 0.35);
    if (pose.act == HeroAct::slide || pose.act == HeroAct::hang) pose.squash *= 1 - eased(20, dt);
}

/// How far it came, in strides, strokes or rungs.
void count_strides(HeroPose& pose, const CharacterState& after, double dt) {
    const double speed = glm::length(flat(after.velocity));
    if (is_on_feet(pose.act)) {
        // What stands begins its first stride with a foot that has just been put down.
        if (pose.act == HeroAct::idle) pose.stride = std::floor(pose.stride) + 0.1;
        if (speed > 0.3) pose.stride += speed * dt / stride_length(speed);
    } else if (pose.act == HeroAct::ladder) {
        pose.stride += after.velocity.y * dt / 0.68;
    }
    if (pose.act == HeroAct::hang) {
        const dvec3 forward = forward_of(pose.facing);
        const dvec3 to_left(forward.z, 0, -forward.x);
        pose.shimmy += glm::dot(after.velocity, to_left) * dt / 0.60;
    }
}

/// One hand stays where it holds the edge while the other goes ahead.
double grip_offset(double shimmy, int side) {
    const double turn = shimmy + (side == on_left ? 0 : 0.5);
    const double phase = turn - std::floor(turn);
    if (phase < 0.5) return 0.60 * (0.25 - phase);
    const double share = (phase - 0.5) * 2;
    return 0.60 * (-0.25 + 0.5 * share * share * (3 - 2 * share));
}

void hold_edge(Stance& wanted, const HeroPose& pose, const CharacterState& after, const Frame& frame) {
    for (const int side : {on_left, on_right}) {
        dvec3 grip = frame.to_local(after.ledge_point);
        grip.x +=
            (side == on_left ? 0.20 : -0.20) + (pose.act == HeroAct::hang ? grip_offset(pose.shimmy, side) * 0.4 : 0);
        grip.y += 0.02;
        grip.z -= 0.03;                                                    // it lies over the edge
        const bool in_reach = glm::length(grip - dvec3(0, 0.9, 0)) < 1.4;  // no arm is longer
        if (in_reach) wanted.hands[side] = grip;
    }
}

void leave_images(HeroPose& pose, const Frame& frame, double dt) {
    for (AfterImage& image : pose.images) image.age += dt;
    pose.since_image += dt;
    if (pose.act != HeroAct::dash || pose.reduced_motion || pose.since_image < image_pause) return;
    std::rotate(pose.images.begin(), pose.images.end() - 1, pose.images.end());
    pose.images[0] = {frame, pose.stance, 0};
    pose.since_image = 0;
}

dvec3 knot_of(const HeroPose& pose, const Frame& frame) {
    const dmat3 body = pitched(pose.stance.pitch + pose.lean_forward) * rolled(pose.stance.roll + pose.lean_left);
    return frame.at(pose.stance.body + pose.stance.head * 0.7 + body * dvec3(0, 0.27, -0.17));
}

void place_feet(HeroPose& pose, const HeroPose& last, const CharacterState& after, const Frame& frame, double dt) {
    if (is_on_feet(pose.act)) {
        const dvec3 carried = after.footing == Footing::air ? dvec3(0) : after.ground_velocity * dt;
        const double wide = pose.act == HeroAct::crouch ? 0.17 : 0.13;
        const dvec3 normal = after.footing == Footing::air ? dvec3(0, 1, 0) : after.ground_normal;
        pose.feet =
            advance(last.feet, {pose.soles, carried, normal, pose.facing, after.velocity, pose.stride, wide}, dt);
        for (std::size_t i = 0; i < 2; ++i) {
            pose.stance.feet[i] = frame.to_local(pose.feet[i].at);
            pose.stance.toes[i] = pose.feet[i].toes;
        }
        return;
    }
    for (std::size_t i = 0; i < 2; ++i)
        pose.feet[i] = {frame.at(pose.stance.feet[i]), dvec3(0), 0, pose.stance.toes[i]};
}

}  // namespace

double half_height_of(const CharacterSettings& settings, CharacterForm form) {
    const Volume* volume = &settings.volume;
    if (form == CharacterForm::crouched && settings.crouched) volume = &*settings.crouched;
    if (form == CharacterForm::in_air && settings.in_air) volume = &*settings.in_air;
    if (form == CharacterForm::on_ramp && settings.on_ramp) volume = &*settings.on_ramp;
    if (form == CharacterForm::on_ledge && settings.on_ledge) volume = &*settings.on_ledge;
    return std::visit(LowestPoint{}, volume->shape);
}

Frame standing_frame(const HeroPose& pose) {
    return {turned(pose.facing), pose.soles};
}

HeroPose hero_at(const CharacterState& state, const CharacterSettings& settings, double facing) {
    HeroPose pose;
    pose.soles = state.position - dvec3(0, half_height_of(settings, state.form) + settings.skin, 0);
    pose.facing = facing;
    pose.velocity = state.velocity;
    const Frame frame = standing_frame(pose);
    for (std::size_t i = 0; i < 2; ++i) pose.feet[i].at = frame.at(pose.stance.feet[i]);
    pose.scarf = hanging_scarf(knot_of(pose, frame), -forward_of(facing));
    return pose;
}

HeroPose advance(const HeroPose& last, const CharacterState& before, const CharacterState& after,
                 const CharacterEvents& events, const CharacterSettings& settings, const HeroFlags& flags, double dt) {
    if (!(dt > 0)) return last;
    if (glm::length(after.position - before.position) > teleport_distance) {
        HeroPose there = hero_at(after, settings, last.facing);
        there.clock = last.clock;
        return there;
    }
    HeroPose pose = last;
    pose.clock += dt;
    pose.reduced_motion = flags.reduced_motion;
    pose.untouchable = flags.untouchable;
    pose.since_hurt = flags.hurt ? 0 : std::min(pose.since_hurt + dt, long_ago);
    pose.facing += flags.turned_by;
    // It is drawn on the ground, not a skin above it.
    pose.soles = after.position - dvec3(0, half_height_of(settings, after.form) + settings.skin, 0);
    pose.velocity = after.velocity;
    pose.act = act_of(last, before, after, events, settings, flags);
    pose.act_time = pose.act == last.act ? last.act_time + dt : 0;
    turn_and_lean(pose, pose, after, (after.velocity - before.velocity) / dt, dt);
    squash_and_stretch(pose, after, events, dt);
    count_strides(pose, after, dt);
    // A jump in the air is a somersault.
    const bool air_jump = events.has(CharacterEvent::jumped) && before.footing == Footing::air &&
                          before.since_ground > settings.coyote_time;
    if (air_jump && !pose.reduced_motion) pose.flip = 2 * pi;
    const bool may_flip = pose.act == HeroAct::jump || pose.act == HeroAct::fall;
    pose.flip = may_flip ? std::max(pose.flip - dt * (4 + 2.2 * pose.flip), 0.0) : 0;
    const Frame frame = standing_frame(pose);
    if (pose.act == HeroAct::wall_slide) pose.wall_side = glm::dot(frame.axes[0], after.wall_normal) < 0 ? 1 : -1;
    const double speed = pose.act == HeroAct::swim ? glm::length(after.velocity) : glm::length(flat(after.velocity));
    Stance wanted = stance_of(pose.act, {pose.act_time, pose.clock, pose.stride, speed, after.velocity.y,
                                         pose.wall_side, pose.reduced_motion});
    const bool holds = pose.act == HeroAct::hang || pose.act == HeroAct::climb;
    if (holds) hold_edge(wanted, pose, after, frame);
    const double rate = pose.act == HeroAct::idle ? 14 : holds || pose.act == HeroAct::dead ? 30 : 20;
    pose.stance = mixed(last.stance, wanted, eased(rate, dt));
    place_feet(pose, last, after, frame, dt);
    leave_images(pose, frame, dt);
    pose.scarf = advance(last.scarf, knot_of(pose, frame), frame.at(pose.stance.body), 0.27, pose.soles.y + 0.03,
                         pose.act == HeroAct::swim ? 7 : 2.6, pose.clock, dt);
    return pose;
}

HeroPose between(const HeroPose& a, const HeroPose& b, double share) {
    if (glm::length(b.soles - a.soles) > teleport_distance) return b;
    const auto mix = [&](const auto& x, const auto& y) { return x + (y - x) * share; };
    HeroPose pose = b;
    pose.soles = mix(a.soles, b.soles);
    pose.facing = a.facing + turn_between(a.facing, b.facing) * share;
    pose.lean_forward = mix(a.lean_forward, b.lean_forward);
    pose.lean_left = mix(a.lean_left, b.lean_left);
    pose.squash = mix(a.squash, b.squash);
    // A somersault that begins is not turned back from its end.
    pose.flip = b.flip > a.flip ? b.flip : mix(a.flip, b.flip);
    pose.look_left = mix(a.look_left, b.look_left);
    pose.look_up = mix(a.look_up, b.look_up);
    pose.clock = mix(a.clock, b.clock);
    pose.act_time = a.act == b.act ? mix(a.act_time, b.act_time) : b.act_time * share;
    pose.stance = mixed(a.stance, b.stance, share);
    for (std::size_t i = 0; i < 2; ++i) {
        pose.feet[i].at = mix(a.feet[i].at, b.feet[i].at);
        pose.feet[i].toes = mix(a.feet[i].toes, b.feet[i].toes);
    }
    for (std::size_t i = 0; i < scarf_points; ++i) pose.scarf.now[i] = mix(a.scarf.now[i], b.scarf.now[i]);
    return pose;
}

}  // namespace surefoot::platformer
