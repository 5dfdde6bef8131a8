#include "tour/paint.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>

namespace surefoot::tools {
namespace {

const Colour sunlight(1.50, 1.32, 1.06);
const Colour skylight(0.36, 0.44, 0.56);
const Colour earthlight(0.22, 0.20, 0.18);

double smooth_step(double from, double to, double x) {
    const double f = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return f * f * (3 - 2 * f);
}

/// Plaster for what nothing is said about, quiet earth colours for named surfaces; those whose names speak of grass or
/// ice look it.
Colour albedo(const Colour& base, const dvec3& normal) {
    // Walls a little cooler and darker than floors: a plan reads at a glance.
    return glm::mix(base * Colour(0.72, 0.76, 0.82), base, smooth_step(0.3, 0.95, normal.y));
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

constexpr std::array<std::array<double, 3>, 8> tints{{{0.46, 0.42, 0.35},
                                                      {0.33, 0.42, 0.36},
                                                      {0.44, 0.32, 0.26},
                                                      {0.30, 0.38, 0.46},
                                                      {0.48, 0.42, 0.24},
                                                      {0.38, 0.32, 0.42},
                                                      {0.34, 0.42, 0.42},
                                                      {0.42, 0.40, 0.38}}};

struct NamedTint {
    std::string_view part;  ///< of the surface's name, in small letters
    Colour colour;
};

/// Names that most levels use one way or another.
const std::array<NamedTint, 12> named_tints{{{"grass", {0.20, 0.27, 0.12}},
                                             {"ice", {0.50, 0.64, 0.72}},
                                             {"snow", {0.66, 0.68, 0.70}},
                                             {"sand", {0.58, 0.47, 0.30}},
                                             {"stone", {0.40, 0.38, 0.36}},
                                             {"rock", {0.30, 0.27, 0.25}},
                                             {"wood", {0.40, 0.25, 0.14}},
                                             {"metal", {0.34, 0.36, 0.39}},
                                             {"plaster", {0.60, 0.55, 0.47}},
                                             {"brick", {0.44, 0.20, 0.14}},
                                             {"water", {0.16, 0.32, 0.42}},
                                             {"lava", {0.60, 0.18, 0.06}}}};

}  // namespace

Colour colour_of_surface(std::uint32_t surface, std::string_view name) {
    std::string small(name);
    for (char& letter : small) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    for (const NamedTint& tint : named_tints)
        if (small.find(tint.part) != std::string::npos) return tint.colour;
    if (surface == 0) return {0.46, 0.44, 0.41};
    const auto& tint = tints[(surface - 1) % tints.size()];
    return {tint[0], tint[1], tint[2]};
}

Colour to_eye(const Colour& linear) {
    Colour out;
    for (int i = 0; i < 3; ++i) {
        // A soft shoulder, so that what the sun shines on keeps its colour (the curve of Narkowicz, "ACES Filmic Tone
        // Mapping Curve", 2015); then the curve of sRGB.
        const double x = std::max(0.0, linear[i]) * 0.92;
        const double y = std::clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
        out[i] = y <= 0.0031308 ? 12.92 * y : 1.055 * std::pow(y, 1 / 2.4) - 0.055;
    }
    return out;
}

Colour sky(double height) {
    return glm::mix(Colour(0.66, 0.64, 0.60), Colour(0.36, 0.50, 0.68), smooth_step(-0.1, 1.1, height));
}

Colour ground(const Mesh& mesh, const Colour& base, const Camera& camera, const Seen& seen, const Light& light,
              const dvec3& to_sun) {
    const dvec3 direction = glm::normalize(seen.point - camera.eye);
    const double facing = std::max(0.0, glm::dot(seen.normal, to_sun));
    const Colour ambient = glm::mix(earthlight, skylight, 0.5 + 0.5 * seen.normal.y);
    const double corner = 0.25 + 0.75 * light.sky * light.sky;
    const Colour colour =
        albedo(base, seen.normal) * (ambient * corner + sunlight * (facing * light.sun * (0.6 + 0.4 * light.sky)));
    return colour * (0.86 + 0.14 * border(mesh.triangle(seen.triangle), camera, seen, direction));
}

Coat coat(const Figure& figure, const Sighting& sighting, const dvec3& direction, const dvec3& to_sun) {
    const dvec3& n = sighting.normal;
    const double facing = 0.5 + 0.5 * glm::dot(n, to_sun);  // light wraps around: no figure has a black side
    const double rim = 1 - std::abs(glm::dot(n, direction));
    const dvec3 mirrored = direction - 2 * glm::dot(direction, n) * n;
    const double gloss = std::pow(std::max(0.0, glm::dot(mirrored, to_sun)), 40);
    Colour linear(std::pow(figure.colour.x, 2.2), std::pow(figure.colour.y, 2.2), std::pow(figure.colour.z, 2.2));
    linear = linear * (1.1 * glm::mix(earthlight, skylight, 0.5 + 0.5 * n.y) + sunlight * (0.62 * facing * facing));
    if (figure.glass) return {linear, std::clamp(figure.alpha * (0.45 + 1.6 * rim * rim), 0.0, 0.9)};
    const double edge = std::pow(rim, 4);
    return {linear + Colour(0.35 * gloss) + skylight * (0.25 * edge), figure.alpha + (1 - figure.alpha) * edge};
}

}  // namespace surefoot::tools
