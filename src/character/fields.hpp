// The fields of a character's plain structs, by name and in order: what hashes, compares, writes and reads them goes
// over these lists, so that a field which is added is added once.
#pragma once

#include <concepts>
#include <type_traits>

#include <surefoot/character.hpp>

namespace surefoot::internal {

template <typename T, typename Struct>
concept Either = std::same_as<std::remove_const_t<T>, Struct>;

/// Calls `visit(name, field)` for each field.
template <Either<CharacterSettings> T, typename Visit>
void visit_fields(T& s, const Visit& visit) {
    visit("volume", s.volume);
    visit("crouched", s.crouched);
    visit("in_air", s.in_air);
    visit("on_ramp", s.on_ramp);
    visit("skin", s.skin);
    visit("slope_limit_deg", s.slope_limit_deg);
    visit("step_up", s.step_up);
    visit("step_depth", s.step_depth);
    visit("snap_down", s.snap_down);
    visit("perch_distance", s.perch_distance);
    visit("response", s.response);
    visit("slope_speed", s.slope_speed);
    visit("gravity", s.gravity);
    visit("terminal_speed", s.terminal_speed);
    visit("acceleration", s.acceleration);
    visit("braking", s.braking);
    visit("air_acceleration", s.air_acceleration);
    visit("jump_height", s.jump_height);
    visit("jump_cut", s.jump_cut);
    visit("coyote_time", s.coyote_time);
    visit("jump_buffer", s.jump_buffer);
    visit("keeps_ground_velocity", s.keeps_ground_velocity);
    visit("air_jumps", s.air_jumps);
    visit("wall_slide_speed", s.wall_slide_speed);
    visit("wall_jump_speed", s.wall_jump_speed);
    visit("wall_coyote_time", s.wall_coyote_time);
    visit("dash_speed", s.dash_speed);
    visit("dash_time", s.dash_time);
    visit("dash_pause", s.dash_pause);
    visit("swim_acceleration", s.swim_acceleration);
    visit("sink_speed", s.sink_speed);
    visit("fly_acceleration", s.fly_acceleration);
    visit("ladder_speed", s.ladder_speed);
    visit("ledge_reach", s.ledge_reach);
    visit("hands_height", s.hands_height);
    visit("climb_speed", s.climb_speed);
    visit("shimmy_speed", s.shimmy_speed);
    visit("vault_height", s.vault_height);
    visit("surfaces", s.surfaces);
    visit("longest_tick", s.longest_tick);
    visit("firmness", s.firmness);
    visit("flat_foot", s.flat_foot);
    visit("on_ledge", s.on_ledge);
}

template <Either<SurfaceRule> T, typename Visit>
void visit_fields(T& rule, const Visit& visit) {
    visit("grip", rule.grip);
    visit("conveyor", rule.conveyor);
    visit("one_way", rule.one_way);
    visit("slippery", rule.slippery);
    visit("ladder", rule.ladder);
}

template <Either<CharacterInput> T, typename Visit>
void visit_fields(T& input, const Visit& visit) {
    visit("wish", input.wish);
    visit("impulse", input.impulse);
    visit("up", input.up);
    visit("jump", input.jump);
    visit("crouch", input.crouch);
    visit("dash", input.dash);
    visit("mode", input.mode);
}

template <Either<CharacterState> T, typename Visit>
void visit_fields(T& state, const Visit& visit) {
    visit("position", state.position);
    visit("velocity", state.velocity);
    visit("ground_normal", state.ground_normal);
    visit("ground_velocity", state.ground_velocity);
    visit("since_ground", state.since_ground);
    visit("since_jump_press", state.since_jump_press);
    visit("since_wall", state.since_wall);
    visit("since_dash", state.since_dash);
    visit("wall_normal", state.wall_normal);
    visit("ledge_point", state.ledge_point);
    visit("since_hold", state.since_hold);
    visit("ground_body", state.ground_body);
    visit("ground_triangle", state.ground_triangle);
    visit("ground_surface", state.ground_surface);
    visit("air_jumps_left", state.air_jumps_left);
    visit("footing", state.footing);
    visit("jump_held", state.jump_held);
    visit("is_jumping", state.is_jumping);
    visit("dash_held", state.dash_held);
    visit("form", state.form);
    visit("hold", state.hold);
}

template <Either<CharacterEvents> T, typename Visit>
void visit_fields(T& events, const Visit& visit) {
    visit("set", events.set);
    visit("landing_speed", events.landing_speed);
    visit("blocked_by", events.blocked_by);
    visit("blocked_body", events.blocked_body);
    visit("blocked_triangle", events.blocked_triangle);
}

template <Either<Neighbour> T, typename Visit>
void visit_fields(T& neighbour, const Visit& visit) {
    visit("volume", neighbour.volume);
    visit("position", neighbour.position);
    visit("velocity", neighbour.velocity);
    visit("id", neighbour.id);
    visit("carrier", neighbour.carrier);
    visit("is_carried", neighbour.is_carried);
    visit("firmness", neighbour.firmness);
}

template <Either<StepRecord> T, typename Visit>
void visit_fields(T& record, const Visit& visit) {
    visit("act", record.act);
    visit("rule", record.rule);
    visit("body", record.body);
    visit("triangle", record.triangle);
    visit("feature", record.feature);
    visit("value", record.value);
    visit("limit", record.limit);
    visit("position", record.position);
    visit("motion", record.motion);
    visit("point", record.point);
    visit("normal", record.normal);
}

// Whoever adds a field here adds it above.
static_assert(sizeof(CharacterSettings) == 632 && sizeof(SurfaceRule) == 40 && sizeof(CharacterInput) == 80 &&
              sizeof(CharacterState) == 208 && sizeof(CharacterEvents) == 48 && sizeof(StepRecord) == 128 &&
              sizeof(Neighbour) == 128);

}  // namespace surefoot::internal
