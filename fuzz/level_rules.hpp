// What holds of every imported level, whatever it was read from.
#pragma once

#include <surefoot/import.hpp>

#include "bytes.hpp"

namespace fuzz {

inline void require_sound(const surefoot::ImportedLevel& level) {
    require(level.indices.size() % 3 == 0, "three indices a triangle");
    require(level.surfaces.size() == level.triangle_count(), "one surface a triangle");
    for (const std::uint32_t index : level.indices) require(index < level.vertices.size(), "indices are in range");
    for (const std::uint32_t surface : level.surfaces)
        require(surface < level.surface_names.size(), "surfaces have names");
    for (const surefoot::vec3& v : level.vertices)
        require(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z), "vertices are finite");
    for (const surefoot::ImportedMarker& marker : level.markers)
        require(is_finite(marker.position), "markers are somewhere");
    std::uint32_t next = 0;
    for (const surefoot::ImportedPart& part : level.parts) {
        require(part.first_triangle == next && part.triangle_count > 0, "parts lie one after the other");
        next += part.triangle_count;
    }
    require(next == level.triangle_count(), "parts cover all triangles");
}

}  // namespace fuzz
