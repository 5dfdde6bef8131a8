/// The six shapes as meshes to look at: vertices with normals, triangles, and the edges of which an outline is made.
#pragma once

#include <cstdint>
#include <vector>

#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

namespace surefoot::view {

/// About the reference point, in the shape's own axes, unturned.
struct ShapeMesh {
    struct Vertex {
        vec3 position;
        vec3 normal;
    };
    /// Two faces share it; `normals` are theirs.
    struct Edge {
        vec3 from;
        vec3 to;
        vec3 normals[2];
        bool crease;  ///< of the shape itself, as a box's or a cylinder's rim
    };
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise seen from outside
    std::vector<Edge> edges;
};

/// `around` is how many corners stand for a circle.
[[nodiscard]] ShapeMesh mesh_of(const Shape& shape, int around = 48);

/// How far the shape reaches from its reference point, at most [m].
[[nodiscard]] double reach_of(const Shape& shape);

/// The middle of the shape, in its own axes: its reference point, but for the cone.
[[nodiscard]] dvec3 middle_of(const Shape& shape);

}  // namespace surefoot::view
