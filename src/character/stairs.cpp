#include "character/stairs.hpp"

#include "character/look.hpp"

namespace surefoot::internal {

namespace {

// The reason behind a refusal, if one is found: what looks like too far out on an edge, from as high as there is room
// or as a step may be, may only be too high. Only the trace wants to know it.
Refusal reason_of(const Surroundings& surroundings, const Body& body, const Gait& gait, const GroundRule& rule,
                  const StepSettings& settings, const Vec& position, const Vec& towards, double raised,
                  const Refusal& found) noexcept {
    if (!surroundings.is_traced()) return found;
    const Ahead ahead = look_ahead(surroundings, body, gait, rule, settings, position, towards);
    const bool lacks_room = raised < settings.step_up - gait.skin && raised < ahead.height;
    if (lacks_room) return {StepRule::head_room, raised, ahead.height, ahead.landing};
    const bool is_too_high = ahead.is_reached && ahead.height > settings.step_up;
    return is_too_high ? Refusal{StepRule::step_height, ahead.height, settings.step_up, ahead.landing} : found;
}

}  // namespace

Raised raise(Surroundings& surroundings, const Body& body, const Gait& gait, const Vec& position,
             double height) noexcept {
    Gait straight = gait;
    straight.on_foot = false;
    straight.stops = true;
    const Vec up = gait.up * height;
    const Vec top = slide(surroundings, body, straight, position, up, {}).position;
    const double risen = dot(top - position, gait.up);
    return {position + gait.up * risen, risen};
}

Box3 box_of_step(const Body& body, const Gait& gait, const StepSettings& settings, const Vec& position,
                 const Vec& level, const Vec& wall) noexcept {
    const Vec out = wall - gait.up * dot(wall, gait.up);
    const double run = length(out);
    const Vec ahead = run > 0 ? out * (-larger(-dot(level, out) / run, settings.step_depth) / run) : Vec{};
    const double margin = 3 * gait.skin;
    // From a skin below where it stands to the top, there ahead and by the way.
    const Vec top = position + gait.up * settings.step_up;
    Box3 box = body.around(position - gait.up * gait.skin, gait.up * (gait.skin + settings.step_up), margin);
    box.include(body.around(top, ahead, margin));
    box.include(body.around(top, level, margin));
    box.include(body.around(position, ahead, margin));
    box.include(body.around(position, level, margin));
    return box;
}

std::optional<SteppedUp> step_up(Surroundings& surroundings, const Body& body, const Gait& gait, const GroundRule& rule,
                                 const StepSettings& settings, const Vec& position, const Vec& stopped,
                                 const Vec& level, const Vec& wall) noexcept {
    const double way = length(level);
    if (!(way > 0)) return std::nullopt;
    const Vec out = wall - gait.up * dot(wall, gait.up);
    const double run = length(out);
    const Vec ahead = run > 0 ? out / -run : level / way;
    const auto tell = [&](StepAct act, StepRule decided, double value, double limit, const Ground& at = {}) noexcept {
        surroundings.tell([&] {
            return StepRecord{.position = to_dvec3(position),
                              .motion = to_dvec3(level),
                              .point = to_dvec3(at.point),
                              .normal = to_dvec3(at.contact_normal),
                              .value = value,
                              .limit = limit,
                              .triangle = at.triangle,
                              .body = at.body,
                              .act = act,
                              .rule = decided};
        });
    };
    const auto refuse = [&](StepRule decided, double value, double limit, const Ground& at = {}) noexcept {
        tell(StepAct::step_refused, decided, value, limit, at);
        return std::nullopt;
    };
    tell(StepAct::step_tried, StepRule::none, settings.step_up, settings.step_depth);
    const Raised raised = raise(surroundings, body, gait, position, settings.step_up);
    const auto refuse_or_why = [&](StepRule decided, double value, double limit, const Ground& at = {}) noexcept {
        const Refusal why = reason_of(surroundings, body, gait, rule, settings, position, ahead * dot(level, ahead),
                                      raised.height, {decided, value, limit, at});
        return refuse(why.rule, why.value, why.limit, why.at);
    };
    if (raised.height <= gait.skin) return refuse_or_why(StepRule::head_room, raised.height, settings.step_up);
    const auto forward = [&](const Vec& motion) noexcept {
        return slide(surroundings, body, gait, raised.position, motion, {}).position;
    };
    const auto down_from = [&](const Vec& place, const GroundRule& by) noexcept {
        return ground_under(surroundings, body, gait, by, place, raised.height + gait.skin);
    };
    // The question: is there ground ahead, higher than here? What is reached may lie beside, along a wall.
    const Vec probe = forward(ahead * larger(dot(level, ahead), settings.step_depth));
    const double advance = dot(probe - raised.position, ahead);
    if (advance <= gait.skin) return refuse_or_why(StepRule::no_advance, advance, gait.skin);
    const Ground landing = down_from(probe, {rule.perch_distance, {}});
    // On rough ground that leads down, what stopped it there may be no higher than where it came from.
    const double sunk = larger(0, dot(position - stopped, gait.up));
    const double risen = dot(probe - position, gait.up) - landing.distance + sunk;
    if (!landing.trusted || landing.footing == Footing::air) return refuse(StepRule::not_higher, 0, 0);
    if (landing.footing != Footing::ground) return refuse_or_why(landing.rule, landing.value, landing.limit, landing);
    if (risen <= 0) return refuse(StepRule::not_higher, risen, 0, landing);
    // What counts is where the ground is, not how far a round body has come up by resting on its edge.
    const double height = dot(landing.point - position, gait.up) + body.foot;
    if (height > settings.step_up + 0.1 * gait.skin) {
        return refuse_or_why(StepRule::step_height, height, settings.step_up, landing);
    }
    // The way.
    const Vec place = forward(level);
    const Ground ground = down_from(place, rule);
    if (!ground.trusted || ground.footing == Footing::air) return refuse(StepRule::not_higher, 0, 0);
    SteppedUp stepped{place - gait.up * ground.distance, ground};
    // Half way on to a step a round body rests on its edge, more steeply than the rule for standing allows.
    if (stepped.ground.footing == Footing::steep) {
        stepped.ground.footing = Footing::ground;
        stepped.ground.normal = landing.normal;
    }
    tell(StepAct::stepped_up, StepRule::none, dot(stepped.position - position, gait.up), settings.step_up, ground);
    return stepped;
}

}  // namespace surefoot::internal
