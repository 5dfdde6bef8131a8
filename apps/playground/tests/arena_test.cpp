#include "debugger/arena.hpp"

#include <gtest/gtest.h>

#include "debugger/strategies.hpp"
#include "debugger/support.hpp"
#include "numeric_reference.hpp"

namespace surefoot::debugger {
namespace {

/// The same triangles twice: as a few, and as a level.
struct Both {
    std::vector<Triangle> triangles;
    std::optional<Mesh> mesh;
};

Both some_ground(std::uint64_t seed, int count) {
    tests::Random random(seed);
    Both both;
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < count; ++i) {
        const dvec3 at = random.point(6);
        Triangle triangle;
        for (std::size_t corner = 0; corner < 3; ++corner) {
            vertices.push_back(vec3(at + random.point(2)));
            corner_of(triangle, corner) = dvec3(vertices.back());
            indices.push_back(static_cast<std::uint32_t>(indices.size()));
        }
        both.triangles.push_back(triangle);
    }
    both.mesh = *Mesh::build({.vertices = vertices, .indices = indices});
    return both;
}

TEST(Arena, answers_alike_for_a_few_triangles_and_for_a_level_of_the_same) {
    const Both both = some_ground(3, 60);
    const Arena few(both.triangles);
    const Arena level(*both.mesh);
    tests::Random random(4);
    for (int i = 0; i < 300; ++i) {
        const Volume volume(tests::some_shape(random, i % 6), random.orientation());
        const Motion motion{random.point(9), random.point(9)};
        const bool one_sided = i % 3 == 0;
        const auto a = few.sweep(volume, motion, one_sided);
        const auto b = level.sweep(volume, motion, one_sided);
        ASSERT_EQ(a.has_value(), b.has_value());
        if (a) {
            EXPECT_EQ(a->t, b->t);
            EXPECT_EQ(a->triangle, b->triangle);
        }
        const auto c = few.deepest(volume, motion.from, one_sided);
        const auto d = level.deepest(volume, motion.from, one_sided);
        ASSERT_EQ(c.has_value(), d.has_value());
        if (c) {
            EXPECT_EQ(c->depth, d->depth);
            EXPECT_EQ(c->triangle, d->triangle);
        }
        EXPECT_EQ(few.drop(motion.from, 20), level.drop(motion.from, 20));
        const auto parts = touching_parts(few, volume, motion, one_sided);
        const auto same = touching_parts(level, volume, motion, one_sided);
        ASSERT_EQ(parts.size(), same.size());
        for (std::size_t k = 0; k < parts.size(); ++k) {
            EXPECT_EQ(parts[k].begin, same[k].begin);
            EXPECT_EQ(parts[k].end, same[k].end);
        }
    }
}

TEST(Support, is_the_farthest_point_of_each_shape) {
    tests::Random random(6);
    for (int i = 0; i < 600; ++i) {
        const Volume volume(tests::some_shape(random, i % 6), random.orientation());
        const dvec3 direction = random.point(1);
        const tests::Point farthest = tests::point(farthest_point(volume, direction));
        const tests::Point along = tests::point(direction);
        EXPECT_NEAR(static_cast<double>(dot(farthest, along)), static_cast<double>(tests::reach(volume, along)), 1e-12);
        EXPECT_TRUE(tests::is_within(volume, farthest, -1e-9L)) << tests::shape_name(i % 6);
    }
}

}  // namespace
}  // namespace surefoot::debugger
