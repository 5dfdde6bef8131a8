#include "character/ground.hpp"

#include "character/seams.hpp"

namespace surefoot::internal {

namespace {

// Who slips by no more than this share of the skin is held. Edges of a box and a rim are met at several places at once,
// which are as far apart as rounding takes them.
constexpr double slips_less = 1e-9;

// Who walks at an edge at a smaller angle than this (as a sine) walks along it.
constexpr double towards_at_least = 0.1;

// Walking off an edge: does the ground go on below it, near enough to be followed? Asked of a place that is clear of
// the edge.
bool goes_on_below(Surroundings& surroundings, const Body& body, const Gait& gait, const GroundRule& rule,
                   const Vec& position, const Vec& edge, const Vec& aside) noexcept {
    const Vec clear = position - aside * ((body.half_width + 2 * gait.skin) / length(aside) - 1);
    const GroundRule strict{rule.perch_distance, {}};
    const double depth = 2 * rule.follows + gait.skin;
    // The touches here are still being gone through: another gather would put other triangles in their places.
    const auto below_in = [&](Surroundings& those) noexcept {
        return ground_under(those, body, gait, strict, clear, depth);
    };
    const auto below_in_others = [&]() noexcept {
        Surroundings others = surroundings.beside();
        return below_in(others);
    };
    const bool is_there = surroundings.covers(body.around(clear, gait.up * -depth, 2 * gait.skin));
    const Ground below = is_there ? below_in(surroundings) : below_in_others();
    if (!below.trusted || below.footing != Footing::ground) return false;
    return dot(edge - below.point, gait.up) <= rule.follows + gait.skin;
}

// Does an edge that is touched too steeply hold a body that walks?
bool holds_walking(Surroundings& surroundings, const Body& body, const Gait& gait, const GroundRule& rule,
                   const Vec& position, const Vec& edge, const Vec& aside) noexcept {
    const double ahead = dot(aside, rule.towards);
    if (ahead > towards_at_least * length(aside)) return true;  // up on to it
    if (ahead > -towards_at_least * length(aside) || !(rule.follows > 0)) return false;
    return goes_on_below(surroundings, body, gait, rule, position, edge, aside);
}

// Whether a touch holds a body, and if not, why.
struct Support {
    Footing footing = Footing::ground;
    StepRule rule = StepRule::none;
    double value = 0;
    double limit = 0;
};

Support support_of(Surroundings& surroundings, const Body& body, const Gait& gait, const GroundRule& rule,
                   const Vec& position, const Touch& touch, const Vec& normal, const Vec& surface) noexcept {
    const double rises = dot(surface, gait.up);
    if (surroundings.rule_of(surroundings.triangle(touch.index).surface).slippery) {
        return {Footing::steep, StepRule::slippery, 0, 0};
    }
    if (rises < gait.least_ground_up) return {Footing::steep, StepRule::slope_limit, rises, gait.least_ground_up};
    if (dot(normal, gait.up) >= gait.least_ground_up) return {};
    const Vec out = touch.point - position;
    const Vec aside = out - gait.up * dot(out, gait.up);
    if (dot(aside, aside) <= rule.perch_distance * rule.perch_distance) return {};
    if (holds_walking(surroundings, body, gait, rule, position, touch.point, aside)) return {};
    return {Footing::steep, StepRule::perch_distance, length(aside), rule.perch_distance};
}

}  // namespace

Ground ground_under(Surroundings& surroundings, const Body& body, const Gait& gait, const GroundRule& rule,
                    const Vec& position, double depth) noexcept {
    Ground ground;
    const Vec down = gait.up * -depth;
    if (!surroundings.cover(body.around(position, down, 2 * gait.skin))) {
        ground.trusted = false;
        return ground;
    }
    Touches touches;
    surroundings.sweep(body, position, down, touches, Wanted::some);
    double first = -1;
    const double window = met_together * gait.skin;
    const auto until = [&] { return first < 0 ? 1 : surely_later * ((first + window) / depth); };
    std::size_t place = 0;
    while (const Touch* next = touches.at(place++, until())) {
        const Touch& touch = *next;
        if (touch.status != HitStatus::ok) {
            ground.trusted = false;
            return ground;
        }
        const double distance = touch.t * depth;
        if (first >= 0 && distance > first + window) break;
        const SourceTriangle triangle = surroundings.triangle(touch.index);
        const Vec centre = position + down * touch.t;
        const Faces faces = faces_of(touch, surroundings, body, gait.skin, centre, gait.up);
        for (const Vec& normal : faces.get()) {
            if (dot(normal, gait.up) <= along_tolerance) continue;  // a seam in a wall
            if (first < 0) first = distance;
            const Vec surface = faces.replaced ? normal : faces.surface;
            const Support support = support_of(surroundings, body, gait, rule, centre, touch, normal, surface);
            const Footing footing = support.footing;
            const bool better = ground.footing == Footing::air ||
                                (footing == Footing::ground && ground.footing == Footing::steep) ||
                                (footing == ground.footing && dot(surface, gait.up) > dot(ground.normal, gait.up));
            if (!better) continue;
            ground = {footing,      first,         surface,       normal,
                      touch.point,  triangle.body, triangle.id,   triangle.surface,
                      support.rule, support.value, support.limit, true};
        }
    }
    if (first < 0 && touches.lost_some()) ground.trusted = false;
    return ground;
}

void stand_if_wedged(Surroundings& surroundings, const Body& body, const Gait& gait, const Vec& position,
                     Ground& ground) noexcept {
    if (ground.footing != Footing::steep || ground.rule == StepRule::slippery) return;
    Gait falling = gait;
    falling.on_foot = false;
    const SlideResult slid = slide(surroundings, body, falling, position, gait.up * -gait.skin, {});
    const Vec slipped = slid.position - position;
    if (dot(slipped, slipped) > slips_less * slips_less * gait.skin * gait.skin) return;
    ground.footing = Footing::ground;
    ground.normal = gait.up;
    ground.distance = 0;
}

}  // namespace surefoot::internal
