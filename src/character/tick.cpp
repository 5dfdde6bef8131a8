#include "character/tick.hpp"

#include "angle.hpp"
#include "character/body.hpp"
#include "character/contacts.hpp"
#include "character/form.hpp"
#include "character/recover.hpp"

namespace surefoot::internal {

namespace {

StepResult finish(Tick& tick) noexcept {
    weigh(tick);
    CharacterState& after = tick.state;
    after.position = to_dvec3(tick.position);
    after.velocity = to_dvec3(tick.velocity);
    after.footing = tick.standing                           ? Footing::ground
                    : tick.ground.footing == Footing::steep ? Footing::steep
                                                            : Footing::air;
    if (tick.standing) {
        after.since_ground = 0;
        after.air_jumps_left = tick.settings.air_jumps;
    }
    if (after.hold != Hold::none) {
        after.footing = Footing::ledge;
        after.ground_normal = {0, 0, 0};
        after.ground_velocity = {0, 0, 0};
        return {after, tick.events, tick.contacts};
    }
    const bool carried = after.footing != Footing::air;
    after.ground_normal = carried ? to_dvec3(tick.ground.normal) : dvec3{0, 0, 0};
    after.ground_velocity = carried ? to_dvec3(velocity_at(tick, tick.ground.body, tick.ground.point)) : dvec3{0, 0, 0};
    after.ground_body = carried ? tick.ground.body : 0;
    after.ground_triangle = carried ? tick.ground.triangle : 0;
    after.ground_surface = carried ? tick.ground.surface : 0;
    return {after, tick.events, tick.contacts};
}

}  // namespace

Tick::Tick(const TickArguments& arguments) noexcept
    : settings(arguments.settings),
      input(arguments.input),
      hooks(arguments.hooks),
      whole(arguments.tick),
      part(arguments.part),
      dt(whole * (part.end - part.begin)),
      up(to_vec(input.up) / length(to_vec(input.up))),
      wish(level(to_vec(input.wish))),
      body(body_of(volume_of(settings, arguments.state.form), settings.skin, up)),
      neighbours(body, settings.skin, arguments.neighbours),
      surroundings(arguments.world, WorldQuery{.begin = part.end, .end = part.end}, settings.surfaces, settings.skin,
                   neighbours, arguments.trace),
      state(arguments.state),
      position(to_vec(state.position)),
      velocity(to_vec(state.velocity) + to_vec(input.impulse)) {
    gait.up = up;
    gait.least_ground_up = cosine_deg(settings.slope_limit_deg);
    gait.skin = settings.skin;
    gait.stops = settings.response == Response::stop;
}

void Tick::tell(StepRecord record) const noexcept {
    surroundings.tell([&] {
        record.position = to_dvec3(position);
        return record;
    });
}

void Tick::tell(StepAct act, const Ground& about, double value) const noexcept {
    tell({.point = to_dvec3(about.point),
          .normal = to_dvec3(about.normal),
          .value = about.rule == StepRule::none ? value : about.value,
          .limit = about.limit,
          .triangle = about.triangle,
          .body = about.body,
          .act = act,
          .rule = about.rule});
}

void Tick::glide(const Vec& way, const Vec& velocity_after) noexcept {
    tell({.motion = to_dvec3(way), .act = StepAct::wants});
    const SlideResult slid =
        slide(surroundings, body, answered_by(gait, hooks.respond, velocity_after), position, way, {});
    position = slid.position;
    velocity =
        slid.answered ? slid.planes.nearest_to(*slid.answered) : velocity_along(slid.planes, gait, velocity_after);
    if (slid.overflow) {
        say(CharacterEvent::overflow);
        velocity = {};  // it stays where it is, and gathers no speed meanwhile
    }
    if (slid.met_ceiling) say(CharacterEvent::hit_ceiling);
    tell_obstacle(slid.obstacle);
    press(*this, {slid.met.data(), slid.met_count}, velocity_after);
}

void Tick::tell_obstacle(const Obstacle& obstacle) noexcept {
    if (obstacle.normal == Vec{}) return;
    const double rises = dot(obstacle.normal, up);
    if (rises >= gait.least_ground_up) return;
    say(CharacterEvent::blocked);
    if (obstacle.is_neighbour) say(CharacterEvent::met_neighbour);
    events.blocked_by = to_dvec3(obstacle.normal);
    events.blocked_body = obstacle.body;
    events.blocked_triangle = obstacle.triangle;
    if (absolute(rises) < wall_rises_at_most && !obstacle.is_neighbour) {
        state.wall_normal = to_dvec3(obstacle.normal);
        state.since_wall = 0;
    }
}

namespace {

// What is longer ago than anybody asks for is not counted any more: else no state would ever be the same again.
void forget(Tick& tick) noexcept {
    const CharacterSettings& settings = tick.settings;
    double horizon = larger(remembered_for, 2 * tick.dt);
    for (const double window : {settings.coyote_time, settings.jump_buffer, settings.wall_coyote_time,
                                settings.dash_time + settings.dash_pause}) {
        horizon = larger(horizon, window);
    }
    CharacterState& state = tick.state;
    for (double* const since :
         {&state.since_ground, &state.since_jump_press, &state.since_wall, &state.since_dash, &state.since_hold}) {
        if (*since > horizon) *since = larger(long_ago, 2 * horizon);
    }
}

}  // namespace

void remember_buttons(Tick& tick) noexcept {
    CharacterState& state = tick.state;
    state.since_jump_press += tick.dt;
    if (tick.input.jump && state.jump_held == 0) state.since_jump_press = 0;
    state.jump_held = tick.input.jump ? 1 : 0;
    for (double* const since : {&state.since_ground, &state.since_wall, &state.since_dash, &state.since_hold}) {
        *since += tick.dt;
    }
    forget(tick);
}

void ride(Tick& tick) noexcept {
    const BodyHandle support =
        tick.state.footing == Footing::air ? BodyHandle{} : tick.world().find(tick.state.ground_body);
    const Carried carried = carry(tick.surroundings, tick.body, tick.gait, tick.position, support, tick.part);
    if (carried.moved) {
        tick.tell({.motion = to_dvec3(carried.position - tick.position),
                   .body = tick.state.ground_body,
                   .act = StepAct::carried});
    }
    tick.position = carried.position;
    if (carried.pushed) tick.say(CharacterEvent::pushed);
    if (!carried.crushed) return;
    tick.say(CharacterEvent::crushed);
    tick.tell({.act = StepAct::crushed});
}

void look_around(Tick& tick) noexcept {
    const CharacterSettings& settings = tick.settings;
    // Steps look farther ahead and up, and gather again; most ticks have none.
    const double speed = larger(length(tick.velocity), length(to_vec(tick.input.wish)));
    const double way = (speed + settings.gravity * tick.dt) * tick.dt + 3 * settings.skin;
    if (way > 4 * tick.body.size()) return;
    const bool on_foot = tick.state.footing == Footing::ground;
    // After the way, a look down for the ground to be followed.
    const double deep = way + (on_foot ? settings.snap_down + 3 * settings.skin : 0);
    (void)tick.surroundings.cover_if_few(tick.body.around(tick.position, tick.up * (way - deep), way));
}

void get_out(Tick& tick) noexcept {
    const Recovery recovery = recover(tick.surroundings, tick.body, tick.gait, tick.position, recovery_speed * tick.dt);
    if (recovery.moved) {
        tick.say(CharacterEvent::recovered);
        tick.tell({.motion = to_dvec3(recovery.position - tick.position), .act = StepAct::recovered});
    }
    tick.position = recovery.position;
    if (recovery.overflow) tick.say(CharacterEvent::overflow);
    if (!recovery.stuck) return;
    tick.say(CharacterEvent::stuck);
    tick.tell({.act = StepAct::stuck});
}

void part(Tick& tick) noexcept {
    if (tick.neighbours.empty()) return;
    tick.neighbours.place(tick.world(), tick.position, tick.velocity, tick.whole, tick.part);
    if (tick.neighbours.overflow()) tick.say(CharacterEvent::overflow);
    const Neighbours::Parting parting =
        tick.neighbours.way_apart(tick.position, recovery_speed * tick.dt, soft_parting_speed * tick.dt);
    const Vec way = tick.state.footing == Footing::ground ? tick.level(parting.way) : parting.way;
    if (way == Vec{}) return;
    const Vec before = tick.position;
    tick.position = slide(tick.surroundings, tick.body, tick.gait, before, way, {}).position;
    tick.tell({.motion = to_dvec3(tick.position - before),
               .value = parting.depth,
               .body = parting.id,
               .act = StepAct::parted});
}

StepResult tick_once(const TickArguments& arguments) noexcept {
    Tick now(arguments);
    remember_buttons(now);
    ride(now);
    look_around(now);
    get_out(now);
    change_form(now);
    part(now);
    if (arguments.input.mode != CharacterMode::walk) {
        move_freely(now);
        return finish(now);
    }
    stand(now);
    if (hold_ledge(now)) return finish(now);
    leap(now);
    if (climb(now)) return finish(now);
    if (now.standing) {
        go_on_foot(now, now.dt);
    } else {
        fall(now, now.dt);
    }
    return finish(now);
}

}  // namespace surefoot::internal
