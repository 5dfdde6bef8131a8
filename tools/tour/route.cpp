#include "tour/route.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <glm/geometric.hpp>

#include "tour/rows.hpp"

namespace surefoot::tools {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double walkable = 0.7;  // the cosine of 45.6 degrees
const dvec3 up(0, 1, 0);

/// Bodily facts about the walker, all from its size, so that a route suits a mouse as well as a giant.
struct Gait {
    double skin;    ///< kept from everything met
    double stride;  ///< the shortest step ahead
    double climb;   ///< how high an obstacle is stepped over
    double drop;    ///< how far down a floor is looked for
};

Gait gait_of(const Walker& walker) {
    const double height = 2 * walker.half_size.y;
    return {.skin = 1e-3 * height, .stride = 1.1 * height, .climb = 0.4 * height, .drop = 3 * height};
}

dvec3 heading(double angle) {
    return {std::cos(angle), 0, std::sin(angle)};
}

/// How curious a contact is: rare features more than common ones, walls more than floors.
double curiosity(const Hit& hit) {
    const double wall = std::abs(hit.normal.y) < 0.5 ? 1.0 : 0.3;
    return wall * (hit.feature == Feature::vertex ? 4.0 : hit.feature == Feature::edge ? 2.5 : 1.0);
}

/// The state of a walk under way.
class Walk {
public:
    Walk(const Mesh& mesh, const Walker& walker, const dvec3& start)
        : mesh_(mesh), walker_(walker), gait_(gait_of(walker)), position_(start) {}

    [[nodiscard]] Route run(std::span<const dvec3> waypoints) {
        settle();
        std::size_t next = 0;
        constexpr int patience = 4;  // turns in which nothing is gained
        int stuck = 0;
        int no_nearer = 0;
        double nearest = 1e300;
        for (std::size_t turn = 0; route_.legs.size() < walker_.legs && stuck < patience; ++turn) {
            // On to the next waypoint when this one is reached, or when it cannot be.
            while (next < waypoints.size() &&
                   (flat_distance(position_, waypoints[next]) < gait_.stride || no_nearer == patience)) {
                ++next;
                no_nearer = 0;
                nearest = 1e300;
            }
            if (next < waypoints.size()) {
                const double distance = flat_distance(position_, waypoints[next]);
                no_nearer = distance < nearest - 0.2 * gait_.stride ? 0 : no_nearer + 1;
                nearest = std::min(nearest, distance);
            }
            if (!waypoints.empty() && next == waypoints.size()) break;
            const dvec3 before = position_;
            const double length = gait_.stride * static_cast<double>(1 + turn * 7 % 3);
            if (next < waypoints.size() && stuck == 0) {
                const dvec3 way = waypoints[next] - position_;
                const dvec3 direction = glm::normalize(dvec3(way.x, 0, way.z));
                stride(direction, std::min(2 * length, flat_distance(position_, waypoints[next])));
            } else {
                // Now out into the open, now straight at something, for a walk that is worth looking at.
                const bool touch = waypoints.empty() && turn % 3 != 2;
                stride(best_heading(touch), touch ? reach() : length);
            }
            stuck = flat_distance(before, position_) < 0.2 * gait_.stride ? stuck + 1 : 0;
        }
        return std::move(route_);
    }

private:
    static double flat_distance(const dvec3& a, const dvec3& b) { return std::hypot(a.x - b.x, a.z - b.z); }

    std::optional<Hit> sweep(const Motion& motion) const {
        return mesh_.sweep(walker_.volume, motion, {.one_sided = walker_.one_sided});
    }

    /// One leg: moves as far as it is free, and stays a skin away from what was met.
    std::optional<Hit> go(const dvec3& to, Step step) {
        const Motion motion{position_, to};
        const std::optional<Hit> hit = sweep(motion);
        route_.legs.push_back({.motion = motion, .hit = hit, .step = step});
        if (!hit) {
            position_ = to;
            return hit;
        }
        const double length = glm::length(to - position_);
        const double back = length > 0 ? gait_.skin / length : 0;
        position_ += std::max(0.0, hit->t - back) * (to - position_);
        return hit;
    }

    /// Down to the floor. False if there is none: then the walker is put back where it came from.
    bool settle() {
        const dvec3 before = position_;
        const std::optional<Hit> floor = go(position_ - up * gait_.drop, Step::drop);
        if (floor) return true;
        position_ = before;
        return false;
    }

    void stride(const dvec3& direction, double length) {
        const dvec3 start = position_;
        visited_.push_back(start);
        const std::optional<Hit> met = go(position_ + direction * length, Step::walk);
        if (met && met->point.y < position_.y - 0.2 * walker_.half_size.y && glm::dot(met->normal, direction) < 0) {
            const double left = (1 - met->t) * length;
            go(position_ + up * gait_.climb, Step::climb);
            go(position_ + direction * std::min(left, gait_.stride), Step::walk);
        }
        if (!settle()) {
            // Nothing to stand on out there: a real player would fall; this one goes back and looks elsewhere.
            position_ = start;
            avoid_ = std::atan2(direction.z, direction.x);
        }
    }

    [[nodiscard]] double reach() const { return 4 * gait_.stride; }

    /// The way that leads farthest without meeting anything, or else (`touch`) to the most curious contact; and away
    /// from where the walk has been.
    dvec3 best_heading(bool touch) {
        constexpr int ways = 16;
        double best = -1e300;
        double chosen = 0;
        for (int i = 0; i < ways; ++i) {
            const double angle = 2 * pi * (i + 0.37) / ways;
            const dvec3 to = position_ + heading(angle) * reach();
            ++route_.probes;
            const std::optional<Hit> hit = sweep({position_ + up * gait_.skin, to});
            const double t = hit ? hit->t : 1.0;
            const dvec3 end = position_ + heading(angle) * (std::min(t, touch ? 1.0 : 0.5) * reach());
            double worth = touch ? (hit ? curiosity(*hit) * std::min(1.0, 4 * t) * gait_.stride : 0.0) : t * reach();
            for (const dvec3& seen : visited_)
                worth -= gait_.stride * std::exp(-glm::dot(end - seen, end - seen) / (4 * gait_.stride * gait_.stride));
            if (!stands_at(end)) worth -= 2 * reach();
            if (avoid_ && std::cos(angle - *avoid_) > 0.9) worth -= 2 * reach();
            if (worth > best) {
                best = worth;
                chosen = angle;
            }
        }
        avoid_.reset();
        return heading(chosen);
    }

    bool stands_at(const dvec3& place) {
        ++route_.probes;
        const std::optional<Hit> floor = mesh_.ray({place, place - up * gait_.drop}, {.one_sided = walker_.one_sided});
        return floor && floor->normal.y > walkable;
    }

    const Mesh& mesh_;
    const Walker& walker_;
    Gait gait_;
    dvec3 position_;
    std::optional<double> avoid_;
    std::vector<dvec3> visited_;
    Route route_;
};

/// How much there is to see: every kind of contact counts, the rarer the more, and so does ground covered. Low down is
/// better than on a roof, where few games are played.
double worth(const Mesh& mesh, const Route& route, const Walker& walker) {
    dvec3 low(1e300);
    dvec3 high(-1e300);
    double travelled = 0;
    double altitude = 0;
    double curious[3] = {0, 0, 0};
    for (const Leg& leg : route.legs) {
        const dvec3 end = leg.motion.from + (leg.hit ? leg.hit->t : 1.0) * (leg.motion.to - leg.motion.from);
        low = glm::min(low, end);
        high = glm::max(high, end);
        altitude += end.y / static_cast<double>(route.legs.size());
        if (leg.step == Step::walk) travelled += glm::length(end - leg.motion.from);
        if (leg.hit && leg.step == Step::walk) curious[static_cast<int>(leg.hit->feature)] += curiosity(*leg.hit);
    }
    double value = 0;
    for (const double kind : curious) value += 2 * std::sqrt(kind);
    const double height = 2 * walker.half_size.y;
    const Bounds bounds = mesh.bounds();
    const dvec3 size = high - low;
    return value + std::sqrt(travelled / height) + std::min(3.0, std::min(size.x, size.z) / height / 2) +
           std::min(2.0, size.y / height) -
           4 * (altitude - bounds.min.y) / std::max(height, bounds.max.y - bounds.min.y);
}

}  // namespace

std::size_t Route::contacts(Feature feature) const {
    return static_cast<std::size_t>(std::count_if(
        legs.begin(), legs.end(), [&](const Leg& leg) { return leg.hit && leg.hit->feature == feature; }));
}

std::vector<dvec3> standing_places(const Mesh& mesh, const Walker& walker) {
    constexpr int cells = 40;
    constexpr int floors = 8;
    const Bounds bounds = mesh.bounds();
    const dvec3 size = bounds.max - bounds.min;
    const Gait gait = gait_of(walker);
    const QueryOptions options{.one_sided = walker.one_sided};
    std::vector<dvec3> places;
    for (int i = 0; i < cells; ++i)
        for (int k = 0; k < cells; ++k) {
            dvec3 from(bounds.min.x + size.x * (i + 0.5) / cells, bounds.max.y + 1,
                       bounds.min.z + size.z * (k + 0.5) / cells);
            const double bottom = bounds.min.y - 1;
            for (int floor = 0; floor < floors && from.y > bottom; ++floor) {
                const std::optional<Hit> hit = mesh.ray({from, {from.x, bottom, from.z}}, options);
                if (!hit) break;
                from.y = hit->point.y - gait.skin;
                if (hit->normal.y < walkable) continue;
                // A slope touches the side of the walker before its foot: stand a little higher there.
                const dvec3 place = hit->point + up * (walker.half_size.y / hit->normal.y + 2 * gait.skin);
                if (mesh.overlap(walker.volume, place, {}, options) == 0) places.push_back(place);
            }
        }
    return places;
}

Route walk_from(const Mesh& mesh, const Walker& walker, const dvec3& start, std::span<const dvec3> waypoints) {
    return Walk(mesh, walker, start).run(waypoints);
}

Route best_route(const Mesh& mesh, const Walker& walker, std::span<const dvec3> places,
                 std::span<const dvec3> waypoints) {
    constexpr std::size_t most_tries = 64;
    const std::size_t apart = places.size() / most_tries + 1;
    std::vector<Route> routes((places.size() + apart - 1) / apart);
    for_each_row(
        static_cast<int>(routes.size()),
        [&](int i) {
            const auto row = static_cast<std::size_t>(i);
            routes[row] = walk_from(mesh, walker, places[row * apart], waypoints);
        },
        [](int) {});
    Route best;
    double most = -1e300;
    for (Route& route : routes) {
        const double value = worth(mesh, route, walker);
        if (value <= most) continue;
        most = value;
        best = std::move(route);
    }
    return best;
}

void measure(const Mesh& mesh, const Walker& walker, Route& route) {
    using Clock = std::chrono::steady_clock;
    for (Leg& leg : route.legs) {
        std::array<double, 41> times{};
        for (double& time : times) {
            const Clock::time_point start = Clock::now();
            const std::optional<Hit> again = mesh.sweep(walker.volume, leg.motion, {.one_sided = walker.one_sided});
            time = std::chrono::duration<double>(Clock::now() - start).count();
            if (again.has_value() != leg.hit.has_value()) leg.hit = again;
        }
        std::nth_element(times.begin(), times.begin() + times.size() / 2, times.end());
        leg.seconds = times[times.size() / 2];
    }
}

std::string_view word(Step step) {
    switch (step) {
        case Step::walk:
            return "walk";
        case Step::drop:
            return "drop";
        case Step::climb:
            break;
    }
    return "climb";
}

}  // namespace surefoot::tools
