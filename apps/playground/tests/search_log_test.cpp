#include "debugger/search_log.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "splitmix.hpp"

namespace surefoot::debugger {
namespace {

/// A hilly ground of 2 * side * side triangles.
Mesh hills(std::uint32_t side) {
    std::vector<vec3> vertices;
    std::vector<std::uint32_t> indices;
    tests::SplitMix random(1);
    for (std::uint32_t row = 0; row <= side; ++row)
        for (std::uint32_t column = 0; column <= side; ++column)
            vertices.push_back(
                {static_cast<float>(column), static_cast<float>(random.in(0, 0.7)), static_cast<float>(row)});
    for (std::uint32_t row = 0; row < side; ++row) {
        for (std::uint32_t column = 0; column < side; ++column) {
            const std::uint32_t a = row * (side + 1) + column;
            const std::uint32_t c = a + side + 1;
            for (const std::uint32_t index : {a, c, a + 1, a + 1, c, c + 1}) indices.push_back(index);
        }
    }
    return *Mesh::build({.vertices = vertices, .indices = indices});
}

TEST(SearchLog, tells_what_the_tree_spares) {
    const Mesh mesh = hills(40);
    const SearchComparison all = compare_searches(mesh, Ellipsoid{{0.4, 0.9, 0.4}}, {{3.3, 4, 5.1}, {34.2, -1, 30.7}});
    EXPECT_TRUE(all.same_answer) << all.text;
    ASSERT_TRUE(all.tree.hit);
    EXPECT_EQ(all.brute_force.triangles, mesh.triangle_count());
    EXPECT_LT(all.tree.triangles, 200U);
    EXPECT_LT(all.scalar_tree.triangles, 400U);
    EXPECT_GT(all.scalar_tree.boxes, 2U);
    EXPECT_GT(all.tree.seconds, 0);
    EXPECT_NE(all.text.find("The same answer"), std::string::npos);
}

TEST(SearchLog, has_the_steps_in_order_and_the_triangle_that_was_hit_among_them) {
    const Mesh mesh = hills(40);
    tests::SplitMix random(5);
    for (int i = 0; i < 50; ++i) {
        const Motion motion{dvec3(20, 5, 20) + random.point(15) * dvec3(1, 0, 1), dvec3(20, -1, 20) + random.point(15)};
        for (const Search search : {Search::tree, Search::scalar_tree, Search::brute_force}) {
            const SearchRun run = run_search(mesh, Ellipsoid{{0.4, 0.9, 0.4}}, motion, search, false, 1);
            std::size_t boxes = 0;
            std::size_t triangles = 0;
            bool met = false;
            for (const SearchStep& step : run.steps) {
                boxes += step.kind == SearchStep::Kind::box;
                triangles += step.kind == SearchStep::Kind::triangle;
                met = met || (step.kind == SearchStep::Kind::triangle && run.hit && step.triangle == run.hit->triangle);
            }
            EXPECT_EQ(run.untold, 0U);
            EXPECT_EQ(triangles, run.triangles);
            EXPECT_EQ(boxes, search == Search::scalar_tree ? run.boxes : 0U);
            EXPECT_EQ(met, run.hit.has_value());
        }
    }
}

}  // namespace
}  // namespace surefoot::debugger
