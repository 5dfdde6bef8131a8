#include "character/look.hpp"

#include "character/body.hpp"

namespace surefoot::internal {

namespace {

// Each look is twice as high as the one before.
constexpr int most_looks = 6;

// How far down is looked, in heights of the body.
constexpr double depths = 4;

double height_of(const Body& body, const Gait& gait) noexcept {
    return body.foot + reach_along(body.volume, gait.up);
}

// One more step, as high as this.
class Look {
public:
    Look(const Surroundings& surroundings, const Body& body, const Gait& gait, const GroundRule& rule,
         const StepSettings& settings, const Vec& position, const Vec& level) noexcept
        : own_(surroundings.beside()),
          body_(body),
          gait_(gait),
          rule_{rule.perch_distance, {}},
          position_(position),
          ahead_(level / length(level)),
          probe_(larger(length(level), settings.step_depth)) {}

    // How far up there was room.
    double try_height(double height, Ahead& found) noexcept {
        const Raised raised = raise(own_, body_, gait_, position_, height);
        const Vec place = slide(own_, body_, gait_, raised.position, ahead_ * probe_, {}).position;
        if (dot(place - raised.position, ahead_) <= gait_.skin) return raised.height;
        Ground landing = ground_under(own_, body_, gait_, rule_, place, raised.height);
        const double higher = dot(landing.point - position_, gait_.up) + body_.foot;
        if (landing.footing != Footing::ground || higher <= 0) return raised.height;
        name_surface(landing);
        found = {higher, true, landing};
        return raised.height;
    }

    // How high the first thing ahead is, seen from the height of the head.
    double height_by_ray() noexcept {
        const double tall = height_of(body_, gait_);
        const Vec foot = position_ - gait_.up * body_.foot;
        const Vec beside = foot + ahead_ * (body_.half_width + 4 * gait_.skin);
        const auto hit = own_.world().ray({to_dvec3(beside + gait_.up * tall), to_dvec3(beside)}, own_.query());
        return hit && hit->status == HitStatus::ok ? (1 - hit->t) * tall : 0;
    }

private:
    // Resting on an edge it stands on what is behind the edge, and not on what is below it.
    void name_surface(Ground& landing) const noexcept {
        const Vec over = landing.point + (gait_.up + ahead_) * (2 * gait_.skin);
        const auto hit = own_.world().ray({to_dvec3(over), to_dvec3(over - gait_.up * (4 * gait_.skin))}, own_.query());
        if (!hit || hit->status != HitStatus::ok) return;
        landing.triangle = hit->triangle;
        landing.body = hit->body;
    }

    Surroundings own_;
    const Body& body_;
    const Gait& gait_;
    GroundRule rule_;
    Vec position_;
    Vec ahead_;
    double probe_;
};

}  // namespace

Ahead look_ahead(const Surroundings& surroundings, const Body& body, const Gait& gait, const GroundRule& rule,
                 const StepSettings& settings, const Vec& position, const Vec& level) noexcept {
    Ahead found;
    if (!(length(level) > 0)) return found;
    Look look(surroundings, body, gait, rule, settings, position, level);
    double height = larger(settings.step_up, 0x1p-4 * height_of(body, gait));
    for (int i = 0; i < most_looks && !found.is_reached; ++i) {
        height *= 2;
        const double room = look.try_height(height, found);
        if (room < height - gait.skin) break;
    }
    if (!found.is_reached) {
        found.height = look.height_by_ray();
        return found;
    }
    // From higher up another place may be reached than with a step that is just high enough.
    Ahead nearer;
    (void)look.try_height(found.height + gait.skin, nearer);
    return nearer.is_reached ? nearer : found;
}

Ground look_down(const Surroundings& surroundings, const Body& body, const Gait& gait, const Vec& position) noexcept {
    Surroundings own = surroundings.beside();
    return ground_under(own, body, gait, {body.half_width, {}}, position, depths * height_of(body, gait));
}

}  // namespace surefoot::internal
