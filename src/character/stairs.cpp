#include "character/stairs.hpp"

namespace surefoot::internal {

namespace {

struct Raised {
    Vec position;
    double height;
};

// Straight up as far as there is room.
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

}  // namespace

std::optional<SteppedUp> step_up(Surroundings& surroundings, const Body& body, const Gait& gait, const GroundRule& rule,
                                 const StepSettings& settings, const Vec& position, const Vec& level) noexcept {
    const double way = length(level);
    if (!(way > 0)) return std::nullopt;
    const Vec ahead = level / way;
    const Raised raised = raise(surroundings, body, gait, position, settings.step_up);
    if (raised.height <= gait.skin) return std::nullopt;
    const auto forward = [&](double length) noexcept {
        return slide(surroundings, body, gait, raised.position, ahead * length, {}).position;
    };
    const auto down_from = [&](const Vec& place, const GroundRule& by) noexcept {
        return ground_under(surroundings, body, gait, by, place, raised.height + gait.skin);
    };
    // The question: is there ground ahead, higher than here? What is reached may lie beside, along a wall.
    const Vec probe = forward(larger(way, settings.step_depth));
    if (dot(probe - raised.position, ahead) <= gait.skin) return std::nullopt;
    const Ground landing = down_from(probe, {rule.perch_distance, {}});
    if (!landing.trusted || landing.footing != Footing::ground) return std::nullopt;
    const double risen = dot(probe - position, gait.up) - landing.distance;
    if (risen <= 0 || risen > settings.step_up + gait.skin) return std::nullopt;
    // The way.
    const Vec place = forward(way);
    const Ground ground = down_from(place, rule);
    if (!ground.trusted || ground.footing == Footing::air) return std::nullopt;
    SteppedUp stepped{place - gait.up * ground.distance, ground};
    // Half way on to a step a round body rests on its edge, more steeply than the rule for standing allows.
    if (stepped.ground.footing == Footing::steep) {
        stepped.ground.footing = Footing::ground;
        stepped.ground.normal = landing.normal;
    }
    return stepped;
}

}  // namespace surefoot::internal
