#include <array>
#include <bit>
#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include <surefoot/mesh.hpp>

#include "splitmix.hpp"

namespace surefoot {
namespace {

// Triangles of many sizes, some without area, some sharing corners.
Mesh soup(std::uint64_t seed, int triangles) {
    tests::SplitMix random(seed);
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    for (int i = 0; i < triangles; ++i) {
        const dvec3 middle = random.point(10);
        const double size = i % 7 == 0 ? 4.0 : 0.7;
        for (int corner = 0; corner < 3; ++corner) {
            if (i > 0 && random.in(0, 1) < 0.2) {
                indices.push_back(static_cast<std::uint32_t>(random.next() % vertices.size()));
                continue;
            }
            vertices.push_back(vec3(middle + random.point(size)));
            indices.push_back(static_cast<std::uint32_t>(vertices.size() - 1));
        }
    }
    auto mesh = Mesh::build({vertices, indices});
    EXPECT_TRUE(mesh.has_value());
    return *mesh;
}

void expect_same_bits(const std::optional<Hit>& a, const std::optional<Hit>& b) {
    ASSERT_EQ(a.has_value(), b.has_value());
    if (!a) return;
    EXPECT_EQ(std::bit_cast<std::uint64_t>(a->t), std::bit_cast<std::uint64_t>(b->t));
    EXPECT_EQ(a->triangle, b->triangle);
    EXPECT_EQ(a->normal, b->normal);
    EXPECT_EQ(a->point, b->point);
    EXPECT_EQ(a->feature, b->feature);
    EXPECT_EQ(a->started_inside, b->started_inside);
}

TEST(Mesh, the_tree_answers_bit_for_bit_like_brute_force) {
    const Mesh mesh = soup(3, 300);
    const std::array<Shape, 6> shapes{Sphere{}, Ellipsoid{}, Capsule{}, Box{}, Cylinder{}, Cone{}};
    tests::SplitMix random(4);
    int hits = 0;
    for (const Shape& shape : shapes) {
        for (int i = 0; i < 150; ++i) {
            const Volume volume(shape, i % 2 == 0 ? dquat(1, 0, 0, 0) : random.turn());
            const dvec3 from = random.point(10);
            const Motion motion{from, i % 3 == 0 ? random.point(10) : from + random.point(0.3)};
            const bool one_sided = i % 5 == 0;
            const auto by_tree = mesh.sweep(volume, motion, {.one_sided = one_sided});
            expect_same_bits(by_tree,
                             mesh.sweep(volume, motion, {.one_sided = one_sided, .search = Search::brute_force}));
            hits += by_tree.has_value() ? 1 : 0;
        }
    }
    EXPECT_GT(hits, 300);
    for (int i = 0; i < 2000; ++i) {
        const Motion motion{random.point(12), random.point(12)};
        expect_same_bits(mesh.ray(motion), mesh.ray(motion, {.search = Search::brute_force}));
    }
}

TEST(Mesh, overlaps_come_in_the_order_of_ids_and_are_counted_beyond_the_room) {
    const Mesh mesh = soup(5, 400);
    const Volume volume(Sphere{3});
    std::array<Overlap, 400> by_tree;
    std::array<Overlap, 400> by_force;
    const std::size_t count = mesh.overlap(volume, {0, 0, 0}, by_tree);
    ASSERT_EQ(mesh.overlap(volume, {0, 0, 0}, by_force, {.search = Search::brute_force}), count);
    ASSERT_GT(count, 20U);
    for (std::size_t i = 0; i < count; ++i) {
        EXPECT_EQ(by_tree[i].triangle, by_force[i].triangle);
        EXPECT_EQ(by_tree[i].depth, by_force[i].depth);
        if (i > 0) {
            EXPECT_LT(by_tree[i - 1].triangle, by_tree[i].triangle);
        }
    }
    std::array<Overlap, 5> few;
    EXPECT_EQ(mesh.overlap(volume, {0, 0, 0}, few), count);
    for (std::size_t i = 0; i < few.size(); ++i) EXPECT_EQ(few[i].triangle, by_tree[i].triangle);
}

TEST(Mesh, ties_go_to_the_lowest_triangle) {
    const std::vector<vec3> vertices{{-5, 0, -5}, {0, 0, 5}, {5, 0, -5}};
    const std::vector<std::uint32_t> indices{2, 0, 1, 0, 1, 2, 1, 2, 0};
    const auto mesh = Mesh::build({vertices, indices});
    ASSERT_TRUE(mesh.has_value());
    const auto hit = mesh->sweep(Sphere{}, {{0, 3, 0}, {0, -3, 0}});
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->triangle, 0U);
}

TEST(Mesh, keeps_order_and_surfaces_of_its_triangles) {
    const std::vector<vec3> vertices{{-5, 0, -5}, {0, 0, 5}, {5, 0, -5}, {0, 9, 0}};
    const std::vector<std::uint32_t> indices{0, 1, 3, 0, 1, 2};
    const std::vector<std::uint32_t> surfaces{7, 42};
    const auto mesh = Mesh::build({vertices, indices, surfaces});
    ASSERT_TRUE(mesh.has_value());
    EXPECT_EQ(mesh->triangle_count(), 2U);
    EXPECT_EQ(mesh->triangle(0).c, dvec3(0, 9, 0));
    EXPECT_EQ(mesh->surface(1), 42U);
    EXPECT_EQ(mesh->bounds().max, dvec3(5, 9, 5));
    const auto hit = mesh->sweep(Sphere{0.5}, {{0, -3, -3}, {0, 0, -3}});
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->surface, 42U);
}

TEST(Mesh, without_triangles_is_never_hit) {
    const auto mesh = Mesh::build({});
    ASSERT_TRUE(mesh.has_value());
    EXPECT_FALSE(mesh->sweep(Sphere{}, {{0, 0, 0}, {9, 9, 9}}).has_value());
    EXPECT_FALSE(mesh->ray({{0, 0, 0}, {9, 9, 9}}).has_value());
    std::array<Overlap, 1> room;
    EXPECT_EQ(mesh->overlap(Sphere{}, {0, 0, 0}, room), 0U);
}

TEST(Mesh, refuses_what_it_cannot_use_in_words) {
    const std::vector<vec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    const std::vector<std::uint32_t> beyond{0, 1, 3};
    const auto out_of_range = Mesh::build({vertices, beyond});
    ASSERT_FALSE(out_of_range.has_value());
    EXPECT_EQ(out_of_range.error().code, ErrorCode::invalid);
    EXPECT_NE(out_of_range.error().text.find("triangle 0 asks for vertex 3"), std::string::npos);

    const std::vector<std::uint32_t> incomplete{0, 1};
    EXPECT_FALSE(Mesh::build({vertices, incomplete}).has_value());

    const std::vector<vec3> not_finite{{0, 0, 0}, {1, std::numeric_limits<float>::quiet_NaN(), 0}, {0, 0, 1}};
    const std::vector<std::uint32_t> indices{0, 1, 2};
    EXPECT_FALSE(Mesh::build({not_finite, indices}).has_value());

    const std::vector<std::uint32_t> too_many_surfaces{1, 2};
    EXPECT_FALSE(Mesh::build({vertices, indices, too_many_surfaces}).has_value());
}

TEST(Mesh, a_triangle_that_is_not_there_is_all_zeros) {
    const Mesh mesh = soup(6, 10);
    for (const std::uint32_t id : {10U, 11U, 0xffffffffU}) {
        const Triangle none = mesh.triangle(id);
        EXPECT_EQ(none.a, dvec3(0, 0, 0));
        EXPECT_EQ(none.b, dvec3(0, 0, 0));
        EXPECT_EQ(none.c, dvec3(0, 0, 0));
        EXPECT_EQ(mesh.surface(id), 0U);
        EXPECT_FALSE(mesh.is_hidden(id));
    }
}

TEST(Mesh, a_ray_that_all_but_stands_still_meets_a_point_whichever_way_it_is_searched) {
    // Found by fuzzing: along two axes it goes less than floats can hold, and the tree let it pass.
    const std::vector<vec3> vertices(3, vec3(0, 0, 0));
    const std::vector<std::uint32_t> indices{0, 1, 2};
    const auto mesh = Mesh::build({.vertices = vertices, .indices = indices});
    ASSERT_TRUE(mesh.has_value());
    const Motion motion{{-8.59425630745973e-26, -1.5658599086263204e-242, 5.07e-321}, {0, 0, 0}};
    for (const Search search : {Search::brute_force, Search::scalar_tree, Search::tree}) {
        const auto hit = mesh->ray(motion, {.search = search});
        ASSERT_TRUE(hit.has_value()) << static_cast<int>(search);
        EXPECT_EQ(hit->t, 1);
    }
}

TEST(Mesh, an_invalid_query_is_blocked) {
    const Mesh mesh = soup(6, 10);
    const auto hit = mesh.sweep(Sphere{0}, {{0, 0, 0}, {1, 1, 1}});
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->status, HitStatus::invalid);
}

}  // namespace
}  // namespace surefoot
