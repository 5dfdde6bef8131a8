#include "tour/ground.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace surefoot::tools {
namespace {

constexpr double pi = 3.14159265358979323846;

/// A number in [0, 1) that looks random, the same for the same seed.
double dice(std::uint32_t seed) {
    seed ^= seed >> 16U;
    seed *= 0x7feb352dU;
    seed ^= seed >> 15U;
    seed *= 0x846ca68bU;
    seed ^= seed >> 16U;
    return seed * 0x1p-32;
}

/// Two unit vectors square to `n` and to each other.
void frame(const dvec3& n, dvec3& u, dvec3& v) {
    u = glm::normalize(glm::cross(n, std::abs(n.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0)));
    v = glm::cross(n, u);
}

bool in_shadow(const Sunshine& sunshine, const dvec3& place, const dvec3& to_sun) {
    const double length = std::min(sunshine.far, std::max(0.0, sunshine.ceiling - place.y) / to_sun.y);
    if (length <= 0) return false;
    const dvec3 high = place + to_sun * length;
    // From the sun down: then a roof, seen from above by its back, lets the light in just as it lets the eye in.
    if (sunshine.one_sided) return sunshine.mesh.ray({high, place}, {.one_sided = true}).has_value();
    return sunshine.mesh.ray({place, high}).has_value();
}

double body_shadow(const Sunshine& sunshine, const dvec3& place, const dvec3& to_sun) {
    double light = 1;
    for (const SweptEllipsoid& body : sunshine.casters) {
        const dvec3 away = body.from - place;
        const double along = glm::dot(away, to_sun);
        const double reach = body.reach();
        if (along < -reach || glm::dot(away, away) - along * along > reach * reach) continue;
        if (body.sight(place, to_sun)) light *= 0.45;
    }
    return light;
}

}  // namespace

Seen look(const Mesh& mesh, const Camera& camera, double x, double y, double far, bool one_sided) {
    const dvec3 direction = camera.direction(x, y);
    const double begin = camera.sight_begins(direction);
    const std::optional<Hit> hit =
        mesh.ray({camera.eye + direction * begin, camera.eye + direction * far}, {.one_sided = one_sided});
    if (!hit || hit->status != HitStatus::ok) return {};
    return {.met = true,
            .distance = begin + hit->t * (far - begin),
            .point = hit->point,
            .normal = hit->normal,
            .triangle = hit->triangle,
            .surface = hit->surface};
}

Light light_at(const Sunshine& sunshine, const Seen& seen, std::uint32_t seed) {
    constexpr int suns = 2;
    constexpr int skies = 5;
    const dvec3 place = seen.point + seen.normal * (1e-3 * sunshine.reach);
    Light light{.sun = 0, .sky = 0};
    dvec3 u;
    dvec3 v;
    frame(sunshine.to_sun, u, v);
    if (glm::dot(seen.normal, sunshine.to_sun) > 0)
        for (std::uint32_t i = 0; i < suns; ++i) {
            // A sun a few degrees wide: soft borders of shadows.
            const double r = 0.035 * std::sqrt((i + dice(seed * 4 + i)) / suns);
            const double angle = 2 * pi * dice(seed * 4 + i + 77777);
            const dvec3 to_sun = glm::normalize(sunshine.to_sun + r * (std::cos(angle) * u + std::sin(angle) * v));
            if (!in_shadow(sunshine, place, to_sun)) light.sun += body_shadow(sunshine, place, to_sun) / suns;
        }
    frame(seen.normal, u, v);
    const double turn = dice(seed + 0x9e3779b9U);
    for (std::uint32_t i = 0; i < skies; ++i) {
        const double r = std::sqrt((i + dice(seed * 8 + i + 31337)) / skies);
        const double angle = 2 * pi * (turn + i * 0.6180339887498949);
        const dvec3 way = r * (std::cos(angle) * u + std::sin(angle) * v) + std::sqrt(1 - r * r) * seen.normal;
        const std::optional<Hit> hit = sunshine.mesh.ray({place, place + way * sunshine.reach});
        light.sky += (hit ? hit->t : 1.0) / skies;
    }
    return light;
}

Light smoothed(const std::vector<Light>& light, const std::vector<Seen>& seen, const Camera& camera, int x, int y,
               int step) {
    constexpr double kernel[5] = {1.0, 4.0, 6.0, 4.0, 1.0};
    const auto at = [&](int px, int py) {
        return static_cast<std::size_t>(py) * static_cast<std::size_t>(camera.width) + static_cast<std::size_t>(px);
    };
    const Seen& middle = seen[at(x, y)];
    if (!middle.met) return {};
    const double thick = 4 * step * camera.footprint(middle.distance);
    double weights = 0;
    Light sum{0, 0};
    for (int j = -2; j <= 2; ++j)
        for (int i = -2; i <= 2; ++i) {
            const int px = x + i * step;
            const int py = y + j * step;
            if (px < 0 || py < 0 || px >= camera.width || py >= camera.height) continue;
            const Seen& other = seen[at(px, py)];
            if (!other.met || glm::dot(other.normal, middle.normal) < 0.95) continue;
            if (std::abs(glm::dot(other.point - middle.point, middle.normal)) > thick) continue;
            const double weight = kernel[i + 2] * kernel[j + 2];
            weights += weight;
            sum.sun += weight * light[at(px, py)].sun;
            sum.sky += weight * light[at(px, py)].sky;
        }
    return {sum.sun / weights, sum.sky / weights};
}

}  // namespace surefoot::tools
