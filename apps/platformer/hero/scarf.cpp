#include "platformer/hero/scarf.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace surefoot::platformer {
namespace {

constexpr double link = 0.105;  // between two points [m]
constexpr double weight = 9;    // it is light [m/s^2]

}  // namespace

Scarf hanging_scarf(const dvec3& knot, const dvec3& backward) {
    Scarf scarf;
    for (std::size_t i = 0; i < scarf_points; ++i) {
        const double along = link * double(i);
        scarf.now[i] = knot + backward * (along * 0.5) - dvec3(0, along * 0.86, 0);
        scarf.before[i] = scarf.now[i];
    }
    return scarf;
}

Scarf advance(const Scarf& scarf, const dvec3& knot, const dvec3& middle, double radius, double floor, double drag,
              double clock, double dt) {
    Scarf next = scarf;
    next.before = scarf.now;
    next.now[0] = knot;
    const double kept = std::exp(-drag * dt);
    for (std::size_t i = 1; i < scarf_points; ++i) {
        const dvec3 moved = (scarf.now[i] - scarf.before[i]) * kept;
        // The faster it is pulled, the more it flutters.
        const double flutter = std::min(glm::length(moved) / dt, 8.0) * 2.2;
        const double phase = clock * 17 - double(i) * 1.3;
        const dvec3 air(flutter * std::sin(phase * 0.7), 0.6 * flutter * std::sin(phase),
                        flutter * std::cos(phase * 0.6));
        next.now[i] = scarf.now[i] + moved + (air - dvec3(0, weight, 0)) * (dt * dt);
    }
    for (int round = 0; round < 4; ++round) {
        for (std::size_t i = 1; i < scarf_points; ++i) {
            dvec3& point = next.now[i];
            const dvec3 out = point - middle;
            const double away = glm::length(out);
            if (away < radius && away > 1e-9) point = middle + out * (radius / away);
            if (point.y < floor) point.y = floor;
            const dvec3 along = point - next.now[i - 1];
            const double length = glm::length(along);
            if (length < 1e-9) continue;
            // From the knot outwards: what is nearer to it does not give way.
            point = next.now[i - 1] + along * (link / length);
        }
    }
    return next;
}

}  // namespace surefoot::platformer
