// Large levels in tiles, so that float vertices stay fine wherever they are.
#pragma once

#include <cstdint>
#include <vector>

#include <surefoot/cook.hpp>

#include "cook/soup.hpp"

namespace surefoot::internal {

struct Tiles {
    std::vector<dvec3> origins;          ///< empty if the level's own origin serves for all
    std::vector<std::uint16_t> of;       ///< which tile each triangle is in; empty if there is one
    std::vector<vec3> vertices;          ///< relative to the origin of the tile that uses them
    std::vector<std::uint32_t> indices;  ///< into `vertices`, three a triangle
};

/// Rounds the vertices of `soup` to what the tiles can hold, so that it is then exactly what the tiles say.
/// Requires: coordinates within 1e9 m.
[[nodiscard]] Tiles cut_into_tiles(Soup& soup, CookReport& report);

}  // namespace surefoot::internal
