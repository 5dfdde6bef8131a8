// Which vertices and edges triangles share, and how the surface bends there.
#include "mesh/edges.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <tuple>
#include <vector>

#include "mesh/weld.hpp"
#include "splitmix.hpp"

namespace surefoot::internal {
namespace {

using Indices = std::vector<std::uint32_t>;

/// Two triangles, abc and the one beyond its side ab, with the third corner where it is given.
std::vector<std::uint8_t> kinds_with_neighbour(const vec3& third, double tolerance = 0) {
    const std::vector<vec3> vertices{{0, 0, 0}, {0, 0, 2}, {2, 0, 0}, third};
    const Indices indices{0, 1, 2, 1, 0, 3};  // the first one faces up
    return edge_kinds(std::span<const vec3>(vertices), indices, tolerance);
}

TEST(Weld, vertices_at_one_place_take_the_lowest_index) {
    const std::vector<vec3> vertices{{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {-0.0F, 0, -0.0F}, {1, 2, 3.0000002F}};
    EXPECT_EQ(same_places(std::span<const vec3>(vertices)), (Indices{0, 1, 0, 1, 4}));
}

TEST(Weld, many_vertices_are_welded_as_a_map_would) {
    tests::SplitMix random(1);
    std::vector<dvec3> vertices(20000);
    for (dvec3& v : vertices) {
        const auto coordinate = [&] { return static_cast<double>(random.next() % 20) * 0.25; };
        v.x = coordinate();
        v.y = coordinate();
        v.z = coordinate();
    }
    std::map<std::tuple<double, double, double>, std::uint32_t> lowest;
    const Indices welded = same_places(std::span<const dvec3>(vertices));
    for (std::uint32_t i = 0; i < vertices.size(); ++i) {
        const auto [found, is_new] = lowest.try_emplace({vertices[i].x, vertices[i].y, vertices[i].z}, i);
        ASSERT_EQ(welded[i], found->second) << i;
    }
}

TEST(Edges, a_neighbour_below_makes_an_edge_convex_and_one_above_concave) {
    EXPECT_EQ(edge_kind(kinds_with_neighbour({-2, -1, 0})[0], 0), EdgeKind::convex);
    EXPECT_EQ(edge_kind(kinds_with_neighbour({-2, 1, 0})[0], 0), EdgeKind::concave);
    EXPECT_EQ(edge_kind(kinds_with_neighbour({-2, 0, 0})[0], 0), EdgeKind::flat);
}

TEST(Edges, both_neighbours_agree) {
    for (const float height : {-1.0F, 0.0F, 1.0F}) {
        const auto kinds = kinds_with_neighbour({-2, height, 0});
        EXPECT_EQ(edge_kind(kinds[0], 0), edge_kind(kinds[1], 0)) << height;
    }
}

TEST(Edges, an_edge_of_one_triangle_is_open) {
    const auto kinds = kinds_with_neighbour({-2, 1, 0});
    EXPECT_EQ(edge_kind(kinds[0], 1), EdgeKind::open);
    EXPECT_EQ(edge_kind(kinds[0], 2), EdgeKind::open);
}

TEST(Edges, a_neighbour_folded_back_onto_the_triangle_is_a_blade) {
    EXPECT_EQ(edge_kind(kinds_with_neighbour({1, 0, 1})[0], 0), EdgeKind::convex);
}

TEST(Edges, flat_is_within_the_tolerance) {
    EXPECT_EQ(edge_kind(kinds_with_neighbour({-2, 0.01F, 0}, 0.001)[0], 0), EdgeKind::concave);
    EXPECT_EQ(edge_kind(kinds_with_neighbour({-2, 0.01F, 0}, 0.1)[0], 0), EdgeKind::flat);
}

TEST(Edges, an_edge_of_three_triangles_is_open_for_all_of_them) {
    const std::vector<vec3> vertices{{0, 0, 0}, {0, 0, 2}, {2, 0, 0}, {-2, 0, 0}, {0, 2, 0}};
    const Indices indices{0, 1, 2, 1, 0, 3, 0, 1, 4};
    for (const std::uint8_t kinds : edge_kinds(std::span<const vec3>(vertices), indices))
        EXPECT_EQ(edge_kind(kinds, 0), EdgeKind::open);
    EXPECT_EQ(match_edges(indices, vertices.size()).partner[0], EdgeMatches::many);
}

TEST(Edges, vertices_are_matched_by_place_and_not_by_index) {
    const std::vector<vec3> vertices{{0, 0, 0}, {0, 0, 2}, {2, 0, 0}, {0, 0, 2}, {-0.0F, 0, 0}, {-2, 1, 0}};
    const Indices indices{0, 1, 2, 3, 4, 5};
    EXPECT_EQ(edge_kind(edge_kinds(std::span<const vec3>(vertices), indices)[0], 0), EdgeKind::concave);
}

TEST(Edges, triangles_with_a_repeated_corner_share_nothing) {
    const Indices corners{0, 1, 2, 0, 1, 1, 1, 0, 3};
    const EdgeMatches matches = match_edges(corners, 4);
    EXPECT_EQ(matches.partner[0], 6U);
    EXPECT_EQ(matches.partner[6], 0U);
    for (std::size_t side = 3; side < 6; ++side) EXPECT_EQ(matches.partner[side], EdgeMatches::gone);
}

TEST(Edges, an_edge_to_a_triangle_without_area_is_open) {
    EXPECT_EQ(edge_kind(kinds_with_neighbour({0, 0, 1})[0], 0), EdgeKind::open);
    EXPECT_EQ(edge_kind(kinds_with_neighbour({0, 0, 1})[1], 0), EdgeKind::open);
}

}  // namespace
}  // namespace surefoot::internal
