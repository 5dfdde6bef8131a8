// Hill climbing on the straight potential, and the ways out of its local minima.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <surefoot/random.hpp>

#include "field_state.hpp"
#include "follow_line.hpp"
#include "follow_sight.hpp"

namespace surefoot::navigation {
namespace {

constexpr int directions = 16;
/// Of a way along a wall, before it is held to be endless [steps].
constexpr int longest_along_wall = 8000;
constexpr int shortest_random = 16;  ///< the first random walk; each is twice as long as the one before [steps]
constexpr int longest_random = 2048;
constexpr std::size_t most_points = 200'000;  ///< of a line

class Climb {
public:
    Climb(const FieldState& field, const NavigationQuery& query, const NavigationPoint& from,
          const NavigationDescendOptions& options)
        : field_(field), query_(query), options_(options), here_(from), random_(options.seed) {
        for (int i = 0; i < directions; ++i) {
            const double angle = 2 * std::numbers::pi * i / directions;
            ways_[static_cast<std::size_t>(i)] = field.frame.turned_out({std::cos(angle), 0, std::sin(angle)});
        }
        append(result_.line, here_.position);
    }

    NavigationDescent run() {
        for (std::uint32_t escapes = 0;; ++escapes) {
            if (!sink()) break;  // no line is that long
            result_.arrived = value(here_) <= options_.step;
            if (result_.arrived) {
                append(result_.line, field_.goal.position);
                break;
            }
            result_.minima.push_back({.place = here_, .value = value(here_)});
            if (escapes >= options_.most_escapes || !escape()) break;
        }
        return std::move(result_);
    }

private:
    [[nodiscard]] double value(const NavigationPoint& place) const {
        return length(place.position - field_.goal.position);
    }
    void move_to(const NavigationPoint& place) {
        here_ = place;
        append(result_.line, here_.position);
    }
    /// A whole step straight on, if the mesh has room for it.
    [[nodiscard]] std::optional<NavigationPoint> free_step(int direction) const {
        const auto way = static_cast<std::size_t>(((direction % directions) + directions) % directions);
        const auto next = moved_along(query_.state(), here_, here_.position + ways_[way] * options_.step);
        if (!next || length(level(next->position - here_.position, field_.frame.y)) < 0.9 * options_.step)
            return std::nullopt;
        return next;
    }

    /// As far down as it goes: always to the lowest of the places around. False if the line got too long.
    bool sink() {
        while (result_.line.points.size() < most_points) {
            std::optional<NavigationPoint> lowest;
            const auto offer = [&](const std::optional<NavigationPoint>& next) {
                if (next && value(*next) < value(lowest.value_or(here_)) - 1e-3 * options_.step) lowest = next;
            };
            const dvec3 way = level(field_.goal.position - here_.position, field_.frame.y);
            const double distance = length(way);
            if (distance > 0)
                offer(moved_along(query_.state(), here_,
                                  here_.position + way * (std::min(options_.step, distance) / distance)));
            for (const dvec3& direction : ways_)
                offer(moved_along(query_.state(), here_, here_.position + direction * options_.step));
            if (!lowest) return true;
            move_to(*lowest);
        }
        return false;
    }

    bool escape() {
        switch (options_.escape) {
            case NavigationEscape::none:
                return false;
            case NavigationEscape::random:
                return walk_at_random();
            case NavigationEscape::wall:
                return follow_wall();
            case NavigationEscape::virtual_goal:
                return go_to_virtual_goal();
        }
        return false;
    }

    bool walk_at_random() {
        int heading = static_cast<int>(next_random(random_) % directions);
        for (int i = 0; i < random_steps_; ++i) {
            auto next = free_step(heading);
            if (!next || next_random(random_) % 16 == 0) {
                heading = static_cast<int>(next_random(random_) % directions);
                if (!next) continue;
            }
            move_to(*next);
        }
        random_steps_ = std::min(2 * random_steps_, longest_random);
        return true;
    }

    /// With the wall to the right until the potential is lower than in the minimum. The rule is that of the bug
    /// algorithms (Lumelsky and Stepanov, 1987): each minimum is left nearer to the goal than it was met, so none is
    /// met twice.
    bool follow_wall() {
        const double lowest = value(here_);
        int heading = towards_goal() - directions / 4;
        for (int i = 0; i < longest_along_wall; ++i) {
            // From the side of the wall away from it, the first free way.
            std::optional<NavigationPoint> next;
            int turned = heading + directions / 4;
            for (int k = 0; k < directions && !next; ++k, --turned) {
                next = free_step(turned);
                heading = turned;
            }
            if (!next) return false;
            move_to(*next);
            if (value(here_) < lowest - options_.step / 2) return true;
        }
        return false;
    }
    [[nodiscard]] int towards_goal() const {
        const dvec3 way = field_.goal.position - here_.position;
        int best = 0;
        for (int i = 1; i < directions; ++i)
            if (dot(ways_[static_cast<std::size_t>(i)], way) > dot(ways_[static_cast<std::size_t>(best)], way))
                best = i;
        return best;
    }

    bool go_to_virtual_goal() {
        const double lowest = value(here_);
        const dtNavMesh& detour = *query_.state().ground().detour;
        for (const dtPolyRef polygon : reachable(detour, here_.polygon.id, query_.state().shut)) {
            if (detour.getOffMeshConnectionByRef(polygon) != nullptr) continue;
            const NavigationMinimum there = lowest_of(field_, query_.state(), polygon);
            if (!(there.value < lowest - options_.step / 2)) continue;
            const std::optional<NavigationPath> path = query_.path(here_, there.place);
            if (!path || path->partial) continue;
            const NavigationLine way = pulled_line(*path);
            for (std::size_t i = 0; i < way.points.size(); ++i) {
                if (i == 0)
                    result_.line.points.back().link = way.points[0].link;
                else
                    append(result_.line, way.points[i].position, way.points[i].link);
            }
            here_ = there.place;
            return true;
        }
        return false;
    }

    const FieldState& field_;
    const NavigationQuery& query_;
    const NavigationDescendOptions& options_;
    std::array<dvec3, directions> ways_{};
    NavigationPoint here_;
    std::uint64_t random_;
    int random_steps_ = shortest_random;
    NavigationDescent result_;
};

}  // namespace

NavigationDescent climb_down(const FieldState& field, const NavigationQuery& query, const NavigationPoint& from,
                             const NavigationDescendOptions& options) {
    if (!query.state().knows(from.polygon) || !(options.step > 0)) return {};
    return Climb(field, query, from, options).run();
}

}  // namespace surefoot::navigation
