// On foot, through the air, through water, up a ladder: how a wish becomes a way.
#include <algorithm>

#include "character/contacts.hpp"
#include "character/look.hpp"
#include "character/motion.hpp"
#include "character/tick.hpp"
#include "character/walk.hpp"

namespace surefoot::internal {

namespace {

// How fast the belt that it stands on carries it.
Vec conveyor_velocity(const Tick& tick, const SurfaceRule& rule) noexcept {
    const BodyHandle handle = tick.world().find(tick.ground.body);
    if (to_vec(rule.conveyor) == Vec{} || !tick.world().contains(handle)) return {};
    const Pose pose = tick.world().poses(handle).end;
    return tick.level(to_vec(to_world(pose, rule.conveyor)) - to_vec(pose.position));
}

bool dashes(const Tick& tick) noexcept {
    return tick.state.since_dash < tick.settings.dash_time;
}

// Pressed against a wall and coming down, friction holds it back.
double slowest_fall(const Tick& tick) noexcept {
    const Vec wall = to_vec(tick.state.wall_normal);
    const bool presses = tick.state.since_wall <= 2 * tick.dt && dot(wall, tick.wish) < 0;
    return presses && tick.settings.wall_slide_speed > 0
               ? smaller(tick.settings.wall_slide_speed, tick.settings.terminal_speed)
               : tick.settings.terminal_speed;
}

void tell_left_ground(const Tick& tick) noexcept {
    if (tick.ground.footing == Footing::steep) return tick.tell(StepAct::left_ground, tick.ground);
    if (!tick.surroundings.is_traced()) return;
    Ground below = look_down(tick.surroundings, tick.body, tick.gait, tick.position);
    below.rule = StepRule::snap_distance;
    below.value = below.distance;
    below.limit = tick.settings.snap_down;
    tick.tell(StepAct::left_ground, below);
}

}  // namespace

void go_on_foot(Tick& tick, double seconds) noexcept {
    const CharacterSettings& settings = tick.settings;
    const Vec before = tick.level(tick.velocity);
    const SurfaceRule rule = settings.surfaces[tick.ground.surface];
    const double rate = dot(tick.wish, tick.wish) < dot(before, before) ? settings.braking : settings.acceleration;
    Travel travel = accelerate(before, dashes(tick) ? before : tick.wish, rate * rule.grip, seconds);
    travel.way = travel.way + conveyor_velocity(tick, rule) * seconds;
    tick.tell({.motion = to_dvec3(travel.way), .act = StepAct::wants});
    Gait on_foot = tick.gait;
    on_foot.on_foot = true;
    const WalkResult walked = walk(tick.surroundings, tick.body, on_foot, settings, tick.hooks.respond, tick.position,
                                   tick.ground, travel.way, travel.velocity);
    tick.position = walked.position;
    tick.velocity = walked.velocity;
    tick.ground = walked.ground;
    if (walked.stepped_up) tick.say(CharacterEvent::stepped_up);
    if (walked.snapped_down) tick.say(CharacterEvent::snapped_down);
    if (walked.overflow) tick.say(CharacterEvent::overflow);
    if (walked.met_ceiling) tick.say(CharacterEvent::hit_ceiling);
    tick.tell_obstacle(walked.obstacle);
    press(tick, {walked.met.data(), walked.met_count}, travel.velocity);
    if (tick.ground.footing == Footing::ground) return;
    tick.standing = false;
    tick.velocity = tick.velocity + left_behind(tick);
    tick.say(CharacterEvent::left_ground);
    tell_left_ground(tick);
    const double left = seconds * (1 - walked.done);
    tick.state.since_ground = left;
    if (left > 0) fall(tick, left);
}

void fall(Tick& tick, double seconds) noexcept {
    const CharacterSettings& settings = tick.settings;
    const double speed = dot(tick.velocity, tick.up);
    const bool cut = tick.state.is_jumping != 0 && !tick.input.jump;
    const double rising = settings.gravity * (cut ? settings.jump_cut : 1);
    Flight flight{speed, speed * seconds};
    if (!dashes(tick)) {
        const double terminal = slowest_fall(tick);
        // What falls faster than a wall lets it is braked at once.
        flight = fly(larger(speed, terminal < settings.terminal_speed ? -terminal : speed), rising, settings.gravity,
                     terminal, seconds);
    }
    const Vec before = tick.level(tick.velocity);
    const Travel travel = accelerate(before, dashes(tick) ? before : tick.wish, settings.air_acceleration, seconds);
    tick.glide(travel.way + tick.up * flight.rise, travel.velocity + tick.up * flight.speed);
    // A slope that is met in the air does not make it rise faster than it did of itself: else it would skim up the
    // slope for as long as it walks up it, and what rises does not land.
    const double lift = dot(tick.velocity, tick.up) - larger(0, flight.speed);
    if (lift > 0 && !tick.hooks.respond) tick.velocity = tick.velocity - tick.up * lift;
    if (dot(tick.velocity, tick.up) <= 0) tick.state.is_jumping = 0;
    land(tick, flight.speed);
}

void move_freely(Tick& tick) noexcept {
    const CharacterSettings& settings = tick.settings;
    tick.state.is_jumping = 0;
    drop_ledge(tick);
    if (tick.input.mode == CharacterMode::own) {
        const OwnMotion answer = tick.hooks.move({.position = to_dvec3(tick.position),
                                                  .velocity = to_dvec3(tick.velocity),
                                                  .wish = tick.input.wish,
                                                  .up = to_dvec3(tick.up),
                                                  .dt = tick.dt});
        return tick.glide(finite_or_none(answer.way), finite_or_none(answer.velocity));
    }
    const bool swims = tick.input.mode == CharacterMode::swim;
    const Vec asked = to_vec(tick.input.wish);
    const double rate = swims ? settings.swim_acceleration : settings.fly_acceleration;
    const Vec drift = swims ? tick.up * -settings.sink_speed : Vec{};
    const Travel travel = accelerate(tick.velocity, asked == Vec{} ? drift : asked, rate, tick.dt);
    tick.glide(travel.way, travel.velocity);
}

bool climb(Tick& tick) noexcept {
    const CharacterSettings& settings = tick.settings;
    if (settings.ladder_speed <= 0 || tick.wish == Vec{} || tick.state.is_jumping != 0) return false;
    const auto rules = settings.surfaces.all();
    if (std::none_of(rules.begin(), rules.end(), [](const SurfaceRule& rule) { return rule.ladder; })) return false;
    // What is ladder within two skins ahead?
    const Vec ahead = tick.wish / length(tick.wish);
    Touches touches;
    const Vec probe = ahead * (2 * settings.skin);
    if (!tick.surroundings.cover(tick.body.around(tick.position, {}, 3 * settings.skin))) return false;
    tick.surroundings.sweep(tick.body, tick.position, probe, touches);
    std::size_t place = 0;
    while (const Touch* next = touches.at(place++)) {
        const Touch& touch = *next;
        const SourceTriangle triangle = tick.surroundings.triangle(touch.index);
        const double towards = -dot(touch.normal, ahead);
        if (touch.status != HitStatus::ok || !settings.surfaces[triangle.surface].ladder || towards < 0.5) continue;
        const double speed = tick.input.crouch ? -settings.ladder_speed : settings.ladder_speed;
        // On the ground the way down ends.
        if (tick.standing && speed < 0) return false;
        const Vec velocity = tick.wish + tick.up * speed;
        tick.glide(velocity * tick.dt, velocity);
        tick.standing = false;
        tick.ground = {};
        tick.state.since_ground = 0;
        tick.say(CharacterEvent::climbing);
        return true;
    }
    return false;
}

}  // namespace surefoot::internal
