#include "character/tick.hpp"

#include <cmath>

#include "angle.hpp"
#include "character/body.hpp"
#include "character/ground.hpp"
#include "character/motion.hpp"
#include "character/recover.hpp"
#include "character/slide.hpp"
#include "character/walk.hpp"

namespace surefoot::internal {

namespace {

// How fast a body gets out of what it begins inside of [m/s].
constexpr double recovery_speed = 10;

// How far above ground a body that comes down is standing on it, as a share of the skin.
constexpr double touching = 0.5;

class Tick {
public:
    Tick(const World& world, const CharacterSettings& settings, const CharacterInput& input, double tick,
         const TickPart& part, const CharacterState& state, StepTrace* trace) noexcept
        : settings_(settings),
          input_(input),
          tick_(tick),
          part_(part),
          dt_(tick * (part.end - part.begin)),
          up_(to_vec(input.up) / length(to_vec(input.up))),
          body_(body_of(settings, up_)),
          surroundings_(world, WorldQuery{.begin = part.end, .end = part.end}, settings.surfaces, settings.skin, trace) {
        result_.state = state;
        gait_.up = up_;
        gait_.least_ground_up = cosine_deg(settings.slope_limit_deg);
        gait_.skin = settings.skin;
        gait_.stops = settings.response == Response::stop;
        position_ = to_vec(state.position);
        velocity_ = to_vec(state.velocity) + to_vec(input.impulse);
    }

    StepResult run() noexcept {
        remember_buttons();
        ride();
        cover_all();
        get_out();
        stand();
        jump();
        if (standing_) {
            go_on_foot();
        } else {
            fall(dt_);
        }
        return finish();
    }

private:
    CharacterState& state() noexcept { return result_.state; }
    void say(CharacterEvent event) noexcept { result_.events.set |= static_cast<std::uint32_t>(event); }
    void tell(StepRecord record) const noexcept {
        surroundings_.tell([&] {
            record.position = to_dvec3(position_);
            return record;
        });
    }
    void tell(StepAct act, const Ground& ground, double value = 0) const noexcept {
        tell({.point = to_dvec3(ground.point),
              .normal = to_dvec3(ground.normal),
              .value = ground.rule == StepRule::none ? value : ground.value,
              .limit = ground.limit,
              .triangle = ground.triangle,
              .body = ground.body,
              .act = act,
              .rule = ground.rule});
    }
    Vec level(const Vec& v) const noexcept { return v - up_ * dot(v, up_); }

    // One gather for all questions of this tick, if it is short enough.
    void cover_all() noexcept {
        const double way = (length(velocity_) + length(to_vec(input_.wish))) * dt_ + settings_.step_depth +
                           0.5 * settings_.gravity * dt_ * dt_ + 3 * settings_.skin;
        if (way > 4 * largest(body_.above - body_.below)) return;
        const double vertical = larger(way, larger(settings_.step_up, settings_.snap_down) + 3 * settings_.skin);
        const Vec reach{way + (vertical - way) * absolute(up_.x), way + (vertical - way) * absolute(up_.y),
                        way + (vertical - way) * absolute(up_.z)};
        (void)surroundings_.cover(position_ + body_.below - reach, position_ + body_.above + reach);
    }

    void remember_buttons() noexcept {
        state().since_jump_press += dt_;
        if (input_.jump && state().jump_held == 0) state().since_jump_press = 0;
        state().jump_held = input_.jump ? 1 : 0;
        state().since_ground += dt_;
    }

    void ride() noexcept {
        const BodyHandle support =
            state().footing == Footing::air ? BodyHandle{} : surroundings_.world().find(state().ground_body);
        const Carried carried = carry(surroundings_.world(), body_, gait_, position_, support, part_);
        if (carried.moved) {
            tell({.motion = to_dvec3(carried.position - position_),
                  .body = state().ground_body,
                  .act = StepAct::carried});
        }
        position_ = carried.position;
        if (carried.crushed) {
            say(CharacterEvent::crushed);
            tell({.act = StepAct::crushed});
        }
        if (carried.pushed) say(CharacterEvent::pushed);
    }

    void get_out() noexcept {
        const Recovery recovery = recover(surroundings_, body_, gait_, position_, recovery_speed * dt_);
        if (recovery.moved) {
            say(CharacterEvent::recovered);
            tell({.motion = to_dvec3(recovery.position - position_), .act = StepAct::recovered});
        }
        position_ = recovery.position;
        if (recovery.stuck) {
            say(CharacterEvent::stuck);
            tell({.act = StepAct::stuck});
        }
    }

    // Is it on the ground now? Whoever was keeps to it within the snap distance; whoever was not has to touch it.
    void stand() noexcept {
        const bool was_standing = state().footing == Footing::ground;
        if (dot(velocity_, up_) > 1e-9 && !was_standing) return;
        const GroundRule rule{settings_.perch_distance, direction(level(to_vec(input_.wish))), settings_.snap_down};
        const double depth = was_standing ? settings_.snap_down + settings_.skin : touching * settings_.skin;
        ground_ = ground_under(surroundings_, body_, gait_, rule, position_, depth);
        stand_if_wedged(surroundings_, body_, gait_, position_, ground_);
        standing_ = ground_.footing == Footing::ground;
        tell(standing_ ? StepAct::ground : StepAct::no_ground, ground_, ground_.distance);
        if (dot(to_vec(input_.impulse), up_) > 0) standing_ = false;
    }

    static Vec direction(const Vec& v) noexcept {
        const double size = length(v);
        return size > 0 ? v / size : Vec{};
    }

    void jump() noexcept {
        if (state().since_jump_press > settings_.jump_buffer) return;
        const bool from_ground =
            standing_ || (state().since_ground <= settings_.coyote_time && state().is_jumping == 0);
        if (!from_ground && (state().air_jumps_left == 0 || state().since_jump_press > 0)) return;
        if (!from_ground) --state().air_jumps_left;
        const double speed = std::sqrt(2 * settings_.gravity * settings_.jump_height);
        velocity_ = level(velocity_) + up_ * speed;
        if (standing_) velocity_ = velocity_ + left_behind();
        state().since_jump_press = 1e9;
        state().since_ground = 1e9;
        state().is_jumping = 1;
        standing_ = false;
        say(CharacterEvent::jumped);
        tell({.value = speed, .act = StepAct::jumped});
    }

    void go_on_foot() noexcept {
        const Vec wish = level(to_vec(input_.wish));
        const Vec before = level(velocity_);
        const SurfaceRule rule = settings_.surfaces[ground_.surface];
        const double rate = dot(wish, wish) < dot(before, before) ? settings_.braking : settings_.acceleration;
        Travel travel = accelerate(before, wish, rate * rule.grip, dt_);
        travel.way = travel.way + level(conveyor_velocity(rule)) * dt_;
        tell({.motion = to_dvec3(travel.way), .act = StepAct::wants});
        Gait on_foot = gait_;
        on_foot.on_foot = true;
        const WalkResult walked =
            walk(surroundings_, body_, on_foot, settings_, position_, ground_, travel.way, travel.velocity);
        position_ = walked.position;
        velocity_ = walked.velocity;
        ground_ = walked.ground;
        if (walked.stepped_up) say(CharacterEvent::stepped_up);
        if (walked.snapped_down) say(CharacterEvent::snapped_down);
        if (walked.overflow) say(CharacterEvent::overflow);
        if (walked.met_ceiling) say(CharacterEvent::hit_ceiling);
        tell_obstacle(walked.obstacle);
        if (ground_.footing == Footing::ground) return;
        standing_ = false;
        velocity_ = velocity_ + left_behind();
        say(CharacterEvent::left_ground);
        tell(StepAct::left_ground, ground_);
        state().since_ground = dt_ * (1 - walked.done);
        if (walked.done < 1) fall(dt_ * (1 - walked.done));
    }

    void fall(double seconds) noexcept {
        const double speed = dot(velocity_, up_);
        const bool cut = state().is_jumping != 0 && !input_.jump;
        const double rising = settings_.gravity * (cut ? settings_.jump_cut : 1);
        const Flight flight = fly(speed, rising, settings_.gravity, settings_.terminal_speed, seconds);
        const Travel travel =
            accelerate(level(velocity_), level(to_vec(input_.wish)), settings_.air_acceleration, seconds);
        tell({.motion = to_dvec3(travel.way + up_ * flight.rise), .act = StepAct::wants});
        Planes3 none;
        const SlideResult slid = slide(surroundings_, body_, gait_, position_, travel.way + up_ * flight.rise, none);
        velocity_ = travel.velocity + up_ * flight.speed;
        const double into_ground = dot(velocity_, up_);
        position_ = slid.position;
        if (slid.overflow) say(CharacterEvent::overflow);
        if (slid.met_ceiling) say(CharacterEvent::hit_ceiling);
        velocity_ = slid.planes.nearest_to(velocity_);
        tell_obstacle(slid.obstacle);
        if (dot(velocity_, up_) <= 0) state().is_jumping = 0;
        land(into_ground);
    }

    // What the character takes along from ground that moved.
    Vec left_behind() const noexcept {
        return settings_.keeps_ground_velocity ? to_vec(result_.state.ground_velocity) : Vec{};
    }

    Vec conveyor_velocity(const SurfaceRule& rule) const noexcept {
        const Vec belt = to_vec(rule.conveyor);
        const World& world = surroundings_.world();
        const BodyHandle handle = world.find(ground_.body);
        if (belt == Vec{} || !world.contains(handle)) return {};
        const Pose pose = world.poses(handle).end;
        return to_vec(to_world(pose, rule.conveyor)) - to_vec(pose.position);
    }

    // How fast the ground under it moves.
    Vec velocity_of(const Ground& ground) const noexcept {
        const World& world = surroundings_.world();
        const BodyHandle handle = world.find(ground.body);
        if (!moves(world, handle)) return {};
        // Where the point of touch was at the start of the tick is what the world is asked about.
        const Vec before = ground.point - (to_vec(world.carried(handle, to_dvec3(ground.point))) - ground.point);
        return to_vec(world.velocity_at(handle, to_dvec3(before), tick_));
    }

    void land(double upward_speed) noexcept {
        if (dot(velocity_, up_) > 1e-9 + larger(0, dot(velocity_of(ground_), up_))) {
            ground_ = {};
            return;
        }
        const GroundRule rule{settings_.perch_distance, {}};
        ground_ = ground_under(surroundings_, body_, gait_, rule, position_, touching * settings_.skin);
        stand_if_wedged(surroundings_, body_, gait_, position_, ground_);
        if (ground_.footing != Footing::ground) return;
        standing_ = true;
        state().is_jumping = 0;
        velocity_ = level(velocity_ - velocity_of(ground_));
        if (state().footing != Footing::ground) {
            say(CharacterEvent::landed);
            tell(StepAct::landed, ground_, larger(0, -upward_speed));
            result_.events.landing_speed = larger(0, -upward_speed);
        }
    }

    void tell_obstacle(const Obstacle& obstacle) noexcept {
        if (obstacle.normal == Vec{}) return;
        if (dot(obstacle.normal, up_) >= gait_.least_ground_up) return;
        say(CharacterEvent::blocked);
        result_.events.blocked_by = to_dvec3(obstacle.normal);
        result_.events.blocked_body = obstacle.body;
        result_.events.blocked_triangle = obstacle.triangle;
    }

    StepResult finish() noexcept {
        CharacterState& after = state();
        after.position = to_dvec3(position_);
        after.velocity = to_dvec3(velocity_);
        after.footing = standing_ ? Footing::ground : ground_.footing == Footing::steep ? Footing::steep : Footing::air;
        if (standing_) {
            after.since_ground = 0;
            after.air_jumps_left = settings_.air_jumps;
        }
        const bool carried = after.footing != Footing::air;
        after.ground_normal = carried ? to_dvec3(ground_.normal) : dvec3{0, 0, 0};
        after.ground_velocity = carried ? to_dvec3(velocity_of(ground_)) : dvec3{0, 0, 0};
        after.ground_body = carried ? ground_.body : 0;
        after.ground_triangle = carried ? ground_.triangle : 0;
        after.ground_surface = carried ? ground_.surface : 0;
        return result_;
    }

    const CharacterSettings& settings_;
    const CharacterInput& input_;
    double tick_;    // all of the world's tick [s]
    TickPart part_;  // the part of it that is done here
    double dt_;      // how long that is [s]
    Vec up_;
    Body body_;
    Gait gait_{};
    Surroundings surroundings_;
    StepResult result_{};
    Vec position_;
    Vec velocity_;
    Ground ground_{};
    bool standing_ = false;
};

}  // namespace

StepResult tick_once(const World& world, const CharacterSettings& settings, const CharacterInput& input, double tick,
                     const TickPart& part, const CharacterState& state, StepTrace* trace) noexcept {
    return Tick(world, settings, input, tick, part, state, trace).run();
}

}  // namespace surefoot::internal
