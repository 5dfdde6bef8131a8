#include "character/form.hpp"

#include <surefoot/overlap.hpp>

#include "character/body.hpp"
#include "character/tick.hpp"
#include "exact/products.hpp"
#include "world/ask.hpp"

namespace surefoot::internal {

namespace {

// The form that the situation asks for.
CharacterForm wanted(const Tick& tick) noexcept {
    const CharacterSettings& settings = tick.settings;
    if (tick.state.hold != Hold::none && settings.on_ledge) return CharacterForm::on_ledge;
    if (tick.input.crouch && settings.crouched) return CharacterForm::crouched;
    if (tick.state.footing != Footing::ground && settings.in_air) return CharacterForm::in_air;
    const bool is_ramp =
        tick.state.footing == Footing::ground && dot(to_vec(tick.state.ground_normal), tick.up) < ramp_rises_at_most;
    if (is_ramp && settings.on_ramp) return CharacterForm::on_ramp;
    return CharacterForm::standing;
}

// Away from the wall that it hangs or hung on, by `way`, as the body that it has can go.
Vec away_from_wall(Tick& tick, double way) noexcept {
    const Vec wall = unit(tick.level(to_vec(tick.state.wall_normal)));
    return slide(tick.surroundings, tick.body, tick.gait, tick.position, wall * way, {}).position;
}

// How far the body reaches below its position against a normal.
double reach_below(const Body& body, const Vec& normal) noexcept {
    return reach_along(body.kept_off, -normal) - dot(body.shift, normal);
}

// By how much a body has to be raised to stand where another one stands [m]: on a slope a round one touches the ground
// beside its lowest point, and the flatter it is the farther beside.
double raise_on_ground(const Tick& tick, const Body& body) noexcept {
    constexpr double steepest = 0.1;  // beyond it the raise would be a leap
    const Vec normal = to_vec(tick.state.ground_normal);
    const double rises = dot(normal, tick.up);
    if (tick.state.footing != Footing::ground || !(rises > steepest)) return body.foot - tick.body.foot;
    return (reach_below(body, normal) - reach_below(tick.body, normal)) / rises;
}

}  // namespace

const Volume& volume_of(const CharacterSettings& settings, CharacterForm form) noexcept {
    if (form == CharacterForm::crouched && settings.crouched) return *settings.crouched;
    if (form == CharacterForm::in_air && settings.in_air) return *settings.in_air;
    if (form == CharacterForm::on_ramp && settings.on_ramp) return *settings.on_ramp;
    if (form == CharacterForm::on_ledge && settings.on_ledge) return *settings.on_ledge;
    return settings.volume;
}

bool has_room(Tick& tick, const Body& body, const Vec& position) noexcept {
    const Box3 around = body.around(position, {}, 2 * tick.gait.skin);
    if (!tick.surroundings.cover(around)) return false;
    const GrownVolume near = grown(body.volume, 0.5 * tick.gait.skin);
    bool room = true;
    tick.surroundings.near(around, [&](const SourceTriangle& triangle) {
        if (!room || tick.surroundings.rule_of(triangle.surface).one_way) return;
        room = !surefoot::overlap(near.volume, to_dvec3(position + near.shift), triangle.triangle);
    });
    return room;
}

void change_form(Tick& tick) noexcept {
    const CharacterForm form = wanted(tick);
    if (form == tick.state.form) return;
    const Body body = body_of(volume_of(tick.settings, form), tick.settings.skin, tick.up);
    // The feet stay where they are.
    Vec raise = tick.up * (body.foot - tick.body.foot);
    Vec position = tick.position + raise;
    bool room = has_room(tick, body, position);
    if (!room) {
        raise = tick.up * raise_on_ground(tick, body);
        position = tick.position + raise;
        room = has_room(tick, body, position);
    }
    // Beside a wall a wider body has room farther from it, and hands reach it with a narrower one that is nearer.
    const bool beside_wall = form == CharacterForm::on_ledge || tick.state.form == CharacterForm::on_ledge;
    const double wider = body.half_width - tick.body.half_width;
    if (!room && beside_wall && wider > 0) {
        position = away_from_wall(tick, wider) + raise;
        room = has_room(tick, body, position);
    }
    tick.tell({.normal = to_dvec3(tick.up),
               .value = dot(raise, tick.up),
               .act = room ? StepAct::changed_form : StepAct::form_refused,
               .rule = room ? StepRule::none : StepRule::head_room});
    if (!room) {
        tick.say(CharacterEvent::no_room);
        return;
    }
    tick.state.form = form;
    tick.body = body;
    tick.surroundings.forget_body();
    tick.position = position;
    if (form == CharacterForm::on_ledge && wider < 0) tick.position = away_from_wall(tick, wider);
}

}  // namespace surefoot::internal
