// Does a triangle source answer as a mesh with the same triangles does? Every query, every shape, bit for bit.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <gtest/gtest.h>
#include <optional>
#include <vector>

#include <surefoot/mesh.hpp>
#include <surefoot/source.hpp>

#include "splitmix.hpp"

namespace surefoot::tests {

/// A mesh with some triangles of a source, and what the source calls each of them.
struct SameTriangles {
    Mesh mesh;
    std::vector<std::uint32_t> ids;  ///< rising
};

inline SameTriangles as_mesh(const std::vector<SourceTriangle>& triangles) {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    std::vector<std::uint32_t> surfaces;
    std::vector<std::uint32_t> ids;
    for (const SourceTriangle& found : triangles) {
        for (const dvec3& corner : {found.triangle.a, found.triangle.b, found.triangle.c}) {
            indices.push_back(static_cast<std::uint32_t>(vertices.size()));
            vertices.emplace_back(corner);
            EXPECT_EQ(dvec3(vertices.back()), corner) << "a corner that no float is";
        }
        surfaces.push_back(found.surface);
        EXPECT_TRUE(ids.empty() || ids.back() < found.id);
        ids.push_back(found.id);
    }
    auto mesh = Mesh::build({vertices, indices, surfaces});
    EXPECT_TRUE(mesh.has_value());
    return {*mesh, ids};
}

/// How often the two met something, by query: a comparison of empty air proves nothing.
struct Met {
    int sweep = 0;
    int ray = 0;
    int overlap = 0;
    int nearest = 0;
    int gather = 0;
};

/// Asks both the same questions, around a region of space. Coordinates are multiples of `step` in every second
/// question, so that shapes start and end exactly on faces, edges and corners.
class Agreement {
public:
    Agreement(const SourceView& source, const SameTriangles& same, const Bounds& region, double step,
              std::uint64_t seed)
        : source_(source), same_(same), region_(region), step_(step), random_(seed) {}

    void ask(int questions) {
        for (int i = 0; i < questions && !::testing::Test::HasFailure(); ++i) {
            SCOPED_TRACE(::testing::Message() << "question " << i);
            on_grid_ = random_.next() % 2 == 0;
            const Volume volume = any_volume(static_cast<std::size_t>(i) % 6);
            const dvec3 from = any_point();
            const Motion motion{from, any_end(from)};
            const bool one_sided = random_.next() % 3 == 0;
            const bool filtered = random_.next() % 3 == 0;
            const auto by_source = [](std::uint32_t id, std::uint32_t surface) { return (id ^ surface) % 3 != 0; };
            const auto by_mesh = [&](std::uint32_t triangle, std::uint32_t surface) {
                return by_source(same_.ids[triangle], surface);
            };
            const QueryOptions of_mesh{.one_sided = one_sided,
                                       .filter = filtered ? TriangleFilter(by_mesh) : TriangleFilter()};
            for (const Search search : {Search::tree, Search::brute_force}) {
                if (search == Search::brute_force && i % 16 >= 6) continue;  // six shapes of it now and then
                const QueryOptions of_source{.one_sided = one_sided,
                                             .search = search,
                                             .filter = filtered ? TriangleFilter(by_source) : TriangleFilter()};
                compare(volume, motion, of_source, of_mesh);
            }
        }
    }

    [[nodiscard]] const Met& met() const { return met_; }

private:
    void compare(const Volume& volume, const Motion& motion, const QueryOptions& of_source,
                 const QueryOptions& of_mesh) {
        const auto swept = same_.mesh.sweep(volume, motion, of_mesh);
        expect_same(source_.sweep(volume, motion, of_source), swept);
        EXPECT_EQ(source_.sweep_any(volume, motion, of_source), swept.has_value());
        met_.sweep += swept.has_value() ? 1 : 0;

        const auto seen = same_.mesh.ray(motion, of_mesh);
        expect_same(source_.ray(motion, of_source), seen);
        EXPECT_EQ(source_.ray_any(motion, of_source), seen.has_value());
        met_.ray += seen.has_value() ? 1 : 0;

        std::vector<Overlap> ours(7);
        std::vector<Overlap> theirs(7);
        const std::size_t touched = same_.mesh.overlap(volume, motion.from, theirs, of_mesh);
        ASSERT_EQ(source_.overlap(volume, motion.from, ours, of_source), touched);
        for (std::size_t i = 0; i < std::min<std::size_t>(touched, ours.size()); ++i) {
            EXPECT_EQ(ours[i].triangle, same_.ids[theirs[i].triangle]);
            EXPECT_EQ(ours[i].surface, theirs[i].surface);
            EXPECT_EQ(ours[i].point, theirs[i].point);
            EXPECT_EQ(ours[i].normal, theirs[i].normal);
            EXPECT_EQ(ours[i].depth, theirs[i].depth);
            EXPECT_EQ(ours[i].feature, theirs[i].feature);
        }
        met_.overlap += touched > 0 ? 1 : 0;

        const double farthest = random_.next() % 3 == 0 ? 1e30 : random_.in(0, 3) * step_;
        const auto near_source = source_.nearest(motion.from, farthest, of_source);
        const auto near_mesh = same_.mesh.nearest(motion.from, farthest, of_mesh);
        ASSERT_EQ(near_source.has_value(), near_mesh.has_value());
        if (near_mesh) {
            EXPECT_EQ(near_source->distance, near_mesh->distance);
            EXPECT_EQ(near_source->point, near_mesh->point);
            EXPECT_EQ(near_source->triangle, same_.ids[near_mesh->triangle]);
            EXPECT_EQ(near_source->surface, near_mesh->surface);
            EXPECT_EQ(near_source->feature, near_mesh->feature);
            ++met_.nearest;
        }
        compare_gathered(motion, of_source, of_mesh);
    }

    void compare_gathered(const Motion& motion, const QueryOptions& of_source, const QueryOptions& of_mesh) {
        const dvec3 low(std::min(motion.from.x, motion.to.x), std::min(motion.from.y, motion.to.y),
                        std::min(motion.from.z, motion.to.z));
        const dvec3 high(std::max(motion.from.x, motion.to.x), std::max(motion.from.y, motion.to.y),
                         std::max(motion.from.z, motion.to.z));
        std::vector<SourceTriangle> ours(same_.ids.size());
        std::vector<SourceTriangle> theirs(same_.ids.size());
        const std::size_t count = same_.mesh.gather({low, high}, theirs, of_mesh);
        ASSERT_EQ(source_.gather({low, high}, ours, of_source), count);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_EQ(ours[i].id, same_.ids[theirs[i].id]);
            EXPECT_EQ(ours[i].surface, theirs[i].surface);
            EXPECT_EQ(ours[i].triangle.a, theirs[i].triangle.a);
            EXPECT_EQ(ours[i].triangle.b, theirs[i].triangle.b);
            EXPECT_EQ(ours[i].triangle.c, theirs[i].triangle.c);
            EXPECT_EQ(source_.triangle(ours[i].id).b, ours[i].triangle.b);
            EXPECT_EQ(source_.surface(ours[i].id), ours[i].surface);
        }
        met_.gather += count > 0 ? 1 : 0;
    }

    void expect_same(const std::optional<Hit>& ours, const std::optional<Hit>& theirs) {
        ASSERT_EQ(ours.has_value(), theirs.has_value());
        if (!ours) return;
        EXPECT_EQ(std::bit_cast<std::uint64_t>(ours->t), std::bit_cast<std::uint64_t>(theirs->t));
        EXPECT_EQ(ours->triangle, same_.ids[theirs->triangle]);
        EXPECT_EQ(ours->surface, theirs->surface);
        EXPECT_EQ(ours->point, theirs->point);
        EXPECT_EQ(ours->normal, theirs->normal);
        EXPECT_EQ(ours->feature, theirs->feature);
        EXPECT_EQ(ours->status, theirs->status);
        EXPECT_EQ(ours->started_inside, theirs->started_inside);
    }

    double any_size() {
        return on_grid_ ? step_ * 0.25 * static_cast<double>(1 + random_.next() % 6) : step_ * random_.in(0.05, 1.5);
    }

    Volume any_volume(std::size_t kind) {
        const dquat turned = random_.next() % 2 == 0 ? dquat(1, 0, 0, 0) : random_.turn();
        const double a = any_size();
        const double b = any_size();
        const double c = any_size();
        const std::array<Shape, 6> shapes{Sphere{a},      Ellipsoid{{a, b, c}}, Capsule{a, b},
                                          Box{{a, b, c}}, Cylinder{a, b},       Cone{a, b}};
        return Volume(shapes[kind], turned);
    }

    double snapped(double coordinate) {
        // Half a step is where faces of partial blocks and the resting places of shapes are.
        const double step = step_ * 0.25;
        return static_cast<double>(static_cast<std::int64_t>(coordinate / step)) * step;
    }

    dvec3 any_point() {
        dvec3 point(random_.in(region_.min.x, region_.max.x), random_.in(region_.min.y, region_.max.y),
                    random_.in(region_.min.z, region_.max.z));
        if (on_grid_) point = dvec3(snapped(point.x), snapped(point.y), snapped(point.z));
        return point;
    }

    dvec3 any_end(const dvec3& from) {
        switch (random_.next() % 5) {
            case 0:
                return any_point();  // far
            case 1:
                return dvec3(any_point().x, from.y, from.z);
            case 2:
                return dvec3(from.x, any_point().y, from.z);
            case 3:
                return from + dvec3(0, 0, on_grid_ ? step_ : random_.in(-step_, step_));
            default:
                return from + random_.point(step_ * 0.5);  // a frame's move
        }
    }

    SourceView source_;
    const SameTriangles& same_;
    Bounds region_;
    double step_;
    SplitMix random_;
    bool on_grid_ = false;
    Met met_;
};

}  // namespace surefoot::tests
