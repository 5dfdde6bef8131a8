#include "tour/paint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace surefoot::tools {
namespace {

const Colour sunlight(1.85, 1.66, 1.38);
const Colour skylight(0.62, 0.72, 0.88);
const Colour earthlight(0.34, 0.30, 0.26);

double smooth_step(double from, double to, double x) {
    const double f = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return f * f * (3 - 2 * f);
}

/// Plaster for what nothing is said about, quiet earth colours for named surfaces.
Colour albedo(std::uint32_t surface, const dvec3& normal) {
    static constexpr std::array<std::array<double, 3>, 7> tints{{{0.60, 0.55, 0.47},
                                                                 {0.47, 0.55, 0.46},
                                                                 {0.58, 0.46, 0.40},
                                                                 {0.44, 0.51, 0.58},
                                                                 {0.62, 0.57, 0.40},
                                                                 {0.52, 0.46, 0.54},
                                                                 {0.50, 0.56, 0.55}}};
    const Colour plaster(0.60, 0.585, 0.56);
    Colour colour = plaster;
    if (surface > 0) {
        const auto& tint = tints[(surface - 1) % tints.size()];
        colour = glm::mix(plaster, Colour(tint[0], tint[1], tint[2]), 0.7);
    }
    // Walls a little cooler and darker than floors: a plan reads at a glance.
    return glm::mix(colour * Colour(0.80, 0.83, 0.88), colour * Colour(1.04, 1.02, 0.98),
                    smooth_step(0.3, 0.95, normal.y));
}

/// 0 on the border of the triangle to 1 away from it, one pixel wide; 1 all over where triangles are too small to be
/// drawn apart.
double border(const Triangle& t, const Camera& camera, const Seen& seen, const dvec3& direction) {
    const dvec3 corners[3] = {t.a, t.b, t.c};
    const double pixel = camera.footprint(seen.distance);
    const double twice_area = glm::length(glm::cross(t.b - t.a, t.c - t.a));
    double nearest = 1e300;
    double longest = 0;
    for (int i = 0; i < 3; ++i) {
        const dvec3 edge = corners[(i + 1) % 3] - corners[i];
        const double length = glm::length(edge);
        if (length == 0) return 1;
        longest = std::max(longest, length);
        // A line is one pixel wide on the picture, so wider on a floor that is seen at a flat angle.
        const dvec3 across = glm::normalize(glm::cross(edge, seen.normal));
        const double flat = std::sqrt(std::max(0.02, 1 - std::pow(glm::dot(across, direction), 2)));
        nearest = std::min(nearest, std::abs(glm::dot(seen.point - corners[i], across)) * flat / pixel);
    }
    const double thinnest = longest > 0 ? twice_area / longest / pixel : 0;
    const double strength = smooth_step(3, 14, thinnest);
    return 1 - strength * std::clamp(1.1 - nearest, 0.0, 1.0);
}

}  // namespace

Colour to_eye(const Colour& linear) {
    Colour out;
    for (int i = 0; i < 3; ++i) {
        // A soft shoulder, so that what the sun shines on keeps its colour; then the curve of sRGB.
        const double x = std::max(0.0, linear[i]);
        const double y = x * (1 + x / 6.25) / (1 + x);
        const double z = std::clamp(y * 1.55, 0.0, 1.0);
        out[i] = z <= 0.0031308 ? 12.92 * z : 1.055 * std::pow(z, 1 / 2.4) - 0.055;
    }
    return out;
}

Colour sky(double height) {
    return glm::mix(Colour(0.80, 0.80, 0.78), Colour(0.50, 0.64, 0.82), smooth_step(-0.1, 1.1, height));
}

Colour ground(const Mesh& mesh, const Camera& camera, const Seen& seen, const Light& light, const dvec3& to_sun) {
    const dvec3 direction = glm::normalize(seen.point - camera.eye);
    const double facing = std::max(0.0, glm::dot(seen.normal, to_sun));
    const Colour ambient = glm::mix(earthlight, skylight, 0.5 + 0.5 * seen.normal.y);
    const double corner = 0.25 + 0.75 * light.sky * light.sky;
    const Colour colour = albedo(seen.surface, seen.normal) *
                          (ambient * corner + sunlight * (facing * light.sun * (0.6 + 0.4 * light.sky)));
    return colour * (0.80 + 0.20 * border(mesh.triangle(seen.triangle), camera, seen, direction));
}

Coat coat(const Figure& figure, const Sighting& sighting, const dvec3& direction, const dvec3& to_sun) {
    const dvec3& n = sighting.normal;
    const double facing = 0.5 + 0.5 * glm::dot(n, to_sun);  // light wraps around: no figure has a black side
    const double rim = 1 - std::abs(glm::dot(n, direction));
    const dvec3 mirrored = direction - 2 * glm::dot(direction, n) * n;
    const double gloss = std::pow(std::max(0.0, glm::dot(mirrored, to_sun)), 40);
    Colour linear(std::pow(figure.colour.x, 2.2), std::pow(figure.colour.y, 2.2), std::pow(figure.colour.z, 2.2));
    linear = linear * (glm::mix(earthlight, skylight, 0.5 + 0.5 * n.y) + sunlight * (facing * facing));
    if (figure.glass) return {linear, std::clamp(figure.alpha * (0.45 + 1.6 * rim * rim), 0.0, 0.9)};
    const double edge = std::pow(rim, 4);
    return {linear + Colour(0.35 * gloss) + skylight * (0.25 * edge), figure.alpha + (1 - figure.alpha) * edge};
}

}  // namespace surefoot::tools
