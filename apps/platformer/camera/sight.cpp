#include "platformer/camera/sight.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace surefoot::platformer {
namespace {

constexpr double thin = 0.06;  // of the ball that is swept along a look [m]
constexpr int most_faces = 12;
constexpr double air = 0.01;     // that is kept around a ball [m]
constexpr double stride = 0.10;  // between two places that are tried for the eye [m]

// Looks to the sides, to the left and the right [rad], and up and down.
constexpr double across[] = {0.04, 0.09, 0.15, 0.22, 0.30, 0.39, 0.49, 0.60};
constexpr double upward[] = {0.06, 0.14, 0.25};

/// A look takes no time: the world is as it stands when the tick ends.
WorldQuery now(WorldQuery query) {
    query.begin = query.end = 1;
    return query;
}

dvec3 bent(const dvec3& direction, const dvec3& towards, double angle) {
    return direction * std::cos(angle) + towards * std::sin(angle);
}

bool has_room(const World& world, const dvec3& place, const WorldQuery& query) {
    return world.overlap(Sphere{eye_radius + air}, place, {}, query) == 0;
}

}  // namespace

double seen_share(const World& world, const dvec3& from, const dvec3& to, const WorldQuery& query) {
    const double length = glm::length(to - from);
    if (!(length > 0)) return 0;
    const auto hit = world.sweep(Sphere{thin}, {from, to}, now(query));
    return hit ? std::max(hit->t - air / length, 0.0) : 1;
}

double sight_share(const World& world, const dvec3& from, const dvec3& to, double slight, const WorldQuery& query) {
    if (!(slight > 0)) return seen_share(world, from, to, query);
    const double length = glm::length(to - from);
    if (!(length > 0)) return 0;
    const WorldQuery at_end = now(query);
    if (!world.sweep_any(Sphere{thin}, {from, to}, at_end)) return 1;
    // In at one face and out at the next: what lies between them is how much there is to look through.
    const double past = 0.002 / length;
    double in = -1;
    double begin = 0;
    for (int face = 0; face < most_faces && begin < 1; ++face) {
        const auto hit = world.ray({from + (to - from) * begin, to}, at_end);
        if (!hit) break;
        if (hit->status != HitStatus::ok) return 0;
        const double at = begin + hit->t * (1 - begin);
        if (in < 0) {
            in = at;
        } else {
            if ((at - in) * length > slight) break;
            in = -1;
        }
        begin = at + past;
    }
    return in < 0 ? 1 : std::max(in - (thin + air) / length, 0.0);
}

std::array<dvec3, 5> body_points(const dvec3& middle, double half_height, const dvec3& eye) {
    const dvec3 look = middle - eye;
    const double flat = std::sqrt(look.x * look.x + look.z * look.z);
    const dvec3 side = (flat > 1e-6 ? dvec3(look.z, 0, -look.x) / flat : dvec3(1, 0, 0)) * 0.25;
    const dvec3 up(0, half_height, 0);
    return {middle + up * 0.8, middle + up * 0.1, middle - up * 0.7, middle + up * 0.2 + side,
            middle + up * 0.2 - side};
}

double ball_share(const World& world, const dvec3& from, const dvec3& to, const WorldQuery& query) {
    const double length = glm::length(to - from);
    if (!(length > 0)) return 0;
    const auto hit = world.sweep(Sphere{eye_radius + air}, {from, to}, now(query));
    return hit ? std::max(hit->t - air / length, 0.0) : 1;
}

dvec3 pushed_out(const World& world, const dvec3& place, const WorldQuery& query) {
    const WorldQuery at_end = now(query);
    dvec3 at = place;
    for (int push = 0; push < 8; ++push) {
        std::array<Overlap, 8> met;
        const std::size_t count = std::min(world.overlap(Sphere{eye_radius + air}, at, met, at_end), met.size());
        const auto deepest = std::max_element(met.begin(), met.begin() + std::ptrdiff_t(count),
                                              [](const Overlap& a, const Overlap& b) { return a.depth < b.depth; });
        if (count == 0) return at;
        at += deepest->normal * (deepest->depth + 0.002);
    }
    return at;
}

dvec3 moved_ball(const World& world, const dvec3& from, const dvec3& to, const WorldQuery& query) {
    const WorldQuery at_end = now(query);
    dvec3 at = from;
    dvec3 goal = to;
    for (int bend = 0; bend < 3; ++bend) {
        const dvec3 way = goal - at;
        const double length = glm::length(way);
        if (!(length > 1e-9)) return at;
        const auto hit = world.sweep(Sphere{eye_radius + air}, {at, goal}, at_end);
        if (!hit) return goal;
        at += way * std::max(hit->t - 0.01 / length, 0.0);
        if (hit->status != HitStatus::ok) return at;
        const dvec3 rest = goal - at;
        const double into = glm::dot(rest, hit->normal);
        goal = at + rest - hit->normal * std::min(into, 0.0);
    }
    return at;
}

double roomy_share(const World& world, const dvec3& from, const dvec3& to, double most, const WorldQuery& query) {
    const WorldQuery at_end = now(query);
    const double length = glm::length(to - from);
    if (!(length > 0)) return 0;
    const auto at = [&](double share) { return from + (to - from) * share; };
    if (has_room(world, at(most), at_end)) return most;
    for (double share = most; share > 0;) {
        const double nearer = std::max(share - stride / length, 0.0);
        if (has_room(world, at(nearer), at_end)) {
            // Back outwards, to where the ball is stopped.
            const auto hit = world.sweep(Sphere{eye_radius + air}, {at(nearer), at(share)}, at_end);
            const double back = hit ? std::max(hit->t - 0.02, 0.0) : 1;
            const double found = nearer + (share - nearer) * back;
            return has_room(world, at(found), at_end) ? found : nearer;
        }
        share = nearer;
    }
    return 0;
}

Sight look_back(const World& world, const dvec3& anchor, const dvec3& direction, double length, double slight,
                const WorldQuery& query) {
    Sight sight;
    sight.free = length * sight_share(world, anchor, anchor + direction * length, slight, query);
    sight.allowed = sight.free;
    dvec3 side = glm::cross(dvec3(0, 1, 0), direction);
    if (glm::length(side) < 1e-6) side = {1, 0, 0};
    side = glm::normalize(side);
    const dvec3 above = glm::cross(direction, side);
    const auto look = [&](const dvec3& towards, double angle) {
        const double least = length_per_angle * angle;
        const double reach = length - least;  // farther away it allows all
        if (reach <= 0) return length;
        const dvec3 end = anchor + bent(direction, towards, angle) * reach;
        const double allowed = std::min(reach * sight_share(world, anchor, end, slight, query) + least, length);
        sight.allowed = std::min(sight.allowed, allowed);
        return allowed;
    };
    double room[2] = {length, length};
    for (const double angle : across) {
        room[0] = std::min(room[0], look(side, angle));
        room[1] = std::min(room[1], look(-side, angle));
    }
    for (const double angle : upward) {
        look(above, angle);
        look(-above, angle);
    }
    // `side` is to the right of one who looks along the way back, and to the left of the camera's own look.
    sight.to_left = (room[0] - room[1]) / length;
    return sight;
}

}  // namespace surefoot::platformer
