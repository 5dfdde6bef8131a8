/// Polygons of a navigation mesh laid on the ground: they are flat pieces, and ground is not.
#pragma once

#include <array>
#include <vector>

#include <surefoot/navigation_mesh.hpp>
#include <surefoot/world.hpp>

namespace surefoot::playground {

struct DrapedPolygon {
    std::vector<std::array<dvec3, 3>> triangles;
    std::array<std::vector<dvec3>, 6> sides;  ///< from corner[i] to corner[i + 1]
};

/// Cut finely where the ground bends, and only there. Polygons that share a side are cut alike along it.
[[nodiscard]] DrapedPolygon drape(const World& world, const NavigationMesh& mesh, const NavigationOutline& outline);

}  // namespace surefoot::playground
