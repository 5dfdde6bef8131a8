// Jumps from the ground, in the air and off walls, and the dash.
#include <cmath>

#include "character/tick.hpp"

namespace surefoot::internal {

namespace {

void take_off(Tick& tick, double speed) noexcept {
    tick.state.since_jump_press = long_ago;
    tick.state.since_ground = long_ago;
    tick.state.is_jumping = 1;
    tick.standing = false;
    tick.ground = {};
    tick.say(CharacterEvent::jumped);
    tick.tell({.value = speed, .act = StepAct::jumped});
}

void jump(Tick& tick) noexcept {
    const CharacterSettings& settings = tick.settings;
    CharacterState& state = tick.state;
    if (state.since_jump_press > settings.jump_buffer) return;
    const double speed = std::sqrt(2 * settings.gravity * settings.jump_height);
    const bool recently = state.since_ground <= settings.coyote_time && state.is_jumping == 0;
    if (tick.standing || recently) {
        const Vec taken_along = tick.standing ? left_behind(tick) : Vec{};
        tick.velocity = tick.level(tick.velocity) + tick.up * speed + taken_along;
        take_off(tick, speed);
        return;
    }
    if (state.since_jump_press > 0) return;  // only a press in this very tick counts in the air
    if (settings.wall_jump_speed > 0 && state.since_wall <= settings.wall_coyote_time) {
        const Vec out = tick.level(to_vec(state.wall_normal));
        tick.velocity = tick.up * speed + out * (settings.wall_jump_speed / larger(length(out), 0.1));
        state.since_wall = long_ago;
        take_off(tick, speed);
        return;
    }
    if (state.air_jumps_left == 0) {
        return tick.tell({.value = state.since_ground,
                          .limit = settings.coyote_time,
                          .act = StepAct::jump_refused,
                          .rule = StepRule::coyote_time});
    }
    --state.air_jumps_left;
    tick.velocity = tick.level(tick.velocity) + tick.up * speed;
    take_off(tick, speed);
}

void dash(Tick& tick) noexcept {
    const CharacterSettings& settings = tick.settings;
    const bool pressed = tick.input.dash && tick.state.dash_held == 0;
    tick.state.dash_held = tick.input.dash ? 1 : 0;
    if (!pressed || settings.dash_speed <= 0 || tick.wish == Vec{}) return;
    if (tick.state.since_dash < settings.dash_time + settings.dash_pause) return;
    tick.state.since_dash = 0;
    tick.velocity = tick.wish * (settings.dash_speed / length(tick.wish));
    tick.say(CharacterEvent::dashed);
}

}  // namespace

void leap(Tick& tick) noexcept {
    dash(tick);
    jump(tick);
}

}  // namespace surefoot::internal
