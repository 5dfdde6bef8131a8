#include "character/ledge.hpp"

#include "character/body.hpp"
#include "character/form.hpp"
#include "character/seams.hpp"

namespace surefoot::internal {

namespace {

// The sizes of the probes, as shares of the body's half width.
constexpr double ball = 0.2;
constexpr double column = 0.25;

// At how many heights the ball looks for the wall.
constexpr int heights = 4;

// How far behind the edge its ground is looked for, in half widths.
constexpr double behind = 0.5;

class Finder {
public:
    explicit Finder(Tick& tick) noexcept : tick_(tick) {}

    std::optional<Ledge> find(const Vec& ahead, double low, double high) noexcept {
        const double width = tick_.body.half_width;
        const double reach = width + tick_.settings.ledge_reach;
        const Vec feet = tick_.position - tick_.up * tick_.body.foot;
        const Vec wide = Vec{1, 1, 1} * (reach + 2 * width + high);
        if (!tick_.surroundings.cover({feet - wide, feet + wide})) return std::nullopt;

        // The wall, at several heights from the lowest edge that would do to the highest.
        const Volume sphere = Sphere{ball * width};
        std::optional<Touch> wall;
        double distance = 0;
        for (int i = heights - 1; i >= 0; --i) {
            const double height = (low * (heights - 1 - i) + high * i) / (heights - 1) - ball * width;
            const Vec from = feet + tick_.up * height;
            const auto touch = first(sphere, from, ahead * reach, StepAct::ledge_wall);
            if (!touch || absolute(dot(touch->normal, tick_.up)) > wall_rises_at_most) continue;
            wall = touch;
            distance = touch->t * reach + ball * width;
            break;
        }
        if (!wall) return std::nullopt;
        const Vec level = tick_.level(wall->normal);
        const Vec out = level / length(level);
        if (dot(out, ahead) > -0.5) return std::nullopt;

        // The edge: what is let down behind the wall's face rests on its top.
        const Volume cylinder = upright(Cylinder{column * width, 0.5 * column * width});
        const double half = 0.5 * column * width;
        const Vec over = feet + ahead * distance - out * (column * width + tick_.gait.skin);
        const double start = high + half + tick_.gait.skin;
        const auto top =
            first(cylinder, over + tick_.up * start, tick_.up * (low - high - tick_.gait.skin), StepAct::ledge_edge);
        if (!top || top->t <= 0) return std::nullopt;
        const Vec surface = surface_under(*top, tick_.surroundings, tick_.gait.skin, over + tick_.up * start, tick_.up);
        if (dot(surface, tick_.up) < tick_.gait.least_ground_up) return refused(*top, StepRule::slope_limit);

        Ledge ledge;
        const double height = start - half + dot(tick_.up, tick_.up * (low - high - tick_.gait.skin)) * top->t;
        ledge.edge = over + tick_.up * height;
        ledge.wall = out;
        const SourceTriangle& triangle = tick_.surroundings.triangle(top->index);
        ledge.body = triangle.body;
        ledge.triangle = triangle.id;
        place(ledge, feet + ahead * distance, height);
        return ledge;
    }

private:
    Volume upright(const Shape& shape) const noexcept { return body_of(Volume(shape), 0, tick_.up).volume; }

    // Where it hangs, its hands on the edge, and where it stands when it has climbed.
    void place(Ledge& ledge, const Vec& face, double height) noexcept {
        const double width = tick_.body.half_width;
        const Vec off = ledge.wall * (width + tick_.gait.skin * 2);
        ledge.hang = face + off + tick_.up * (height - tick_.settings.hands_height + tick_.body.foot);
        // A body for edges is not the one that stands there.
        const Body stands = tick_.state.form == CharacterForm::on_ledge
                                ? body_of(tick_.settings.volume, tick_.settings.skin, tick_.up)
                                : tick_.body;
        const Vec above =
            face - ledge.wall * (behind * stands.half_width) + tick_.up * (height + stands.foot + tick_.gait.skin);
        ledge.stands = above;
        ledge.has_room = has_room(tick_, stands, above);
        if (!ledge.has_room) {
            tick_.tell({.point = to_dvec3(ledge.edge),
                        .triangle = ledge.triangle,
                        .body = ledge.body,
                        .act = StepAct::ledge_refused,
                        .rule = StepRule::head_room});
        }
    }

    std::optional<Touch> first(const Volume& probe, const Vec& from, const Vec& motion, StepAct act) noexcept {
        tick_.surroundings.sweep(probe, {}, reach_box(probe), from, motion, touches_);
        const Touch* const first = touches_.at(0);
        const bool met = first != nullptr;
        const Touch touch = met ? *first : Touch{};
        if (!met || touch.status == HitStatus::ok) {
            tick_.tell({.motion = to_dvec3(motion),
                        .point = to_dvec3(met ? touch.point : from),
                        .normal = to_dvec3(touch.normal),
                        .value = met ? touch.t : 1,
                        .triangle = met ? tick_.surroundings.triangle(touch.index).id : 0,
                        .body = met ? tick_.surroundings.triangle(touch.index).body : 0,
                        .act = act});
        }
        if (!met || touch.status != HitStatus::ok) return std::nullopt;
        return touch;
    }

    std::optional<Ledge> refused(const Touch& touch, StepRule rule) noexcept {
        tick_.tell({.point = to_dvec3(touch.point),
                    .normal = to_dvec3(touch.normal),
                    .triangle = tick_.surroundings.triangle(touch.index).id,
                    .body = tick_.surroundings.triangle(touch.index).body,
                    .act = StepAct::ledge_refused,
                    .rule = rule});
        return std::nullopt;
    }

    Tick& tick_;
    Touches touches_;
};

}  // namespace

std::optional<Ledge> find_ledge(Tick& tick, const Vec& ahead, double low, double high) noexcept {
    return Finder(tick).find(ahead, low, high);
}

}  // namespace surefoot::internal
