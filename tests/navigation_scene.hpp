// Small worlds to find paths in.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include <surefoot/navigation_query.hpp>

#include "movement_scene.hpp"

namespace surefoot::tests {

/// Cells that are coarse enough for tests to be quick, and tiles small enough for small worlds to have some.
inline NavigationOptions quick() {
    return {.cell_size = 0.2, .cell_height = 0.1, .tile_cells = 32};
}

inline NavigationMesh built(const World& world, const NavigationOptions& options = quick(),
                            const CharacterSettings& settings = {}) {
    auto mesh = NavigationMesh::build(world, settings, options);
    EXPECT_TRUE(mesh.has_value()) << mesh.error().text;
    return *std::move(mesh);
}

inline std::vector<NavigationOutline> outlines_of(const NavigationMesh& mesh) {
    std::vector<NavigationOutline> outlines(mesh.outlines({}));
    mesh.outlines(outlines);
    return outlines;
}

/// Polygons as they are seen, whatever their names and their order.
inline std::vector<std::vector<double>> shapes_of(const NavigationMesh& mesh) {
    std::vector<std::vector<double>> shapes;
    for (const NavigationOutline& outline : outlines_of(mesh)) {
        std::vector<double> shape{static_cast<double>(outline.area), outline.taken_out ? 1.0 : 0.0};
        for (std::size_t i = 0; i < outline.corners; ++i)
            for (int axis = 0; axis < 3; ++axis) shape.push_back(outline.corner[i][axis]);
        shapes.push_back(std::move(shape));
    }
    std::sort(shapes.begin(), shapes.end());
    return shapes;
}

/// The path between the ground under two places.
inline std::optional<NavigationPath> way(const NavigationMesh& mesh, const dvec3& from, const dvec3& to) {
    const NavigationQuery query(mesh);
    const auto start = query.under(from + dvec3{0, 0.5, 0}, 1, 0.5);
    const auto end = query.under(to + dvec3{0, 0.5, 0}, 1, 0.5);
    if (!start || !end) return std::nullopt;
    return query.path(*start, *end);
}

inline bool leads(const NavigationMesh& mesh, const dvec3& from, const dvec3& to) {
    const auto path = way(mesh, from, to);
    return path && !path->partial;
}

inline double length_of(const dvec3& v) {
    return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}

/// A yard with a platform of 2 m that one can only drop from, a mud surface (1) and some walls.
inline Scene yard() {
    return Scene()
        .floor(0, 14, 0, 14)
        .made_of(1)
        .floor(14, 20, 0, 14)
        .made_of(0)
        .block({3, 0, 3}, {8, 2, 8})
        .block({10, 0, 2}, {10.5, 3, 12});
}

inline const std::array<NavigationArea, 3>& yard_areas() {
    static const std::array<NavigationArea, 3> areas{
        NavigationArea{.name = "ground"}, {.name = "mud", .cost = 3}, {.name = "gate", .closed = true}};
    return areas;
}

/// With mud, a shut gate, and a drop from the platform.
inline NavigationMesh built_yard(int threads = 2) {
    static const std::array<std::uint32_t, 2> surface_areas{0, 1};
    static const std::array<NavigationRegion, 1> regions{NavigationRegion{.name = "gate",
                                                                          .pose = {.position = {10.25, 0, 1}},
                                                                          .half_extents = {0.6, 1, 1},
                                                                          .kind = NavigationRegion::Kind::area,
                                                                          .area = 2}};
    NavigationOptions options = quick();
    options.areas = yard_areas();
    options.surface_areas = surface_areas;
    options.regions = regions;
    options.threads = threads;
    NavigationMesh mesh = built(yard().world(), options);
    const std::array<NavigationLink, 1> links{
        NavigationLink{.from = {5, 2, 3.6},
                       .to = {5, 0, 1.5},
                       .takeoff = {5, 2, 3},
                       .kind = NavigationLinkKind::drop,
                       .seconds = 1.2,
                       .inputs = {{.wish = {0, 0, -3}, .ticks = 50}, {.ticks = 22}}}};
    const auto left_out = mesh.set_links(links);
    EXPECT_TRUE(left_out.has_value());
    EXPECT_EQ(left_out.value_or(9), 0U);
    return mesh;
}

}  // namespace surefoot::tests
