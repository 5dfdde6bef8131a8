// Grabbing an edge, hanging, going along it, climbing up, dropping, vaulting.
#include "character/ledge.hpp"

namespace surefoot::internal {

namespace {

// Where a new edge may be, at most, above the one that is held [m].
constexpr double refused_above = 0.5;

// After letting go nothing is grabbed for so long [s].
constexpr double lets_go_for = 0.25;

// Along an edge the wall may bend by so much in one tick, as a cosine.
constexpr double same_wall = 0.95;

// Falling, hands find an edge they pass this much later; the reach grows by so much of the way of a tick.
constexpr double reach_by_speed = 1.5;

void hang(Tick& tick, const Ledge& ledge) noexcept {
    CharacterState& state = tick.state;
    tick.position =
        slide(tick.surroundings, tick.body, tick.gait, tick.position, ledge.hang - tick.position, {}).position;
    tick.velocity = {};
    tick.ground = {};
    tick.standing = false;
    state.is_jumping = 0;
    state.wall_normal = to_dvec3(ledge.wall);
    state.ledge_point = to_dvec3(ledge.edge);
    state.ground_body = ledge.body;
    state.ground_triangle = ledge.triangle;
    state.hold = Hold::hanging;
}

void let_go(Tick& tick) noexcept {
    tick.state.hold = Hold::none;
    tick.state.since_hold = 0;
}

// Up beside the wall, then over the edge; it is done when it stands.
bool go_up(Tick& tick) noexcept {
    const Vec edge = to_vec(tick.state.ledge_point);
    const double above = dot(tick.position - edge, tick.up) - tick.body.foot;
    const double way = tick.settings.climb_speed * tick.dt;
    const Vec before = tick.position;
    const double missing = tick.gait.skin - above;
    if (missing > 0) {
        const Vec up = tick.up * smaller(way, missing);
        tick.position = slide(tick.surroundings, tick.body, tick.gait, tick.position, up, {}).position;
        if (dot(tick.position - before, tick.up) < 0.5 * smaller(way, missing)) {
            let_go(tick);
            return false;
        }
    } else {
        const Vec in = -to_vec(tick.state.wall_normal);
        tick.position = slide(tick.surroundings, tick.body, tick.gait, tick.position, in * way, {}).position;
        if (dot(tick.position - before, in) < 0.5 * way ||
            dot(tick.position - edge, in) >= 0.25 * tick.body.half_width) {
            tick.say(CharacterEvent::climbed_ledge);
            let_go(tick);
        }
    }
    tick.velocity = {};
    return true;
}

void shimmy(Tick& tick) noexcept {
    const Vec wall = to_vec(tick.state.wall_normal);
    const Vec along = tick.wish - wall * dot(wall, tick.wish);
    if (length(along) < 0.1 * length(tick.wish) || along == Vec{}) return;
    const Vec before = tick.position;
    const Vec way = unit(along) * (tick.settings.shimmy_speed * tick.dt);
    tick.position = slide(tick.surroundings, tick.body, tick.gait, tick.position, way, {}).position;
    const double hands = tick.settings.hands_height;
    const auto ledge = find_ledge(tick, -wall, hands - refused_above, hands + refused_above);
    if (!ledge || dot(ledge->wall, wall) < same_wall) {
        tick.position = before;  // the edge ends here, or goes around a corner
        return;
    }
    hang(tick, *ledge);
}

bool keep_hanging(Tick& tick) noexcept {
    const Vec wall = to_vec(tick.state.wall_normal);
    if (tick.state.hold == Hold::climbing) return go_up(tick);
    const double pull = -dot(wall, tick.wish);
    if (tick.input.crouch || pull < -0.5 * length(tick.wish) - 1e-12) {
        drop_ledge(tick);
        return false;
    }
    const double hands = tick.settings.hands_height;
    const auto ledge = find_ledge(tick, -wall, hands - refused_above, hands + refused_above);
    if (!ledge) {
        let_go(tick);
        return false;
    }
    const bool pressed = tick.state.since_jump_press <= tick.settings.jump_buffer;
    if (pressed || pull > 0.9 * length(tick.wish)) {
        if (ledge->has_room && (pressed || pull > 0)) {
            tick.state.since_jump_press = long_ago;
            tick.state.ledge_point = to_dvec3(ledge->edge);
            tick.state.hold = Hold::climbing;
            return go_up(tick);
        }
        tick.velocity = {};
        return true;
    }
    tick.velocity = {};
    shimmy(tick);
    return true;
}

}  // namespace

void drop_ledge(Tick& tick) noexcept {
    if (tick.state.hold == Hold::none) return;
    let_go(tick);
    tick.say(CharacterEvent::dropped_ledge);
}

bool hold_ledge(Tick& tick) noexcept {
    const CharacterSettings& settings = tick.settings;
    CharacterState& state = tick.state;
    if (settings.ledge_reach <= 0) {
        drop_ledge(tick);
        return false;
    }
    if (state.hold != Hold::none) return keep_hanging(tick);
    if (tick.wish == Vec{} || tick.input.crouch || state.since_hold < lets_go_for) return false;
    const Vec ahead = unit(tick.wish);
    const double speed = dot(tick.velocity, tick.up);
    if (tick.standing) {
        // Over something of at most the vault height, by a press of jump.
        if (settings.vault_height <= settings.step_up || state.since_jump_press > 0) return false;
        const auto ledge = find_ledge(tick, ahead, settings.step_up, settings.vault_height);
        if (!ledge || !ledge->has_room) return false;
        hang(tick, *ledge);
        state.since_jump_press = long_ago;
        state.hold = Hold::climbing;
        tick.say(CharacterEvent::vaulted);
        return go_up(tick);
    }
    if (speed > 0.5 * settings.climb_speed) return false;  // still rising
    const double passes = larger(0, -speed) * tick.dt * reach_by_speed;
    const double high = settings.hands_height + passes;
    const auto ledge = find_ledge(tick, ahead, settings.hands_height - settings.ledge_reach - passes, high);
    if (!ledge) return false;
    hang(tick, *ledge);
    tick.say(CharacterEvent::grabbed_ledge);
    return true;
}

}  // namespace surefoot::internal
