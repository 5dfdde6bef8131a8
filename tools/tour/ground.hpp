/// The level as a camera sees it, and how each seen place is lit.
#pragma once

#include <vector>

#include <surefoot/mesh.hpp>

#include "tour/camera.hpp"
#include "tour/scene.hpp"

namespace surefoot::tools {

/// What one line of sight met of the level.
struct Seen {
    bool met = false;
    double distance = 0;  ///< from the eye [m]
    dvec3 point{0, 0, 0};
    dvec3 normal{0, 0, 0};
    std::uint32_t triangle = 0;
    std::uint32_t surface = 0;
};

/// How much of the sun and of the sky a place gets [0, 1].
struct Light {
    double sun = 1;
    double sky = 1;
};

struct Sunshine {
    const Mesh& mesh;
    std::vector<SweptEllipsoid> casters;  ///< bodies that throw a shadow
    dvec3 to_sun{0, 1, 0};                ///< unit
    double far = 1;                       ///< longer than the level
    double reach = 1;                     ///< how far a corner darkens [m]
    double ceiling = 1e300;               ///< the sun shines in from here, where the level is cut away [m]
    bool one_sided = false;
};

[[nodiscard]] Seen look(const Mesh& mesh, const Camera& camera, double x, double y, double far, bool one_sided);

/// Light at one place by a few rays; `seed` varies their directions from pixel to pixel.
[[nodiscard]] Light light_at(const Sunshine& sunshine, const Seen& seen, std::uint32_t seed);

/// Takes the noise out of the light of a pixel with the neighbours that see the same smooth piece of level, `step`
/// pixels apart.
[[nodiscard]] Light smoothed(const std::vector<Light>& light, const std::vector<Seen>& seen, const Camera& camera,
                             int x, int y, int step);

}  // namespace surefoot::tools
