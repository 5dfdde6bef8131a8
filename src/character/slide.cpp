#include "character/slide.hpp"

#include <optional>

#include "character/motion.hpp"
#include "character/neighbours.hpp"
#include "character/seams.hpp"

namespace surefoot::internal {

namespace {

// Each pass goes on to the next touch. Corners take three, a funnel some more; what takes longer than this is rough
// ground at high speed, and waits for the next tick.
constexpr int most_passes = 12;

// Motions below this share of the wish are rest.
constexpr double rest = 1e-9;

// Longer moves than this many times the body's size are first asked of the world's own tree.
constexpr double leap_from = 4;

// How often a slide asks for more touches where all that there was room for can be passed over.
constexpr int most_pages = 32;

// The plane as a wall: its normal as seen from above. Nothing for level ground.
std::optional<Vec> wall_of(const Vec& normal, const Vec& up) noexcept {
    const Vec level = normal - up * dot(normal, up);
    const double run = length(level);
    return run > 1e-6 ? std::optional(level / run) : std::nullopt;
}

// The same of what is too steep to be stood on and does not hang over.
std::optional<Vec> steep_wall_of(const Vec& normal, const Gait& gait) noexcept {
    const double rises = dot(normal, gait.up);
    return rises > 0 && rises < gait.least_ground_up ? wall_of(normal, gait.up) : std::nullopt;
}

class Slide {
public:
    Slide(Surroundings& surroundings, const Body& body, const Gait& gait, const Vec& from, const Vec& wish,
          const Planes3& planes) noexcept
        : surroundings_(surroundings), body_(body), gait_(gait), target_(from + wish), wish_length_(length(wish)) {
        result_.position = from;
        result_.planes = planes;
        given_ = planes;
        velocity_ = gait.velocity;
        size_ = body.size();
    }

    SlideResult run() noexcept {
        for (int pass = 0; pass < most_passes; ++pass) {
            const Vec wish = target_ - result_.position;
            const Vec motion = allowed(wish);
            if (length(motion) <= rest * wish_length_) {
                if (wish_length_ > 0) tell({.motion = to_dvec3(wish), .act = StepAct::rested});
                return result_;
            }
            tell({.motion = to_dvec3(motion), .act = StepAct::pass});
            if (go(motion) || gait_.stops) return result_;
        }
        return result_;
    }

private:
    void tell(StepRecord record) const noexcept {
        surroundings_.tell([&] {
            record.position = to_dvec3(result_.position);
            return record;
        });
    }

    void tell(StepAct act, const Touch& touch, const Vec& normal, StepRule rule = StepRule::none, double value = 0,
              double limit = 0) const noexcept {
        surroundings_.tell([&] {
            const Named named = surroundings_.name_of(touch);
            return StepRecord{.position = to_dvec3(result_.position),
                              .point = to_dvec3(touch.point),
                              .normal = to_dvec3(normal),
                              .value = value,
                              .limit = limit,
                              .triangle = named.triangle,
                              .body = named.body,
                              .act = act,
                              .rule = rule,
                              .feature = touch.feature};
        });
    }

    Vec allowed(const Vec& wish) const noexcept {
        return gait_.on_foot ? result_.planes.nearest_on_foot(wish, gait_.up) : result_.planes.nearest_to(wish);
    }

    // True when the slide is over.
    bool go(const Vec& motion) noexcept {
        const double way = length(motion);
        if (way > leap_from * size_) return leap(motion, way);
        return !find_touches(motion) || go_to_first(motion, way);
    }

    // Everything that the motion may touch; with what is beside it, for the seams. False if there is no room for it.
    bool find_touches(const Vec& motion) noexcept {
        if (!surroundings_.cover(body_.around(result_.position, motion, 2 * gait_.skin))) {
            tell({.act = StepAct::overflow});
            result_.overflow = true;
            return false;
        }
        sweep(motion);
        return true;
    }

    void sweep(const Vec& motion) noexcept {
        surroundings_.sweep(body_, result_.position, motion, touches_);
        surroundings_.neighbours().sweep(result_.position, motion, touches_);
    }

    // A long way: to where the world says that something is met, less a body's size, which is then gone with care.
    bool leap(const Vec& motion, double way) noexcept {
        const Vec from = result_.position + body_.shift;
        // One-way surfaces are none to what rises.
        const bool rises = dot(motion, gait_.up) > 0;
        const auto exists = [&](std::uint32_t, std::uint32_t, std::uint32_t surface) {
            return !(rises && surroundings_.rule_of(surface).one_way);
        };
        WorldQuery query = surroundings_.query();
        query.triangles = BodyTriangleFilter(exists);
        const auto hit = surroundings_.world().sweep(body_.kept_off, {to_dvec3(from), to_dvec3(from + motion)}, query);
        const double t = surroundings_.neighbours().first(result_.position, motion, hit ? hit->t : 2);
        if (t > 1) {
            result_.position = result_.position + motion;
            return true;
        }
        const double room = t * way - size_;
        if (room > 0) result_.position = result_.position + motion * (room / way);
        const Vec near = motion * (2 * size_ / way);
        if (!find_touches(near)) return true;
        (void)go_to_first(near, 2 * size_);
        return false;
    }

    bool go_to_first(const Vec& motion, double way) noexcept {
        const std::size_t planes_before = result_.planes.normals().size();
        const Touch* first = nullptr;
        std::size_t place = 0;
        while ((first = touches_.at(place++)) != nullptr) {
            if (first->status != HitStatus::ok) return true;  // it cannot be trusted to be free
            if (meet(*first, motion)) break;
        }
        if (first == nullptr) return go_past_all(motion, way);
        const double t = first->t;
        const double window = met_together * gait_.skin;
        while (const Touch* next = touches_.at(place++, t + surely_later * (window / way))) {
            if ((next->t - t) * way > window) break;
            if (next->status == HitStatus::ok) (void)meet(*next, motion);
        }
        if (t > 0) result_.position = result_.position + motion * t;
        if (gait_.respond != nullptr && !result_.overflow) ask_user(*first, planes_before);
        return result_.overflow;
    }

    // Nothing that is known of is in the way. True when the slide is over.
    bool go_past_all(const Vec& motion, double way) noexcept {
        if (!touches_.lost_some()) {
            result_.position = result_.position + motion;
            return true;
        }
        if (++pages_ <= most_pages && touches_.turn_page()) {
            sweep(motion);
            return go_to_first(motion, way);
        }
        result_.position = result_.position + motion * touches_.latest();
        tell({.act = StepAct::overflow});
        result_.overflow = true;
        return true;
    }

    // The user's own response to what is touched now. What was met before is behind it.
    void ask_user(const Touch& touch, std::size_t planes_before) noexcept {
        Planes3 planes = given_;
        const std::span<const Vec> met = result_.planes.normals().subspan(planes_before);
        for (const Vec& normal : met) (void)planes.add(normal);
        const Named named = surroundings_.name_of(touch);
        const OwnMotion answer =
            (*gait_.respond)({.position = to_dvec3(result_.position),
                              .point = to_dvec3(touch.point),
                              .normal = to_dvec3(met.empty() ? touch.normal : met.front()),
                              .left = {.way = to_dvec3(target_ - result_.position), .velocity = to_dvec3(velocity_)},
                              .body = named.body,
                              .triangle = named.triangle,
                              .surface = touch.is_neighbour ? 0 : surroundings_.triangle(touch.index).surface,
                              .is_neighbour = touch.is_neighbour,
                              .on_foot = gait_.on_foot});
        target_ = result_.position + finite_or_none(answer.way);
        velocity_ = finite_or_none(answer.velocity);
        result_.planes = planes;
        result_.answered = velocity_;
    }

    // Is this touch in the way of the motion? If it is, its planes are obeyed from now on.
    bool meet(const Touch& touch, const Vec& motion) noexcept {
        if (touch.is_neighbour) return meet_neighbour(touch, motion);
        const Vec centre = result_.position + motion * touch.t;
        const Faces faces = faces_of(touch, surroundings_, body_, gait_.skin, centre, gait_.up);
        const double way = length(motion);
        bool in_the_way = false;
        for (const Vec& normal : faces.get()) {
            // What is obeyed already is so within rounding.
            if (dot(normal, motion) >= -along_tolerance * way || result_.planes.has(normal)) continue;
            if (!in_the_way) tell(StepAct::touch, touch, touch.normal, StepRule::none, touch.t);
            if (faces.replaced) tell(StepAct::seam, touch, normal);
            in_the_way = true;
            obey(normal, touch, centre);
        }
        if (!in_the_way) tell(StepAct::passed_over, touch, faces.normals[0], StepRule::none, touch.t);
        return in_the_way;
    }

    // Neighbours are walls, however their bodies are rounded: nobody walks up another, or is pressed down by one.
    bool meet_neighbour(const Touch& touch, const Vec& motion) noexcept {
        const Vec& normal = touch.normal;
        if (dot(normal, motion) >= -along_tolerance * length(motion) || result_.planes.has(normal)) return false;
        tell(StepAct::met_neighbour, touch, normal, StepRule::none, touch.t);
        note(normal, touch, 0);
        const auto wall = wall_of(normal, gait_.up);
        bool room = result_.planes.add(normal);
        if (wall && gait_.on_foot) {
            room = result_.planes.add(*wall) && room;
        } else if (wall && dot(normal, gait_.up) > 0) {
            never_lift(*wall, normal, touch, result_.position + motion * touch.t);
        }
        if (!room) overflow(touch, normal);
        return true;
    }

    void obey(const Vec& normal, const Touch& touch, const Vec& centre) noexcept {
        const double rises = dot(normal, gait_.up);
        note(normal, touch, rises);
        tell(StepAct::obeyed, touch, normal);
        bool room = result_.planes.add(normal);
        if (rises >= gait_.least_ground_up && !gait_.on_foot) come_down(centre);
        const auto wall = steep_wall_of(normal, gait_);
        if (wall && gait_.on_foot) {
            tell(StepAct::wall, touch, *wall, StepRule::slope_limit, rises, gait_.least_ground_up);
            room = result_.planes.add(*wall) && room;
        } else if (wall) {
            never_lift(*wall, normal, touch, centre);
        }
        if (!room) overflow(touch, normal);
    }

    void overflow(const Touch& touch, const Vec& normal) noexcept {
        tell(StepAct::overflow, touch, normal);
        result_.overflow = true;
    }

    // On ground that can be stood on a fall ends; it is not led on down the slope.
    void come_down(const Vec& centre) noexcept {
        const double rise = dot(target_ - centre, gait_.up);
        if (rise < 0) target_ = target_ - gait_.up * rise;
    }

    // What is too steep is a wall to whatever goes into it: that part of the wish is given up, so that it is neither
    // climbed nor held on to. What falls on it goes on down its slope.
    void never_lift(const Vec& wall, const Vec& normal, const Touch& touch, const Vec& centre) noexcept {
        const double into = dot(wall, target_ - centre);
        if (into >= 0) return;
        target_ = target_ - wall * into;
        tell(StepAct::gave_up_rising, touch, normal, StepRule::slope_limit, dot(normal, gait_.up),
             gait_.least_ground_up);
    }

    void note(const Vec& normal, const Touch& touch, double rises) noexcept {
        const Named named = surroundings_.name_of(touch);
        const Vec wish = target_ - result_.position;
        const double scale = length(wish);
        Obstacle met{normal, touch.point, named.body, named.triangle, touch.is_neighbour, 0};
        if (scale > 0) met.share = -dot(normal, wish) / scale;
        if (met.share > result_.obstacle.share) result_.obstacle = met;
        if (touch.is_neighbour) return;  // nothing to step on to
        if (result_.met_count < result_.met.size()) result_.met[result_.met_count++] = met;
        if (rises < -0.1) result_.met_ceiling = true;
        if (rises >= gait_.least_ground_up || rises <= -0.5) return;
        if (result_.wall_count < result_.walls.size()) result_.walls[result_.wall_count++] = met;
    }

    Surroundings& surroundings_;
    const Body& body_;
    const Gait& gait_;
    Vec target_;
    double wish_length_;
    Planes3 given_;
    Vec velocity_;
    double size_ = 0;
    int pages_ = 0;
    SlideResult result_;
    Touches touches_;
};

}  // namespace

Gait answered_by(Gait gait, const OwnRule<MetOnTheWay>& respond, const Vec& velocity) noexcept {
    if (!respond) return gait;
    gait.respond = &respond;
    gait.velocity = velocity;
    gait.stops = false;
    return gait;
}

Vec velocity_along(const Planes3& planes, const Gait& gait, Vec velocity) noexcept {
    for (const Vec& normal : planes.normals()) {
        if (const auto wall = steep_wall_of(normal, gait))
            velocity = velocity - *wall * smaller(0, dot(*wall, velocity));
    }
    return planes.nearest_to(velocity);
}

SlideResult slide(Surroundings& surroundings, const Body& body, const Gait& gait, const Vec& from, const Vec& wish,
                  const Planes3& planes) noexcept {
    return Slide(surroundings, body, gait, from, wish, planes).run();
}

}  // namespace surefoot::internal
