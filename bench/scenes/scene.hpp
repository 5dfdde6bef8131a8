/// The scenes of the benchmarks: made by code, the same bits on every machine, and small enough to read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <surefoot/math.hpp>
#include <surefoot/mesh.hpp>

namespace surefoot::bench {

struct Scene {
    std::string name;
    std::vector<vec3> vertices{};          ///< [m]
    std::vector<std::uint32_t> indices{};  ///< three a triangle
    bool has_fronts = true;                ///< fronts face the open air; else either side is as good

    [[nodiscard]] std::size_t triangle_count() const { return indices.size() / 3; }
    [[nodiscard]] MeshInput mesh_input() const { return {.vertices = vertices, .indices = indices}; }
    [[nodiscard]] Triangle triangle(std::size_t id) const {
        const auto corner = [&](std::size_t i) { return dvec3(vertices[indices[3 * id + i]]); };
        return {corner(0), corner(1), corner(2)};
    }
};

/// Fractal hills over `quads` x `quads` squares of 0.5 m, two triangles each: 524,288 triangles by default.
[[nodiscard]] Scene make_terrain(std::uint32_t quads = 512);

/// `blocks` x `blocks` houses of three to five floors on a paved ground: walls with doors and windows, stairs from
/// floor to floor, furniture. About 200,000 triangles by default.
[[nodiscard]] Scene make_city(std::uint32_t blocks = 8);

/// Triangles with edges of about 0.5 m that share nothing, thrown into a cube; as dense as a million in 200 m.
[[nodiscard]] Scene make_soup(std::uint32_t triangles = 1'000'000);

}  // namespace surefoot::bench
