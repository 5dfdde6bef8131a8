#include "game/level_meshes.hpp"

#include <map>

namespace surefoot::game {

Expected<Mesh> MeshCut::build(const dvec3& origin) const {
    std::vector<vec3> moved(vertices);
    for (vec3& vertex : moved)
        vertex = {float(double(vertex.x) - origin.x), float(double(vertex.y) - origin.y),
                  float(double(vertex.z) - origin.z)};
    return Mesh::build({.vertices = moved, .indices = indices, .surfaces = surfaces});
}

void LevelCutter::append(const ImportedPart& part, MeshCut& into) const {
    std::map<std::uint32_t, std::uint32_t> places;  // from the level's vertices to those of the cut
    const std::size_t end = std::size_t(part.first_triangle) + part.triangle_count;
    for (std::size_t triangle = part.first_triangle; triangle < end; ++triangle) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const std::uint32_t vertex = from_.indices[3 * triangle + corner];
            const auto [place, is_new] = places.try_emplace(vertex, std::uint32_t(into.vertices.size()));
            if (is_new) into.vertices.push_back(from_.vertices[vertex]);
            into.indices.push_back(place->second);
        }
        into.surfaces.push_back(triangle < from_.surfaces.size() ? from_.surfaces[triangle] : 0);
    }
}

bool LevelCutter::take(const std::string& name, MeshCut& into) {
    bool found = false;
    for (std::size_t i = 0; i < taken_.size(); ++i) {
        if (taken_[i] || from_.parts[i].name != name) continue;
        append(from_.parts[i], into);
        taken_[i] = true;
        found = true;
    }
    return found;
}

void LevelCutter::take_rest(MeshCut& into) {
    for (std::size_t i = 0; i < taken_.size(); ++i)
        if (!taken_[i]) {
            append(from_.parts[i], into);
            taken_[i] = true;
        }
}

}  // namespace surefoot::game
