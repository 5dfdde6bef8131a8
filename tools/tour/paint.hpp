/// From light to colour: what the level, the sky and the figures look like.
#pragma once

#include <cstdint>
#include <string_view>

#include <surefoot/mesh.hpp>

#include "tour/camera.hpp"
#include "tour/ground.hpp"
#include "tour/scene.hpp"

namespace surefoot::tools {

/// Light as it is (linear) into a colour as the eye takes it.
[[nodiscard]] Colour to_eye(const Colour& linear);

/// The sky behind a point of the picture, linear; `height` from 0 at the bottom to 1 at the top.
[[nodiscard]] Colour sky(double height);

/// What a surface looks like, linear: as its name says where it is a common one, else a quiet colour of its own.
[[nodiscard]] Colour colour_of_surface(std::uint32_t surface, std::string_view name);

/// The level where `seen`, of the colour `base`, linear. Triangles have fine lines around them where they are large
/// enough for that.
[[nodiscard]] Colour ground(const Mesh& mesh, const Colour& base, const Camera& camera, const Seen& seen,
                            const Light& light, const dvec3& to_sun);

/// One figure, linear: its colour in the sun, and how much it hides.
struct Coat {
    Colour colour;
    double alpha;
};
[[nodiscard]] Coat coat(const Figure& figure, const Sighting& sighting, const dvec3& direction, const dvec3& to_sun);

}  // namespace surefoot::tools
