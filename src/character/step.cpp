#include <cmath>

#include <surefoot/character.hpp>

#include "character/body.hpp"
#include "character/contacts.hpp"
#include "character/tick.hpp"
#include "ieee_guard.hpp"
#include "limits.hpp"

namespace surefoot::internal {

namespace {

constexpr double longest_dt = 60;  // [s]

bool is_finite(const dvec3& v) noexcept {
    return absolute(v.x) < 1e300 && absolute(v.y) < 1e300 && absolute(v.z) < 1e300;
}

bool is_valid(const CharacterInput& input) noexcept {
    const double square = dot(to_vec(input.up), to_vec(input.up));
    return is_finite(input.wish) && is_finite(input.impulse) && is_finite(input.up) && square > 1e-12 && square < 1e12;
}

bool is_valid(const CharacterState& state) noexcept {
    return is_valid_point(state.position) && is_finite(state.velocity) && is_finite(state.ground_normal) &&
           is_finite(state.ground_velocity) && state.since_ground >= 0 && state.since_jump_press >= 0 &&
           state.since_wall >= 0 && state.since_dash >= 0 && is_finite(state.wall_normal) &&
           is_finite(state.ledge_point) && state.since_hold >= 0;
}

bool are_valid(std::span<const Neighbour> neighbours) noexcept {
    for (const Neighbour& neighbour : neighbours) {
        if (!surefoot::is_valid(neighbour.volume) || !is_valid_point(neighbour.position) ||
            !is_valid_point(neighbour.velocity)) {
            return false;
        }
    }
    return true;
}

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
    for (const auto& volume :
         {std::optional(settings.volume), settings.crouched, settings.in_air, settings.on_ramp, settings.on_ledge}) {
        if (!volume) continue;
        if (!is_valid(*volume)) return false;
        if (!is_within(settings.skin, 1e-6, 0.25 * internal::smallest_of(volume->shape))) return false;
    }
    const double lengths[] = {settings.step_up, settings.snap_down, settings.perch_distance, settings.jump_height};
    const double rates[] = {settings.gravity,          settings.terminal_speed,    settings.acceleration,
                            settings.braking,          settings.air_acceleration,  settings.coyote_time,
                            settings.jump_buffer,      settings.wall_slide_speed,  settings.wall_jump_speed,
                            settings.wall_coyote_time, settings.dash_speed,        settings.dash_time,
                            settings.dash_pause,       settings.swim_acceleration, settings.fly_acceleration,
                            settings.ladder_speed,     settings.ledge_reach,       settings.hands_height,
                            settings.climb_speed,      settings.shimmy_speed,      settings.vault_height};
    for (const double length : lengths) {
        if (!is_within(length, 0, 1e6)) return false;
    }
    for (const double rate : rates) {
        if (!is_within(rate, 0, plenty)) return false;
    }
    return is_within(settings.slope_limit_deg, 0, 89) && is_within(settings.step_depth, 1e-6, 1e6) &&
           is_within(settings.jump_cut, 1, 1e6) && is_within(settings.sink_speed, -plenty, plenty) &&
           is_within(settings.longest_tick, 0.01, 60);
}

StepResult step(const World& world, const CharacterSettings& settings, const CharacterInput& input, double dt,
                const CharacterState& state, std::span<const Neighbour> neighbours, StepTrace* trace,
                const CharacterHooks& hooks) noexcept {
    const internal::IeeeGuard guard;
    StepResult result{state, {}};
    if (!(dt > 0 && dt <= internal::longest_dt) || !is_valid(settings) || !internal::is_valid(input) ||
        !internal::is_valid(state) || !internal::are_valid(neighbours) ||
        (input.mode == CharacterMode::own && !hooks.move)) {
        result.events.set = static_cast<std::uint32_t>(CharacterEvent::invalid);
        return result;
    }
    const int parts = static_cast<int>(std::ceil(dt / settings.longest_tick));
    CharacterInput once = input;
    for (int done = 0; done < parts; ++done) {
        const internal::TickPart part{static_cast<double>(done) / parts, static_cast<double>(done + 1) / parts};
        const StepResult next =
            internal::tick_once({world, settings, once, dt, part, result.state, neighbours, trace, hooks});
        result.state = next.state;
        result.events = merged(result.events, next.events);
        result.contacts = internal::merged(result.contacts, next.contacts);
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
    const internal::Body body = internal::body_of(settings.volume, settings.skin, direction / size);
    Overlap one;
    return world.overlap(body.volume, position, {&one, 1}, WorldQuery{.begin = 1, .end = 1}) == 0;
}

}  // namespace v0
}  // namespace surefoot
