// A level as it comes out of a .glb: still triangles, things that move, and places.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <surefoot/import.hpp>

#include "hero.hpp"

namespace day {

// [level]
/// Something that goes to and fro: its triangles about its own origin, and between where and where that goes.
struct Platform {
    surefoot::Mesh mesh;
    dvec3 from, to;
};

struct Level {
    surefoot::Mesh still;
    std::vector<Platform> platforms;
    std::vector<surefoot::Marker> markers;
    std::vector<std::string> surfaces;  // by surface number: the names of the materials
};

inline const surefoot::Marker* find(std::span<const surefoot::Marker> markers, std::string_view name) {
    for (const surefoot::Marker& marker : markers)
        if (marker.name == name) return &marker;
    return nullptr;
}

/// Where the markers of a kind are.
inline std::vector<dvec3> places(const Level& level, std::string_view kind) {
    std::vector<dvec3> found;
    for (const surefoot::Marker& marker : level.markers)
        if (marker.kind == kind) found.push_back(marker.position);
    return found;
}
// [/level]

// [cut]
/// Some parts of a file as a mesh of their own, about `origin`.
inline surefoot::Expected<surefoot::Mesh> cut(const surefoot::ImportedLevel& file,
                                              std::span<const surefoot::ImportedPart> parts, const dvec3& origin) {
    std::vector<surefoot::vec3> vertices(file.vertices);
    for (surefoot::vec3& vertex : vertices) vertex -= surefoot::vec3(origin);
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> surfaces;
    for (const surefoot::ImportedPart& part : parts)
        for (std::size_t i = 0; i < part.triangle_count; ++i) {
            const std::size_t triangle = part.first_triangle + i;
            for (std::size_t corner = 0; corner < 3; ++corner) indices.push_back(file.indices[3 * triangle + corner]);
            surfaces.push_back(file.surfaces[triangle]);
        }
    return surefoot::Mesh::build({.vertices = vertices, .indices = indices, .surfaces = surfaces});
}
// [/cut]

// [load]
inline surefoot::Expected<Level> load_level(const std::string& path) {
    const auto file = surefoot::import_level(path);
    if (!file) return tl::unexpected(file.error());

    std::vector<surefoot::ImportedPart> still;
    std::vector<Platform> platforms;
    for (const surefoot::ImportedPart& part : file->parts) {
        // A node with extras is a marker, also if it has triangles; those are the part of the same name.
        const surefoot::Marker* const marker = find(file->markers, part.name);
        const surefoot::Marker* const end = find(file->markers, part.name + ".end");
        if (marker == nullptr || marker->kind != "platform" || end == nullptr) {
            still.push_back(part);
            continue;
        }
        auto mesh = cut(*file, {&part, 1}, marker->position);
        if (!mesh) return tl::unexpected(mesh.error());
        platforms.push_back({std::move(*mesh), marker->position, end->position});
    }
    auto mesh = cut(*file, still, {0, 0, 0});
    if (!mesh) return tl::unexpected(mesh.error());
    return Level{std::move(*mesh), std::move(platforms), file->markers, file->surface_names};
}
// [/load]

}  // namespace day
