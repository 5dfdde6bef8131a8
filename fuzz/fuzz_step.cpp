// Any bytes, as a small world and the step of a character in it: no NaN comes out, nothing is gone through, and the
// answer is the same bits however it is asked for.
#include <array>
#include <bit>
#include <cstring>

#include "step_case.hpp"

namespace {

using namespace fuzz;
using surefoot::CharacterEvent;

// A step of a minute in parts of a hundredth of a second would only look like a hang.
bool is_short(const StepCase& given) {
    return !(given.dt > 4 * given.settings.longest_tick);
}

bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_bits(const surefoot::dvec3& a, const surefoot::dvec3& b) {
    return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}

bool same_bits(const surefoot::CharacterState& a, const surefoot::CharacterState& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;  // there is no padding in it
}

bool same_bits(const surefoot::CharacterEvents& a, const surefoot::CharacterEvents& b) {
    return a.set == b.set && same_bits(a.landing_speed, b.landing_speed) && same_bits(a.blocked_by, b.blocked_by) &&
           a.blocked_body == b.blocked_body && a.blocked_triangle == b.blocked_triangle;
}

bool same_bits(const surefoot::CharacterContacts& a, const surefoot::CharacterContacts& b) {
    if (a.count != b.count) return false;
    for (std::size_t i = 0; i < a.count; ++i) {
        const surefoot::CharacterContact& one = a.all[i];
        const surefoot::CharacterContact& other = b.all[i];
        if (!same_bits(one.point, other.point) || !same_bits(one.normal, other.normal) ||
            !same_bits(one.impulse, other.impulse) || one.body != other.body || one.triangle != other.triangle) {
            return false;
        }
    }
    return true;
}

bool same_bits(const surefoot::StepResult& a, const surefoot::StepResult& b) {
    return same_bits(a.state, b.state) && same_bits(a.events, b.events) && same_bits(a.contacts, b.contacts);
}

bool is_zero_or_unit(const surefoot::dvec3& v) {
    return v == surefoot::dvec3(0, 0, 0) || is_about_unit(v);
}

void require_finite(const surefoot::CharacterState& state) {
    require(is_finite(state.position) && is_finite(state.velocity), "no NaN and no infinity in a motion");
    require(is_finite(state.ground_normal) && is_finite(state.ground_velocity), "nor in what carries it");
    require(is_finite(state.wall_normal) && is_finite(state.ledge_point), "nor in a wall or an edge");
    for (const double time :
         {state.since_ground, state.since_jump_press, state.since_wall, state.since_dash, state.since_hold}) {
        require(time >= 0, "a time that has passed is not negative, and a number");
    }
}

void require_in_range(const surefoot::StepResult& result) {
    const surefoot::CharacterEvents& events = result.events;
    constexpr auto last = static_cast<std::uint32_t>(CharacterEvent::met_neighbour);
    require(events.set < 2 * last, "no event that has no name");
    require(events.landing_speed >= 0 && std::isfinite(events.landing_speed), "a landing has a speed");
    require(is_zero_or_unit(events.blocked_by), "what blocked it has a normal");
    require(!events.has(CharacterEvent::met_neighbour) || events.has(CharacterEvent::blocked),
            "a neighbour that was met blocked it");
    require(result.contacts.count <= result.contacts.all.size(), "there are as many contacts as there is room for");
    for (const surefoot::CharacterContact& contact : result.contacts.get()) {
        require(is_finite(contact.point) && is_finite(contact.impulse), "no NaN and no infinity in a contact");
        require(is_about_unit(contact.normal), "a contact has a normal");
    }
    require(is_zero_or_unit(result.state.ground_normal), "ground has a normal");
}

// The settings with the body of a form for its only one.
surefoot::CharacterSettings with_body_of(const surefoot::CharacterSettings& settings, surefoot::CharacterForm form) {
    surefoot::CharacterSettings one = settings;
    const auto take = [&](const std::optional<surefoot::Volume>& volume) { one.volume = volume.value_or(one.volume); };
    if (form == surefoot::CharacterForm::crouched) take(settings.crouched);
    if (form == surefoot::CharacterForm::in_air) take(settings.in_air);
    if (form == surefoot::CharacterForm::on_ramp) take(settings.on_ramp);
    if (form == surefoot::CharacterForm::on_ledge) take(settings.on_ledge);
    return one;
}

bool is_in_room(const surefoot::dvec3& position) {
    return std::abs(position.x) < StepCase::room && std::abs(position.y) < StepCase::room &&
           std::abs(position.z) < StepCase::room;
}

// Whoever touched nothing when the tick began touches nothing when it has ended, and is in the room that it was in.
void require_not_through(const StepCase& given, const surefoot::StepResult& result) {
    if (given.has_one_way || given.moves) return;
    const auto is_clear = [&](const surefoot::CharacterState& state) {
        return fits(given.world, with_body_of(given.settings, state.form), state.position, given.input.up);
    };
    if (!is_clear(given.state)) return;
    require(is_clear(result.state), "what was clear is never in a wall");
    require(!given.in_room || !is_in_room(given.state.position) || is_in_room(result.state.position),
            "nobody leaves a closed room");
}

void require_same_together(const StepCase& given, const surefoot::StepResult& alone) {
    std::array<surefoot::CharacterState, 3> before{given.state, given.state, given.state};
    before[1].position.x += 0.5;
    before[2].position.y += 0.125;
    std::array<surefoot::CharacterState, 3> after{};
    std::array<surefoot::CharacterEvents, 3> events{};
    const surefoot::Characters all{.settings = {&given.settings, 1},
                                   .inputs = {&given.input, 1},
                                   .before = before,
                                   .after = after,
                                   .events = events};
    step_all(given.world, all, given.dt);
    if (given.neighbours.empty() && !given.with_hooks) {
        require(same_bits(after[0], alone.state) && same_bits(events[0], alone.events),
                "of many each is stepped as if by itself");
    }
    surefoot::Crowd crowd;
    if (!crowd.gather(all, given.dt)) return;
    step_all(given.world, crowd, all, given.dt, {0, 1});
    step_all(given.world, crowd, all, given.dt, {1, 3});
    for (std::size_t i = 0; i < before.size(); ++i) {
        std::array<surefoot::Neighbour, surefoot::most_met_in_crowd> near;
        const std::size_t count = crowd.neighbours(i, near);
        const auto one =
            step(given.world, given.settings, given.input, given.dt, before[i], std::span(near).first(count));
        require(same_bits(after[i], one.state) && same_bits(events[i], one.events),
                "in a crowd each is stepped as if by itself among its neighbours");
        if (!one.events.has(CharacterEvent::invalid)) require_finite(after[i]);
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes({data, size});
    const StepCase given(bytes);
    if (!is_short(given)) return 0;
    const auto respond = [&](const surefoot::MetOnTheWay&) { return given.own; };
    const auto move = [&](const surefoot::OwnTick&) { return given.own; };
    surefoot::CharacterHooks hooks;
    if (given.with_hooks) hooks = {.respond = respond, .move = move};
    const auto ask = [&](surefoot::StepTrace* trace) {
        return step(given.world, given.settings, given.input, given.dt, given.state, given.neighbours, trace, hooks);
    };
    const surefoot::StepResult result = ask(nullptr);
    require(same_bits(result, ask(nullptr)), "a step depends on its arguments alone");
    std::array<surefoot::StepRecord, 64> room;
    surefoot::StepTrace trace(room);
    require(same_bits(result, ask(&trace)), "a trace changes no answer");
    if (given.together) require_same_together(given, result);
    if (result.events.has(CharacterEvent::invalid)) {
        require(same_bits(result.state, given.state), "what is invalid leaves the state as it was");
        require(result.contacts.count == 0, "and presses against nothing");
        return 0;
    }
    require_finite(result.state);
    require_in_range(result);
    require_not_through(given, result);
    return 0;
}
