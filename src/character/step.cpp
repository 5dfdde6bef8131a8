#include <cmath>

#include <surefoot/character.hpp>

#include "angle.hpp"
#include "character/body.hpp"
#include "character/ground.hpp"
#include "character/motion.hpp"
#include "character/recover.hpp"
#include "character/slide.hpp"
#include "character/walk.hpp"
#include "ieee_guard.hpp"
#include "limits.hpp"

namespace surefoot::internal {

namespace {

constexpr double longest_dt = 60;  // [s]

// How fast a body gets out of what it begins inside of [m/s].
constexpr double recovery_speed = 10;

// How far above ground a body that comes down is standing on it, as a share of the skin.
constexpr double touching = 0.5;

bool is_finite(const dvec3& v) noexcept {
    return absolute(v.x) < 1e300 && absolute(v.y) < 1e300 && absolute(v.z) < 1e300;
}

bool is_valid(const CharacterInput& input) noexcept {
    const double square = dot(to_vec(input.up), to_vec(input.up));
    return is_finite(input.wish) && is_finite(input.impulse) && is_finite(input.up) && square > 1e-12 && square < 1e12;
}

bool is_valid(const CharacterState& state) noexcept {
    return is_valid_point(state.position) && is_finite(state.velocity) && is_finite(state.ground_normal) &&
           is_finite(state.ground_velocity) && state.since_ground >= 0 && state.since_jump_press >= 0;
}

class Step {
public:
    Step(const World& world, const CharacterSettings& settings, const CharacterInput& input, double dt,
         const CharacterState& state) noexcept
        : settings_(settings),
          input_(input),
          dt_(dt),
          up_(to_vec(input.up) / length(to_vec(input.up))),
          body_(body_of(settings, up_)),
          surroundings_(world, WorldQuery{.begin = 1, .end = 1}) {
        result_.state = state;
        gait_.up = up_;
        gait_.least_ground_up = cosine_deg(settings.slope_limit_deg);
        gait_.skin = settings.skin;
        gait_.stops = settings.response == Response::stop;
        position_ = to_vec(state.position);
        velocity_ = to_vec(state.velocity) + to_vec(input.impulse);
    }

    StepResult run() noexcept {
        cover_all();
        remember_buttons();
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

    void get_out() noexcept {
        const Recovery recovery = recover(surroundings_, body_, gait_, position_, recovery_speed * dt_);
        position_ = recovery.position;
        if (recovery.moved) say(CharacterEvent::recovered);
        if (recovery.stuck) say(CharacterEvent::stuck);
    }

    // Is it on the ground now? Whoever was keeps to it within the snap distance; whoever was not has to touch it.
    void stand() noexcept {
        const bool was_standing = state().footing == Footing::ground;
        if (dot(velocity_, up_) > 1e-9 && !was_standing) return;
        const GroundRule rule{settings_.perch_distance, direction(level(to_vec(input_.wish))), settings_.snap_down};
        const double depth = was_standing ? settings_.snap_down + settings_.skin : touching * settings_.skin;
        ground_ = ground_under(surroundings_, body_, gait_, rule, position_, depth);
        standing_ = ground_.footing == Footing::ground;
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
        state().since_jump_press = 1e9;
        state().since_ground = 1e9;
        state().is_jumping = 1;
        standing_ = false;
        say(CharacterEvent::jumped);
    }

    void go_on_foot() noexcept {
        const Vec wish = level(to_vec(input_.wish));
        const Vec before = level(velocity_);
        const double rate = dot(wish, wish) < dot(before, before) ? settings_.braking : settings_.acceleration;
        const Travel travel = accelerate(before, wish, rate, dt_);
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
        say(CharacterEvent::left_ground);
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

    void land(double upward_speed) noexcept {
        if (dot(velocity_, up_) > 1e-9) {
            ground_ = {};
            return;
        }
        const GroundRule rule{settings_.perch_distance, {}};
        ground_ = ground_under(surroundings_, body_, gait_, rule, position_, touching * settings_.skin);
        if (ground_.footing != Footing::ground) return;
        standing_ = true;
        state().is_jumping = 0;
        velocity_ = level(velocity_);
        if (state().footing != Footing::ground) {
            say(CharacterEvent::landed);
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
        after.ground_velocity = {0, 0, 0};
        after.ground_body = carried ? ground_.body : 0;
        after.ground_triangle = carried ? ground_.triangle : 0;
        after.ground_surface = carried ? ground_.surface : 0;
        return result_;
    }

    const CharacterSettings& settings_;
    const CharacterInput& input_;
    double dt_;
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

}  // namespace surefoot::internal

namespace surefoot {
inline namespace v0 {

namespace {

bool is_within(double value, double least, double most) noexcept {
    return value >= least && value <= most;
}

constexpr double plenty = 1e9;

// What happened in two ticks, one after the other. Of what was told once, the last is kept.
CharacterEvents merged(const CharacterEvents& first, const CharacterEvents& second) noexcept {
    CharacterEvents both = second.has(CharacterEvent::blocked) ? second : first;
    both.set = first.set | second.set;
    both.landing_speed = second.has(CharacterEvent::landed) ? second.landing_speed : first.landing_speed;
    return both;
}

}  // namespace

bool is_valid(const CharacterSettings& settings) noexcept {
    if (!is_valid(settings.volume)) return false;
    const double lengths[] = {settings.step_up, settings.snap_down, settings.perch_distance, settings.jump_height};
    const double rates[] = {settings.gravity,          settings.terminal_speed, settings.acceleration, settings.braking,
                            settings.air_acceleration, settings.coyote_time,    settings.jump_buffer};
    for (const double length : lengths) {
        if (!is_within(length, 0, 1e6)) return false;
    }
    for (const double rate : rates) {
        if (!is_within(rate, 0, plenty)) return false;
    }
    return is_within(settings.skin, 1e-6, 0.25 * internal::smallest_of(settings.volume.shape)) &&
           is_within(settings.slope_limit_deg, 0, 89) && is_within(settings.step_depth, 1e-6, 1e6) &&
           is_within(settings.jump_cut, 1, 1e6) && is_within(settings.longest_tick, 1e-6, 60);
}

StepResult step(const World& world, const CharacterSettings& settings, const CharacterInput& input, double dt,
                const CharacterState& state) noexcept {
    const internal::IeeeGuard guard;
    StepResult result{state, {}};
    if (!(dt > 0 && dt <= internal::longest_dt) || !is_valid(settings) || !internal::is_valid(input) ||
        !internal::is_valid(state)) {
        result.events.set = static_cast<std::uint32_t>(CharacterEvent::invalid);
        return result;
    }
    const double parts = std::ceil(dt / settings.longest_tick);
    const double part = dt / parts;
    CharacterInput once = input;
    for (double done = 0; done < parts; ++done) {
        const StepResult next = internal::Step(world, settings, once, part, result.state).run();
        result.state = next.state;
        result.events = merged(result.events, next.events);
        once.impulse = {0, 0, 0};
    }
    if (parts > 1) result.events.set |= static_cast<std::uint32_t>(CharacterEvent::sub_stepped);
    return result;
}

bool fits(const World& world, const CharacterSettings& settings, const dvec3& position, const dvec3& up) noexcept {
    const internal::IeeeGuard guard;
    const internal::Vec direction = internal::to_vec(up);
    const double size = internal::length(direction);
    if (!is_valid(settings) || !internal::is_valid_point(position) || !(size > 1e-6 && size < 1e6)) return false;
    const internal::Body body = internal::body_of(settings, direction / size);
    Overlap one;
    return world.overlap(body.volume, position, {&one, 1}, WorldQuery{.begin = 1, .end = 1}) == 0;
}

}  // namespace v0
}  // namespace surefoot
