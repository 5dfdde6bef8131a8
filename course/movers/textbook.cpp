#include "course/movers/textbook.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <surefoot/overlap.hpp>

#include "course/movers/movers.hpp"

namespace surefoot::course {
namespace {

constexpr WorldQuery at_end{.begin = 1, .end = 1};

double dot(const dvec3& a, const dvec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

dvec3 cross(const dvec3& a, const dvec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

double size_of(const dvec3& v) {
    return std::sqrt(dot(v, v));
}

struct Plane {
    dvec3 normal;
    std::uint32_t body;
};

/// The motion nearest to the wish that enters none of the planes.
dvec3 nearest_allowed(const dvec3& wish, const std::vector<Plane>& planes) {
    const double hair = 1e-9 * size_of(wish);
    const auto is_allowed = [&](const dvec3& way) {
        return std::all_of(planes.begin(), planes.end(),
                           [&](const Plane& plane) { return dot(plane.normal, way) >= -hair; });
    };
    if (is_allowed(wish)) return wish;
    dvec3 best{0, 0, 0};
    const auto offer = [&](const dvec3& way) {
        if (dot(way, wish) > dot(best, wish) && is_allowed(way)) best = way;
    };
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const dvec3& a = planes[i].normal;
        offer(wish - a * dot(a, wish));
        for (std::size_t k = 0; k < i; ++k) {
            const dvec3 crease = cross(a, planes[k].normal);
            const double square = dot(crease, crease);
            if (square > 1e-12) offer(crease * (dot(crease, wish) / square));
        }
    }
    return best;
}

struct Ground {
    double distance = 0;
    bool walkable = false;
};

class Textbook final : public Mover {
public:
    explicit Textbook(const Faults& faults) : faults_(faults) {}

    [[nodiscard]] bool takes(const Shape& /*shape*/) const override { return true; }
    void load(const Run& run) override {
        level_ = std::make_unique<LevelWorld>(*run.level);
        settings_ = run.settings;
        if (faults_.human_lengths) {
            settings_.skin = hero().skin;
            settings_.step_depth = hero().step_depth;
            settings_.snap_down = hero().snap_down;
            settings_.step_up = hero().step_up;
        }
        position_ = run.start;
        vertical_ = 0;
        ticks_ = 0;
        grounded_ = jump_held_ = false;
        flattest_ = faults_.any_slope ? 0 : std::cos(radians(settings_.slope_limit_deg));
    }

    Answer tick(const Input& input, double dt, std::span<const Pose> poses) override {
        level_->move_to(poses);
        if (input.jump && !jump_held_ && grounded_) {
            vertical_ = std::sqrt(2 * settings_.gravity * settings_.jump_height);
            grounded_ = false;
        }
        jump_held_ = input.jump;
        if (grounded_) {
            go_on_foot(input.wish * dt);
        } else {
            fall(input.wish * dt, dt);
        }
        // Every other tick, as solvers do that find in one tick what the one before left too close.
        if (faults_.pushes_too_far && ++ticks_ % 2 == 0) (void)push_out(1.4 * settings_.skin);
        if (faults_.single_precision) position_ = dvec3(vec3(position_));
        return {position_, grounded_};
    }

private:
    [[nodiscard]] GrownBody swept() const { return grown_body(settings_, faults_.pads_velocity ? 0 : settings_.skin); }
    [[nodiscard]] std::optional<Hit> sweep(const dvec3& from, const dvec3& way) const {
        const GrownBody body = swept();
        const dvec3 at = from + body.reference;
        return level_->world().sweep(body.volume, {at, at + way}, at_end);
    }
    std::size_t overlap_with(double skin, std::span<Overlap> found) const {
        const GrownBody body = grown_body(settings_, skin);
        return level_->world().overlap(body.volume, position_ + body.reference, found, at_end);
    }

    /// Triangles that touch a small ball: what meets at a point.
    template <typename Visit>
    void around(const dvec3& point, const Visit& visit) const {
        const double reach = 0.5 * settings_.skin;
        SourceTriangle near[64];
        const dvec3 wide{reach, reach, reach};
        const std::size_t found = level_->world().gather({point - wide, point + wide}, near, at_end);
        for (std::size_t i = 0; i < std::min<std::size_t>(found, 64); ++i) {
            if (!overlap(Sphere{reach}, point, near[i].triangle)) continue;
            const Triangle& triangle = near[i].triangle;
            const dvec3 across = cross(triangle.b - triangle.a, triangle.c - triangle.a);
            if (!(size_of(across) > 0)) continue;
            const dvec3 normal = across * (1 / size_of(across));
            visit(near[i], dot(normal, position_ - triangle.a) < 0 ? -normal : normal);
        }
    }

    /// An edge or a vertex that a face beside it reaches out over has that face's normal.
    [[nodiscard]] dvec3 without_seam(const dvec3& point, const dvec3& normal, Feature feature,
                                     std::uint32_t body) const {
        if (faults_.raw_edges || feature == Feature::face) return normal;
        dvec3 best = normal;
        around(point, [&](const SourceTriangle& near, const dvec3& face) {
            if (faults_.one_body && near.body != body) return;
            if (dot(face, normal) < 0) return;
            const Triangle& t = near.triangle;
            const double out = std::max({dot(normal, t.a - point), dot(normal, t.b - point), dot(normal, t.c - point)});
            if (out > 0.1 * settings_.skin) best = face;
        });
        return best;
    }

    /// On foot, what is too steep is a wall.
    [[nodiscard]] dvec3 as_wall(const dvec3& normal) const {
        if (!grounded_ || normal.y <= 1e-6 || normal.y >= flattest_) return normal;
        const double run = std::hypot(normal.x, normal.z);
        return {normal.x / run, 0, normal.z / run};
    }

    void touched(std::vector<Plane>& planes) const {
        std::vector<Overlap> found(128);
        const std::size_t count = overlap_with(1.2 * settings_.skin, found);
        for (std::size_t i = 0; i < std::min(count, found.size()); ++i) {
            const Overlap& touch = found[i];
            if (touch.status != HitStatus::ok) continue;
            if (faults_.one_body && !planes.empty() && planes.front().body != touch.body) continue;
            planes.push_back({as_wall(without_seam(touch.point, touch.normal, touch.feature, touch.body)), touch.body});
        }
    }

    /// Moves; the normal of the first wall that was met, if there was one.
    std::optional<dvec3> slide(const dvec3& wish) {
        std::optional<dvec3> wall;
        const dvec3 target = position_ + wish;
        if (faults_.moves_first) {
            position_ = target;
            return push_out(settings_.skin);
        }
        std::vector<Plane> planes;
        if (!faults_.hit_by_hit) touched(planes);
        for (const Plane& plane : planes) {
            if (std::abs(plane.normal.y) < 0.1 && dot(plane.normal, wish) < 0) wall = plane.normal;
            if (plane.normal.y < -0.1) met_ceiling_ = true;
        }
        dvec3 rest = wish;
        for (int pass = 0; pass < 6; ++pass) {
            const dvec3 way = faults_.hit_by_hit ? rest : nearest_allowed(target - position_, planes);
            const double length = size_of(way);
            if (length <= 1e-12) break;
            const auto hit = sweep(position_, way);
            if (!hit) {
                position_ = position_ + way;
                break;
            }
            const double gone =
                faults_.pads_velocity ? std::max(0.0, hit->t * length - settings_.skin) : hit->t * length;
            position_ = position_ + way * (gone / length);
            const dvec3 normal = as_wall(without_seam(hit->point, hit->normal, hit->feature, hit->body));
            if (normal.y < flattest_ && normal.y > -0.1 && !wall) wall = normal;
            if (normal.y < -0.1) met_ceiling_ = true;
            if (faults_.stops) break;
            rest = way * (1 - gone / length);
            rest = rest - normal * std::min(0.0, dot(rest, normal));
            if (faults_.one_body && !planes.empty() && planes.front().body != hit->body) planes.clear();
            planes.push_back({normal, hit->body});
        }
        return wall;
    }

    std::optional<dvec3> push_out(double skin) {
        std::optional<dvec3> wall;
        std::vector<Overlap> found(128);
        for (int pass = 0; pass < 8; ++pass) {
            const std::size_t count = overlap_with(skin, found);
            const Overlap* deepest = nullptr;
            for (std::size_t i = 0; i < std::min(count, found.size()); ++i) {
                if (!deepest || found[i].depth > deepest->depth) deepest = &found[i];
            }
            if (!deepest || deepest->depth < 1e-9) break;
            position_ = position_ + deepest->normal * deepest->depth;
            if (deepest->normal.y < flattest_ && deepest->normal.y > -0.1) wall = deepest->normal;
            if (deepest->normal.y < -0.1) met_ceiling_ = true;
        }
        return wall;
    }

    [[nodiscard]] std::optional<Ground> ground_below(const dvec3& from, double depth) const {
        const auto hit = sweep(from, {0, -depth, 0});
        if (!hit) return std::nullopt;
        Ground ground{hit->t * depth, hit->normal.y >= flattest_};
        around(hit->point, [&](const SourceTriangle&, const dvec3& face) {
            if (!faults_.steps_by_tick && face.y >= flattest_) ground.walkable = true;
        });
        return ground;
    }

    void go_on_foot(const dvec3& way) {
        const dvec3 from = position_;
        const bool has_way = size_of(way) > 0;
        if (has_way) {
            if (slide(way) && settings_.step_up > 0) step_up(from, way);
        }
        const auto ground = ground_below(position_, settings_.snap_down + settings_.skin);
        grounded_ = ground && ground->walkable;
        if (grounded_ && ground->distance > 0.05 * settings_.skin) position_.y -= ground->distance;
        vertical_ = 0;
    }

    void step_up(const dvec3& from, const dvec3& way) {
        const dvec3 slid = position_;
        const double length = size_of(way);
        const auto above = sweep(from, {0, settings_.step_up, 0});
        const double height = above ? above->t * settings_.step_up : settings_.step_up;
        const dvec3 raised = from + dvec3{0, height, 0};
        const auto forward = [&](double far) {
            position_ = raised;
            const dvec3 ahead = way * (far / length);
            const auto hit = sweep(raised, ahead);
            return raised + ahead * (hit ? hit->t : 1.0);
        };
        const dvec3 probe = forward(faults_.steps_by_tick ? length : std::max(length, settings_.step_depth));
        const auto landing = ground_below(probe, height);
        const double risen = landing ? height - landing->distance : 0;
        position_ = slid;
        if (!landing || !landing->walkable || risen <= settings_.skin) return;
        const dvec3 place = forward(length);
        const auto ground = ground_below(place, height);
        position_ = slid;
        if (ground && dot(place - slid, way) > 0) position_ = place - dvec3{0, ground->distance, 0};
    }

    void fall(const dvec3& way, double dt) {
        vertical_ = std::max(vertical_ - settings_.gravity * dt, -settings_.terminal_speed);
        const dvec3 from = position_;
        met_ceiling_ = false;
        slide(way + dvec3{0, vertical_ * dt, 0});
        if (met_ceiling_) vertical_ = std::min(vertical_, 0.0);
        if (vertical_ > 0) return;
        vertical_ = std::max(vertical_, std::min(0.0, (position_.y - from.y) / dt));
        const auto ground = ground_below(position_, 0.5 * settings_.skin);
        grounded_ = settings_.gravity > 0 && ground && ground->walkable;
        if (grounded_) vertical_ = 0;
    }

    Faults faults_;
    CharacterSettings settings_;
    std::unique_ptr<LevelWorld> level_;
    dvec3 position_{0, 0, 0};
    double vertical_ = 0;
    double flattest_ = 0;
    bool grounded_ = false;
    bool jump_held_ = false;
    bool met_ceiling_ = false;
    int ticks_ = 0;
};

}  // namespace

std::unique_ptr<Mover> make_textbook(const Faults& faults) {
    return std::make_unique<Textbook>(faults);
}

}  // namespace surefoot::course
