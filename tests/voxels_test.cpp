#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

#include <surefoot/pair.hpp>
#include <surefoot/source.hpp>
#include <surefoot/voxels.hpp>

#include "block_world.hpp"
#include "source_agreement.hpp"

namespace surefoot {
namespace {

static_assert(TriangleSource<Voxels>);

Bounds around(const Voxels& voxels, double margin) {
    return {voxels.bounds().min - dvec3(margin), voxels.bounds().max + dvec3(margin)};
}

TEST(Voxels, answer_every_query_bit_for_bit_like_a_mesh_of_their_triangles) {
    std::uint64_t seed = 1;
    for (const std::uint64_t full : {1U, 5U, 9U}) {
        for (const std::uint64_t partial : {0U, 2U, 5U}) {
            const VoxelWindow window{.first = {-6, -3, -4}, .cells = {12, 7, 9}, .boxes_per_block = 2};
            const tests::BlockWorld world(window, ++seed, full, partial);
            const auto voxels = Voxels::over(world, window);
            ASSERT_TRUE(voxels.has_value());
            const auto same = tests::as_mesh(world.triangles(false));
            tests::Agreement agreement(*voxels, same, around(*voxels, 2), 1, seed);
            agreement.ask(240);
            EXPECT_GT(agreement.met().sweep, 80);
            EXPECT_GT(agreement.met().ray, 30);
            EXPECT_GT(agreement.met().overlap, 50);
            EXPECT_GT(agreement.met().nearest, 100);
            EXPECT_GT(agreement.met().gather, 50);
        }
    }
}

TEST(Voxels, answer_like_a_mesh_where_floats_round_their_grid) {
    const VoxelWindow window{.first = {100, -3, 7},
                             .cells = {9, 8, 7},
                             .size = {0.1, 0.07, 0.13},
                             .origin = {3000.3, 70.7, -900.1},
                             .boxes_per_block = 3};
    const tests::BlockWorld world(window, 77, 3, 3);
    const auto voxels = Voxels::over(world, window);
    ASSERT_TRUE(voxels.has_value());
    const auto same = tests::as_mesh(world.triangles(false));
    tests::Agreement agreement(*voxels, same, around(*voxels, 0.2), 0.1, 78);
    agreement.ask(400);
    EXPECT_GT(agreement.met().sweep, 200);
}

TEST(Voxels, names_of_triangles_do_not_depend_on_what_is_there_and_lead_back_to_the_cell) {
    const VoxelWindow window{.first = {-6, -3, -4}, .cells = {12, 7, 9}, .boxes_per_block = 2};
    const tests::BlockWorld world(window, 5, 5, 5);
    const auto voxels = Voxels::over(world, window);
    ASSERT_TRUE(voxels.has_value());
    std::size_t seen = 0;
    for (const SourceTriangle& expected : world.triangles(true)) {
        const Triangle t = voxels->triangle(expected.id);
        EXPECT_EQ(t.a, expected.triangle.a);
        EXPECT_EQ(t.b, expected.triangle.b);
        EXPECT_EQ(t.c, expected.triangle.c);
        EXPECT_EQ(voxels->surface(expected.id), expected.surface);
        const Cell cell = voxels->cell(expected.id);
        const dvec3 middle = (t.a + t.c) * 0.5;
        EXPECT_LE(cell.x, middle.x);
        EXPECT_GE(cell.x + 1, middle.x);
        EXPECT_LE(cell.y, middle.y);
        EXPECT_GE(cell.y + 1, middle.y);
        ++seen;
    }
    EXPECT_GT(seen, 1000U);
}

TEST(Voxels, have_no_faces_between_blocks_that_cover_each_other) {
    const auto count = [](const auto& blocks) {
        const auto voxels = Voxels::over(blocks, {.cells = {2, 2, 2}, .boxes_per_block = 2});
        EXPECT_TRUE(voxels.has_value());
        return voxels->gather({{-1, -1, -1}, {3, 3, 3}}, {});
    };
    const auto at_bottom = [](const Block& left, const Block& right) {
        return [left, right](std::int32_t x, std::int32_t y, std::int32_t z) {
            return y == 0 && z == 0 ? (x == 0 ? left : right) : Block::empty();
        };
    };
    const Block slab = Block::of(tests::slab);
    EXPECT_EQ(count(at_bottom(Block::full(), Block::empty())), 12U);
    EXPECT_EQ(count(at_bottom(Block::full(), Block::full())), 20U);
    EXPECT_EQ(count(at_bottom(slab, slab)), 20U);
    EXPECT_EQ(count(at_bottom(slab, Block::full())), 22U) << "the full block's side is only half covered";
    EXPECT_EQ(count(at_bottom(Block::full(), Block::of(tests::post))), 24U) << "a post touches no side";
    EXPECT_EQ(count([](std::int32_t, std::int32_t, std::int32_t) { return true; }), 48U) << "none outside the window";
}

// From outside, a world with its hidden faces gives the same times: they are out of reach.
TEST(Voxels, lose_only_triangles_that_nobody_can_reach) {
    const VoxelWindow window{.cells = {8, 6, 8}, .boxes_per_block = 2};
    int hits = 0;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const tests::BlockWorld world(window, seed, 6, 5);
        const auto voxels = Voxels::over(world, window);
        ASSERT_TRUE(voxels.has_value());
        const auto all = tests::as_mesh(world.triangles(true));
        ASSERT_LT(voxels->gather(voxels->bounds(), {}), all.ids.size());
        const auto solids = world.solids();
        tests::SplitMix random(seed);
        for (int i = 0; i < 3000; ++i) {
            const dvec3 from = dvec3(4, 3, 4) + random.point(5);
            const dvec3 to = dvec3(4, 3, 4) + random.point(5);
            const Box box{{random.in(0.05, 0.4), random.in(0.05, 0.4), random.in(0.05, 0.4)}};
            const Volume volume = i % 2 == 0 ? Volume(box) : Volume(Ellipsoid{box.half_extents});
            const bool free = std::none_of(solids.begin(), solids.end(), [&](const tests::Solid& solid) {
                const Box block{(solid.max - solid.min) * 0.5};
                return pair_overlap(box, from, block, (solid.max + solid.min) * 0.5).has_value();
            });
            if (!free) continue;
            const auto with = all.mesh.sweep(volume, {from, to});
            const auto without = voxels->sweep(volume, {from, to});
            ASSERT_EQ(with.has_value(), without.has_value());
            if (!with) continue;
            EXPECT_NEAR(with->t, without->t, 1e-9);
            ++hits;
        }
    }
    EXPECT_GT(hits, 500);
}

TEST(Voxels, that_are_said_wrongly_block_instead_of_opening_a_hole) {
    static constexpr BlockBox inverted[] = {{{0, 0.9F, 0}, {1, 0.1F, 1}}};
    static constexpr BlockBox outside[] = {{{0, 0, 0}, {1, 1.5F, 1}}};
    static const BlockBox not_a_number[] = {{{0, 0, 0}, {1, std::nanf(""), 1}}};
    for (const Block& wrong :
         {Block::of(inverted), Block::of(outside), Block::of(not_a_number), Block::of(tests::stairs)}) {
        const auto blocks = [&](std::int32_t, std::int32_t y, std::int32_t) { return y == 0 ? wrong : Block::empty(); };
        const auto voxels = Voxels::over(blocks, {.cells = {3, 3, 3}});
        ASSERT_TRUE(voxels.has_value());
        const auto hit = voxels->ray({{1.3, 3, 1.4}, {1.3, -3, 1.4}});
        ASSERT_TRUE(hit.has_value());
        EXPECT_EQ(hit->point.y, 1.0) << "the whole cell";
    }
}

TEST(Voxels, a_long_motion_asks_only_about_the_blocks_on_its_way) {
    std::size_t asked = 0;
    const auto blocks = [&](std::int32_t x, std::int32_t, std::int32_t) {
        ++asked;
        return x == 300;
    };
    const auto voxels = Voxels::over(blocks, {.cells = {700, 700, 700}});
    ASSERT_TRUE(voxels.has_value());
    const auto hit = voxels->sweep(Sphere{0.4}, {{5.5, 100.3, 200.4}, {650.5, 200.3, 100.4}});
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->point.x, 300);
    EXPECT_LT(asked, 300U * 8);
    EXPECT_EQ(voxels->cell(hit->triangle).x, 300);
}

TEST(Voxels, refuse_what_they_cannot_number_or_place) {
    const auto all = [](std::int32_t, std::int32_t, std::int32_t) { return true; };
    const auto says = [&](const VoxelWindow& window, ErrorCode code, const char* words) {
        const auto voxels = Voxels::over(all, window);
        ASSERT_FALSE(voxels.has_value());
        EXPECT_EQ(voxels.error().code, code);
        EXPECT_NE(voxels.error().text.find(words), std::string::npos) << voxels.error().text;
    };
    says({.cells = {711, 711, 711}}, ErrorCode::limit, "32 bits");
    says({.cells = {100, 0, 100}}, ErrorCode::invalid, "along y");
    says({.first = {0, 0, 2147483600}, .cells = {100, 100, 100}}, ErrorCode::invalid, "along z");
    says({.size = {1, 1, 1e-3}, .origin = {0, 0, 1e6}}, ErrorCode::invalid, "along z");
    says({.size = {-1, 1, 1}}, ErrorCode::invalid, "along x");
    says({.origin = {0, std::nan(""), 0}}, ErrorCode::invalid, "along y");
    says({.boxes_per_block = 0}, ErrorCode::invalid, "boxes_per_block");
    says({.boxes_per_block = 65}, ErrorCode::invalid, "boxes_per_block");
    EXPECT_TRUE(Voxels::over(all, {.cells = {710, 710, 710}}).has_value());
}

}  // namespace
}  // namespace surefoot
