#include "character/walk.hpp"

#include <cmath>

#include "character/look.hpp"
#include "character/stairs.hpp"

namespace surefoot::internal {

namespace {

// The way is gone in pieces of this share of the body's half width, so that what is on it is seen however long a tick
// is; but in no more than so many.
constexpr double piece = 0.5;
constexpr int most_pieces = 16;

// A body this share of the skin above its ground rests on it. What is less is not moved.
constexpr double resting = 0.05;

class Walk {
public:
    Walk(Surroundings& surroundings, const Body& body, const Gait& gait, const CharacterSettings& settings,
         const OwnRule<MetOnTheWay>& respond) noexcept
        : surroundings_(surroundings), body_(body), gait_(gait), settings_(settings), respond_(respond) {}

    WalkResult run(const Vec& from, const Ground& ground, const Vec& way, const Vec& velocity) noexcept {
        result_.position = from;
        result_.ground = ground;
        result_.velocity = velocity;
        const double distance = length(way);
        const double share = distance / (piece * body_.half_width);
        const int pieces = share > most_pieces ? most_pieces : share > 1 ? static_cast<int>(std::ceil(share)) : 1;
        const Vec towards = distance > 0 ? way / distance : Vec{};
        rule_ = {settings_.perch_distance, towards, settings_.snap_down};
        for (int i = 0; i < pieces; ++i) {
            if (distance > 0) advance(way / static_cast<double>(pieces));
            settle();
            if (result_.ground.footing != Footing::ground) {
                result_.done = static_cast<double>(i + 1) / static_cast<double>(pieces);
                break;
            }
        }
        return result_;
    }

private:
    void advance(const Vec& level) noexcept {
        const Vec from = result_.position;
        Planes3 planes;
        (void)planes.add(result_.ground.normal);
        const SlideResult slid = slide(surroundings_, body_, answered_by(gait_, respond_, result_.velocity), from,
                                       along_ground(level), planes);
        result_.met_ceiling = result_.met_ceiling || slid.met_ceiling;
        result_.overflow = result_.overflow || slid.overflow;
        result_.position = slid.position;
        if (slid.wall_count > 0 && !(settings_.step_up > 0)) tell_steps_off(slid.walls[0].normal, level);
        for (std::size_t i = 0; i < slid.wall_count && settings_.step_up > 0; ++i) {
            const Vec& wall = slid.walls[i].normal;
            if (dot(wall, level) >= 0) continue;
            const StepSettings settings{settings_.step_up, settings_.step_depth};
            surroundings_.cover_as_well(box_of_step(body_, gait_, settings, from, level, wall));
            const auto stepped =
                internal::step_up(surroundings_, body_, gait_, rule_, settings, from, slid.position, level, wall);
            if (!stepped || dot(stepped->position - slid.position, level) <= 0) continue;
            result_.position = stepped->position;
            result_.stepped_up = true;
            return;
        }
        if (slid.obstacle.share > result_.obstacle.share) result_.obstacle = slid.obstacle;
        for (std::size_t i = 0; i < slid.met_count && result_.met_count < result_.met.size(); ++i) {
            result_.met[result_.met_count++] = slid.met[i];
        }
        const Vec velocity = slid.planes.nearest_on_foot(slid.answered.value_or(result_.velocity), gait_.up);
        result_.velocity = velocity - gait_.up * dot(velocity, gait_.up);
    }

    void tell_steps_off(const Vec& wall, const Vec& level) const noexcept {
        surroundings_.tell([&] {
            const Vec out = wall - gait_.up * dot(wall, gait_.up);
            const Vec towards = out * (dot(out, level) / larger(dot(out, out), 1e-300));
            const Ahead ahead =
                look_ahead(surroundings_, body_, gait_, rule_, {0, settings_.step_depth}, result_.position, towards);
            return StepRecord{.position = to_dvec3(result_.position),
                              .motion = to_dvec3(level),
                              .point = to_dvec3(ahead.landing.point),
                              .normal = to_dvec3(ahead.landing.contact_normal),
                              .value = ahead.is_reached ? ahead.height : 0,
                              .triangle = ahead.landing.triangle,
                              .body = ahead.landing.body,
                              .act = StepAct::step_refused,
                              .rule = StepRule::steps_off};
        });
    }

    // The level way, led up or down by the plane that is stood on.
    Vec along_ground(const Vec& level) const noexcept {
        const Vec& normal = result_.ground.normal;
        const Vec way = level - gait_.up * (dot(normal, level) / dot(normal, gait_.up));
        if (settings_.slope_speed == SlopeSpeed::level) return way;
        return way * (length(level) / length(way));
    }

    // How far the body sinks beside an edge that holds it, compared with standing on the surface behind the edge.
    double dip_at(const Ground& ground) const noexcept {
        const Vec touching = result_.position - gait_.up * ground.distance + body_.shift;
        const double reaches = reach_along(body_.kept_off, -ground.normal);
        const double sunk = reaches - dot(touching - ground.point, ground.normal);
        return larger(0, sunk) / dot(ground.normal, gait_.up);
    }

    void settle() noexcept {
        const double depth = settings_.snap_down + gait_.skin;
        Ground ground = ground_under(surroundings_, body_, gait_, rule_, result_.position, depth);
        if (!ground.trusted) {
            result_.overflow = true;
            return;  // where it is it was standing before
        }
        stand_if_wedged(surroundings_, body_, gait_, result_.position, ground);
        if (settings_.flat_foot && ground.footing == Footing::ground) {
            ground.distance = larger(0, ground.distance - dip_at(ground));
        }
        result_.ground = ground;
        if (ground.footing != Footing::ground) return;
        if (ground.distance <= resting * gait_.skin) return;
        result_.position = result_.position - gait_.up * ground.distance;
        if (ground.distance <= gait_.skin) return;
        result_.snapped_down = true;
        surroundings_.tell([&] {
            return StepRecord{.position = to_dvec3(result_.position),
                              .point = to_dvec3(ground.point),
                              .normal = to_dvec3(ground.normal),
                              .value = ground.distance,
                              .limit = settings_.snap_down,
                              .triangle = ground.triangle,
                              .body = ground.body,
                              .act = StepAct::snapped_down};
        });
    }

    Surroundings& surroundings_;
    const Body& body_;
    const Gait& gait_;
    const CharacterSettings& settings_;
    const OwnRule<MetOnTheWay>& respond_;
    GroundRule rule_{0, {}};
    WalkResult result_;
};

}  // namespace

WalkResult walk(Surroundings& surroundings, const Body& body, const Gait& gait, const CharacterSettings& settings,
                const OwnRule<MetOnTheWay>& respond, const Vec& from, const Ground& ground, const Vec& way,
                const Vec& velocity) noexcept {
    return Walk(surroundings, body, gait, settings, respond).run(from, ground, way, velocity);
}

}  // namespace surefoot::internal
