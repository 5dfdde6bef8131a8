// Is there ground? Standing, landing, and what ground that moves does to velocities.
#include "character/ground.hpp"
#include "character/tick.hpp"

namespace surefoot::internal {

namespace {

// How far above ground a body that comes down is standing on it, as a share of the skin.
constexpr double stands_within = 0.5;

// Speeds below this are none [m/s].
constexpr double still = 1e-9;

}  // namespace

Vec left_behind(const Tick& tick) noexcept {
    return tick.settings.keeps_ground_velocity ? to_vec(tick.state.ground_velocity) : Vec{};
}

Vec velocity_at(const Tick& tick, std::uint32_t body, const Vec& point) noexcept {
    const World& world = tick.world();
    const BodyHandle handle = world.find(body);
    if (!moves(world, handle)) return {};
    // Where the point of touch was at the start of the tick is what the world is asked about.
    const Vec before = point - (to_vec(world.carried(handle, to_dvec3(point))) - point);
    return to_vec(world.velocity_at(handle, to_dvec3(before), tick.whole));
}

// Whoever was standing keeps to the ground within the snap distance; whoever was not has to touch it.
void stand(Tick& tick) noexcept {
    const CharacterSettings& settings = tick.settings;
    const bool was_standing = tick.state.footing == Footing::ground;
    if (dot(tick.velocity, tick.up) > still && !was_standing) return;
    const GroundRule rule{settings.perch_distance, unit(tick.wish), settings.snap_down};
    const double depth = was_standing ? settings.snap_down + settings.skin : stands_within * settings.skin;
    tick.ground = ground_under(tick.surroundings, tick.body, tick.gait, rule, tick.position, depth);
    if (!tick.ground.trusted) tick.say(CharacterEvent::overflow);
    stand_if_wedged(tick.surroundings, tick.body, tick.gait, tick.position, tick.ground);
    tick.standing = tick.ground.footing == Footing::ground;
    tick.tell(tick.standing ? StepAct::ground : StepAct::no_ground, tick.ground, tick.ground.distance);
    if (dot(to_vec(tick.input.impulse), tick.up) > 0) tick.standing = false;
}

void land(Tick& tick, double upward_speed) noexcept {
    if (dot(tick.velocity, tick.up) >
        still + larger(0, dot(velocity_at(tick, tick.ground.body, tick.ground.point), tick.up))) {
        tick.ground = {};
        return;
    }
    const GroundRule rule{tick.settings.perch_distance, {}};
    tick.ground =
        ground_under(tick.surroundings, tick.body, tick.gait, rule, tick.position, stands_within * tick.settings.skin);
    stand_if_wedged(tick.surroundings, tick.body, tick.gait, tick.position, tick.ground);
    if (tick.ground.footing != Footing::ground) return;
    tick.standing = true;
    tick.state.is_jumping = 0;
    tick.velocity = tick.level(tick.velocity - velocity_at(tick, tick.ground.body, tick.ground.point));
    if (tick.state.footing == Footing::ground) return;
    tick.events.landing_speed = larger(0, -upward_speed);
    tick.say(CharacterEvent::landed);
    tick.tell(StepAct::landed, tick.ground, tick.events.landing_speed);
}

}  // namespace surefoot::internal
