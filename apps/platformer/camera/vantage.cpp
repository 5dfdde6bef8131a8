#include "platformer/camera/vantage.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "platformer/camera/sight.hpp"
#include "platformer/hero/frame.hpp"

namespace surefoot::platformer {
namespace {

constexpr double ample = 4.0;        // farther away is no better [m]
constexpr double per_veiled = 0.12;  // what it costs to look through something, for each point of the hero
constexpr double per_yaw = 0.26;     // what turning costs [1/rad]
constexpr double per_rise = 0.22;    // what standing higher costs [1/rad]
constexpr double per_fall = 0.40;    // and lower
constexpr double loyalty = 0.15;     // what the direction that was chosen before is worth more
constexpr double by_hand = 4;        // how much more it costs to turn against the player's hand

// What is tried: to both sides, and at these heights beside the present one.
constexpr double across[] = {0, 0.35, 0.75, 1.2, 1.7, 2.3, 3.1};
constexpr double heights[] = {-0.9, -0.3, 0.05, 0.35, 0.7, 1.1};

}  // namespace

dvec3 outward(const Vantage& vantage) {
    return dvec3(0, std::sin(vantage.pitch), 0) - forward_of(vantage.yaw) * std::cos(vantage.pitch);
}

double reach(const Surroundings& around, const Vantage& vantage) {
    const dvec3 eye = around.look_at + outward(vantage) * around.distance;
    const dvec3 way = eye - around.head;
    const double length = glm::length(way);
    const double here = length * sight_share(around.world, around.head, eye, around.slight, around.query);
    const double then = length * sight_share(around.world, around.soon, around.soon + way, around.slight, around.query);
    return std::min(here, then);
}

int veiled_points(const Surroundings& around, const dvec3& eye) {
    constexpr WorldQuery drawn{.begin = 1, .end = 1};
    int veiled = 0;
    for (const dvec3& point : body_points(around.middle, around.half_height, eye))
        if (around.world.ray_any({eye, point}, drawn) ||
            (around.decor != nullptr && around.decor->ray_any({eye, point}, drawn)))
            ++veiled;
    return veiled;
}

double worth_of(double reach, double distance) {
    const double lacks = 1 - std::min(reach / std::min(distance, ample), 1.0);
    return 1 - 2 * lacks * lacks;
}

Vantage best_vantage(const Surroundings& around, const Vantage& now, bool still, const std::optional<Vantage>& chosen) {
    // Whether it is above `least` is all that is asked, so that most need not be looked at closely.
    const auto worth = [&](const Vantage& vantage, double least) {
        const double far = reach(around, vantage);
        double value = worth_of(far, around.distance);
        const double turned = std::abs(turn_between(now.yaw, vantage.yaw));
        const double risen = vantage.pitch - now.pitch;
        value -= per_yaw * turned * (still ? by_hand : 1) + std::max(per_rise * risen, -per_fall * risen);
        if (chosen && std::abs(turn_between(chosen->yaw, vantage.yaw)) < 0.25 &&
            std::abs(chosen->pitch - vantage.pitch) < 0.25)
            value += loyalty;
        if (value <= least) return value;
        const dvec3 way = around.look_at + outward(vantage) * around.distance - around.head;
        return value - per_veiled * veiled_points(around, around.head + way * (far / glm::length(way)));
    };
    Vantage best = now;
    double most = worth(now, -1e9);
    const auto consider = [&](const Vantage& vantage) {
        const double value = worth(vantage, most);
        if (value <= most) return;
        best = vantage;
        most = value;
    };
    if (chosen) consider(*chosen);
    for (const double turn : across) {
        for (const double side : {1.0, -1.0}) {
            if (turn == 0 && side < 0) continue;
            const double yaw = now.yaw + side * turn;
            if (turn != 0) consider({yaw, now.pitch});
            for (const double height : heights) consider({yaw, height});
        }
    }
    return best;
}

}  // namespace surefoot::platformer
