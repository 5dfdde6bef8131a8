// What the tests of the world share: triangles to fill it with, and comparisons to the last bit.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <gtest/gtest.h>
#include <optional>
#include <vector>

#include <surefoot/surefoot.hpp>

#include "splitmix.hpp"

namespace surefoot::tests {

inline const std::array<Shape, 6> every_shape{Sphere{},
                                              Ellipsoid{.radii = {0.3, 0.9, 0.5}},
                                              Capsule{},
                                              Box{.half_extents = {0.3, 0.6, 0.4}},
                                              Cylinder{.radius = 0.4, .half_height = 0.6},
                                              Cone{.radius = 0.5, .height = 1.2}};

struct Soup {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> surfaces;

    [[nodiscard]] std::size_t count() const { return indices.size() / 3; }

    /// A mesh of the triangles first, first + 1, ..., in this order.
    [[nodiscard]] Mesh mesh(std::size_t first, std::size_t how_many) const {
        const auto mesh = Mesh::build({.vertices = vertices,
                                       .indices = std::span(indices).subspan(3 * first, 3 * how_many),
                                       .surfaces = std::span(surfaces).subspan(first, how_many)});
        EXPECT_TRUE(mesh.has_value());
        return *mesh;
    }
    [[nodiscard]] Mesh mesh() const { return mesh(0, count()); }
};

/// Triangles of many sizes within `size` of the origin; some share corners, some have no area.
inline Soup soup(std::uint64_t seed, int triangles, double size) {
    SplitMix random(seed);
    Soup soup;
    for (int i = 0; i < triangles; ++i) {
        const dvec3 middle = random.point(size);
        const double extent = i % 7 == 0 ? size / 2 : size / 10;
        for (int corner = 0; corner < 3; ++corner) {
            if (i > 0 && random.in(0, 1) < 0.2) {
                soup.indices.push_back(static_cast<std::uint32_t>(random.next() % soup.vertices.size()));
                continue;
            }
            soup.vertices.push_back(vec3(middle + random.point(extent)));
            soup.indices.push_back(static_cast<std::uint32_t>(soup.vertices.size() - 1));
        }
        soup.surfaces.push_back(static_cast<std::uint32_t>(random.next() % 5));
    }
    return soup;
}

/// Two triangles: the rectangle with these corners, which go round it.
inline Mesh quad(const vec3& a, const vec3& b, const vec3& c, const vec3& d) {
    const std::array<vec3, 4> corners{a, b, c, d};
    const std::array<std::uint32_t, 6> indices{0, 1, 2, 0, 2, 3};
    const auto mesh = Mesh::build({.vertices = corners, .indices = indices});
    EXPECT_TRUE(mesh.has_value());
    return *mesh;
}

/// A level floor around the origin, seen from above.
inline Mesh floor(float half) {
    return quad({-half, 0, half}, {half, 0, half}, {half, 0, -half}, {-half, 0, -half});
}

inline bool same_bits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}
inline bool same_bits(const dvec3& a, const dvec3& b) {
    return same_bits(a.x, b.x) && same_bits(a.y, b.y) && same_bits(a.z, b.z);
}
inline bool same_bits(const Hit& a, const Hit& b) {
    return same_bits(a.t, b.t) && same_bits(a.point, b.point) && same_bits(a.normal, b.normal) &&
           a.triangle == b.triangle && a.surface == b.surface && a.body == b.body && a.feature == b.feature &&
           a.status == b.status && a.started_inside == b.started_inside;
}
inline bool same_bits(const Overlap& a, const Overlap& b) {
    return same_bits(a.point, b.point) && same_bits(a.normal, b.normal) && same_bits(a.depth, b.depth) &&
           a.triangle == b.triangle && a.surface == b.surface && a.body == b.body && a.feature == b.feature &&
           a.status == b.status;
}
inline bool same_bits(const NearestPoint& a, const NearestPoint& b) {
    return same_bits(a.point, b.point) && same_bits(a.distance, b.distance) && a.triangle == b.triangle &&
           a.surface == b.surface && a.body == b.body && a.feature == b.feature && a.status == b.status;
}
inline bool same_bits(const SourceTriangle& a, const SourceTriangle& b) {
    return same_bits(a.triangle.a, b.triangle.a) && same_bits(a.triangle.b, b.triangle.b) &&
           same_bits(a.triangle.c, b.triangle.c) && a.id == b.id && a.surface == b.surface && a.body == b.body;
}
template <typename T>
bool same_bits(const std::optional<T>& a, const std::optional<T>& b) {
    return a.has_value() == b.has_value() && (!a || same_bits(*a, *b));
}

/// A pose that is anywhere within `size`, turned anyhow.
inline Pose any_pose(SplitMix& random, double size) {
    const dvec3 position = random.point(size);
    return {position, random.turn()};
}

}  // namespace surefoot::tests
