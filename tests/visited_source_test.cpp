#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include <surefoot/visited_source.hpp>

#include "rounded.hpp"
#include "source_agreement.hpp"
#include "splitmix.hpp"

namespace surefoot {
namespace {

static_assert(TriangleSource<VisitedSource>);

/// Somebody's broad phase: a list.
struct Listed {
    std::vector<SourceTriangle> all{};
    mutable std::size_t handed_out = 0;
    bool hands_out_all = false;

    static Listed soup(std::uint64_t seed, int count) {
        tests::SplitMix random(seed);
        Listed list;
        for (int i = 0; i < count; ++i) {
            const dvec3 middle = random.point(10);
            const double size = i % 9 == 0 ? 4.0 : 0.6;
            SourceTriangle made;
            for (dvec3* corner : {&made.triangle.a, &made.triangle.b, &made.triangle.c}) {
                const dvec3 place = middle + random.point(size);
                *corner = {internal::rounded_to_float(place.x), internal::rounded_to_float(place.y),
                           internal::rounded_to_float(place.z)};
            }
            if (i % 11 == 0) made.triangle.c = made.triangle.b;
            made.id = static_cast<std::uint32_t>(7 * i);
            made.surface = static_cast<std::uint32_t>(i % 4);
            list.all.push_back(made);
        }
        return list;
    }

    Bounds bounds() const { return {dvec3(-14), dvec3(14)}; }
    void visit(const Bounds& near, const TriangleSink& sink) const {
        for (const SourceTriangle& one : all) {
            bool apart = false;
            for (int axis = 0; axis < 3; ++axis) {
                const auto [low, high] =
                    std::minmax({one.triangle.a[axis], one.triangle.b[axis], one.triangle.c[axis]});
                apart = apart || low > near.max[axis] || high < near.min[axis];
            }
            if (apart && !hands_out_all) continue;
            ++handed_out;
            sink(one.triangle, one.id, one.surface);
        }
    }
    const SourceTriangle& find(std::uint32_t id) const { return all[id / 7]; }
    Triangle triangle(std::uint32_t id) const { return find(id).triangle; }
    std::uint32_t surface(std::uint32_t id) const { return find(id).surface; }
};

TEST(VisitedSource, answers_every_query_bit_for_bit_like_a_mesh_of_its_triangles) {
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Listed list = Listed::soup(seed, 300);
        const auto same = tests::as_mesh(list.all);
        const VisitedSource source(list);
        tests::Agreement agreement(source, same, {dvec3(-14), dvec3(14)}, 0.5, seed);
        agreement.ask(1000);
        EXPECT_GT(agreement.met().sweep, 150);
        EXPECT_GT(agreement.met().ray, 50);
        EXPECT_GT(agreement.met().overlap, 20);
        EXPECT_GT(agreement.met().nearest, 300);
        EXPECT_GT(agreement.met().gather, 200);
    }
}

TEST(VisitedSource, a_long_sweep_looks_no_further_than_what_it_hits) {
    Listed list;
    for (int i = 0; i < 1000; ++i) {
        const double x = i * 0.1;
        list.all.push_back({{{x, -1, -1}, {x, 1, -1}, {x, 0, 1}}, static_cast<std::uint32_t>(7 * i), 0});
    }
    const VisitedSource source(list);
    QueryWork work;
    const auto hit = source.sweep(Sphere{0.25}, {{10.03, 0, -0.3}, {90, 0, -0.3}}, {.work = &work});
    ASSERT_TRUE(hit.has_value());
    EXPECT_LT(list.handed_out, 60U);
    EXPECT_LT(work.triangles, 40U);
}

TEST(VisitedSource, triangles_that_are_none_block) {
    Listed list = Listed::soup(4, 1);
    list.hands_out_all = true;
    list.all[0].triangle.b.y = std::numeric_limits<double>::quiet_NaN();
    const VisitedSource source(list);
    const auto hit = source.sweep(Sphere{}, {{-5, 0, 0}, {5, 0, 0}});
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->status, HitStatus::invalid);
    EXPECT_TRUE(source.sweep_any(Sphere{}, {{-5, 0, 0}, {5, 0, 0}}));
    const auto seen = source.ray({{-5, 0, 0}, {5, 0, 0}});
    ASSERT_TRUE(seen.has_value());
    EXPECT_EQ(seen->status, HitStatus::invalid);
}

}  // namespace
}  // namespace surefoot
