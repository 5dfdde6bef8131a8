#include <gtest/gtest.h>
#include <limits>
#include <vector>

#include <surefoot/height_field.hpp>
#include <surefoot/source.hpp>

#include "source_agreement.hpp"
#include "splitmix.hpp"

namespace surefoot {
namespace {

static_assert(TriangleSource<HeightField>);

/// Random terrain with everything that a field can have. Owns what an input points to.
struct Terrain {
    std::uint32_t columns;
    std::uint32_t rows;
    std::vector<float> heights{};
    std::vector<std::uint16_t> levels{};
    std::vector<std::uint8_t> quads{};
    std::vector<std::uint8_t> materials{};
    std::vector<std::uint32_t> surfaces{11, 0, 42};
    HeightFieldInput input{};

    Terrain(std::uint32_t c, std::uint32_t r, bool sixteen_bits, std::uint64_t seed) : columns(c), rows(r) {
        tests::SplitMix random(seed);
        for (std::uint32_t i = 0; i < c * r; ++i) {
            // Level ground in places: shapes rest on it, and its quads are flat boxes.
            const auto level = static_cast<std::uint16_t>(i % 5 == 0 ? 64 : random.next() % 192);
            if (sixteen_bits) {
                levels.push_back(level);
            } else {
                heights.push_back(static_cast<float>(level) + (i % 3 == 0 ? 0.3F : 0.0F));
            }
        }
        for (std::uint32_t i = 0; i < (c - 1) * (r - 1); ++i) {
            const bool hole = random.next() % 6 == 0;
            const bool flipped = random.next() % 3 == 0;
            quads.push_back(static_cast<std::uint8_t>((hole ? quad_hole : 0) | (flipped ? quad_flipped : 0)));
            materials.push_back(static_cast<std::uint8_t>(random.next() % 3));
            materials.push_back(static_cast<std::uint8_t>(random.next() % 3));
        }
        input = {.columns = c,
                 .rows = r,
                 .heights = heights,
                 .levels = levels,
                 .height_scale = 0x1p-6,
                 .quads = quads,
                 .materials = materials,
                 .surfaces = surfaces};
    }
};

std::vector<SourceTriangle> triangles_of(const HeightField& field) {
    std::vector<SourceTriangle> triangles;
    for (std::uint32_t id = 0; id < field.triangle_count(); ++id) {
        if (!field.is_hole(id)) triangles.push_back({field.triangle(id), id, field.surface(id)});
    }
    return triangles;
}

Bounds around(const HeightField& field, double margin) {
    return {field.bounds().min - dvec3(margin), field.bounds().max + dvec3(margin)};
}

TEST(HeightField, answers_every_query_bit_for_bit_like_a_mesh_of_its_triangles) {
    std::uint64_t seed = 1;
    for (const Diagonal diagonal : {Diagonal::rising, Diagonal::falling, Diagonal::alternating}) {
        for (const bool sixteen_bits : {true, false}) {
            Terrain terrain(23, 14, sixteen_bits, ++seed);
            terrain.input.diagonal = diagonal;
            terrain.input.origin = {-11, -1, -7};
            const auto field = HeightField::build(terrain.input);
            ASSERT_TRUE(field.has_value());
            const auto same = tests::as_mesh(triangles_of(*field));
            tests::Agreement agreement(*field, same, around(*field, 3), 1, seed);
            agreement.ask(700);
            EXPECT_GT(agreement.met().sweep, 300);
            EXPECT_GT(agreement.met().ray, 100);
            EXPECT_GT(agreement.met().overlap, 100);
            EXPECT_GT(agreement.met().nearest, 500);
            EXPECT_GT(agreement.met().gather, 200);
        }
    }
}

TEST(HeightField, answers_like_a_mesh_where_floats_round_its_grid) {
    Terrain terrain(17, 19, true, 9);
    terrain.input.cell_x = 0.1;
    terrain.input.cell_z = 0.07;
    terrain.input.height_scale = 0.003;
    terrain.input.origin = {5000.3, -70.1, -3000.7};
    const auto field = HeightField::build(terrain.input);
    ASSERT_TRUE(field.has_value());
    const auto same = tests::as_mesh(triangles_of(*field));
    tests::Agreement agreement(*field, same, around(*field, 0.3), 0.1, 10);
    agreement.ask(1000);
    EXPECT_GT(agreement.met().sweep, 300);
}

TEST(HeightField, of_one_row_of_quads_and_of_one_quad_answer_like_a_mesh) {
    for (const auto& [columns, rows] : {std::pair{200U, 2U}, std::pair{2U, 77U}, std::pair{2U, 2U}}) {
        Terrain terrain(columns, rows, false, columns);
        terrain.quads[0] = 0;
        const auto field = HeightField::build(terrain.input);
        ASSERT_TRUE(field.has_value());
        const auto same = tests::as_mesh(triangles_of(*field));
        tests::Agreement agreement(*field, same, around(*field, 2), 1, rows);
        agreement.ask(300);
        EXPECT_GT(agreement.met().sweep, 50);
    }
}

TEST(HeightField, after_a_change_answers_like_a_mesh_of_the_new_triangles) {
    Terrain terrain(19, 19, true, 21);
    auto field = HeightField::build(terrain.input);
    ASSERT_TRUE(field.has_value());
    const HeightField before = *field;
    tests::SplitMix random(22);
    for (int change = 0; change < 12; ++change) {
        const auto columns = static_cast<std::uint32_t>(1 + random.next() % 12);
        const auto rows = static_cast<std::uint32_t>(1 + random.next() % 12);
        // A mountain or a pit that the old pyramid knows nothing of.
        const std::vector<std::uint16_t> levels(columns * rows,
                                                change % 2 == 0 ? std::uint16_t{900} : std::uint16_t{0});
        const std::vector<std::uint8_t> quads((columns - 1) * (rows - 1),
                                              change % 3 == 0 ? quad_hole : std::uint8_t{0});
        const auto set = field->set({.column = static_cast<std::uint32_t>(random.next() % (20 - columns)),
                                     .row = static_cast<std::uint32_t>(random.next() % (20 - rows)),
                                     .columns = columns,
                                     .rows = rows,
                                     .levels = levels,
                                     .quads = quads});
        ASSERT_TRUE(set.has_value()) << set.error().text;
        const auto rebuilt = tests::as_mesh(triangles_of(*field));
        tests::Agreement agreement(*field, rebuilt, around(*field, 2), 1, 23);
        agreement.ask(40);
    }
    EXPECT_GT(field->bounds().max.y, 14);
    EXPECT_LT(before.bounds().max.y, 3) << "a copy is a field of its own";
}

TEST(HeightField, corners_are_floats_and_fronts_look_up) {
    Terrain terrain(6, 5, false, 3);
    terrain.input.origin = {0.1, 0.2, 0.3};
    terrain.input.cell_x = 0.7;
    const auto field = HeightField::build(terrain.input);
    ASSERT_TRUE(field.has_value());
    EXPECT_EQ(field->triangle_count(), 40U);
    EXPECT_EQ(field->triangle(0).a.x, static_cast<double>(0.1F));
    EXPECT_EQ(field->bounds().max.x, static_cast<double>(static_cast<float>(0.1 + 0.7 * 5)));
    EXPECT_EQ(field->bounds().max.z, static_cast<double>(static_cast<float>(0.3 + 4)));
    for (std::uint32_t id = 0; id < field->triangle_count(); ++id) {
        const Triangle t = field->triangle(id);
        EXPECT_GT((t.b.z - t.a.z) * (t.c.x - t.a.x) - (t.b.x - t.a.x) * (t.c.z - t.a.z), 0) << id;
    }
}

TEST(HeightField, cuts_each_quad_along_the_diagonal_that_it_says) {
    // One corner of each quad is up: whether its height is halved in the middle of the quad tells the diagonal.
    const std::vector<float> heights{0, 0, 0, 0, 1, 0, 0, 0, 0};
    const std::vector<std::uint8_t> quads{0, 0, 0, quad_flipped};
    const auto middle_height = [&](Diagonal diagonal, double x, double z) {
        const auto field =
            HeightField::build({.columns = 3, .rows = 3, .heights = heights, .diagonal = diagonal, .quads = quads});
        EXPECT_TRUE(field.has_value());
        const auto hit = field->ray({{x, 2, z}, {x, -2, z}});
        EXPECT_TRUE(hit.has_value());
        return hit->point.y;
    };
    EXPECT_EQ(middle_height(Diagonal::rising, 0.5, 0.5), 0.5);  // 00 to 11, which is up
    EXPECT_EQ(middle_height(Diagonal::rising, 1.5, 0.5), 0.0);  // 10 to 21, both down
    EXPECT_EQ(middle_height(Diagonal::falling, 0.5, 0.5), 0.0);
    EXPECT_EQ(middle_height(Diagonal::falling, 1.5, 0.5), 0.5);
    EXPECT_EQ(middle_height(Diagonal::alternating, 0.5, 0.5), 0.5);
    EXPECT_EQ(middle_height(Diagonal::alternating, 1.5, 0.5), 0.5);
    EXPECT_EQ(middle_height(Diagonal::rising, 1.5, 1.5), 0.0);  // flipped
    EXPECT_EQ(middle_height(Diagonal::falling, 1.5, 1.5), 0.5);
}

TEST(HeightField, a_long_motion_tests_few_triangles_and_ends_where_it_hits) {
    const std::uint32_t side = 257;
    std::vector<float> heights(side * side, 0.0F);
    for (std::uint32_t row = 0; row < side; ++row) heights[row * side + 200] = 5;  // a ridge across
    const auto field = HeightField::build({.columns = side, .rows = side, .heights = heights});
    ASSERT_TRUE(field.has_value());
    QueryWork work;
    const auto hit = field->sweep(Sphere{0.5}, {{2, 2, 100.3}, {250, 2, 120.7}}, {.work = &work});
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->point.x, 199.4, 0.5);
    EXPECT_LT(work.triangles, 40U);
    EXPECT_LT(work.nodes, 200U);
}

TEST(HeightField, refuses_what_it_cannot_use_in_words) {
    const std::vector<float> heights(9, 1.0F);
    const std::vector<std::uint16_t> levels(9);
    const auto says = [](const Expected<HeightField>& field, const char* words) {
        ASSERT_FALSE(field.has_value());
        EXPECT_NE(field.error().text.find(words), std::string::npos) << field.error().text;
    };
    says(HeightField::build({.columns = 1, .rows = 9, .heights = heights}), "2 columns");
    says(HeightField::build({.columns = 3, .rows = 3}), "heights or of levels");
    says(HeightField::build({.columns = 3, .rows = 3, .heights = heights, .levels = levels}), "heights or of levels");
    says(HeightField::build({.columns = 3, .rows = 4, .heights = heights}), "9 heights where 12");
    says(HeightField::build({.columns = 3, .rows = 3, .heights = heights, .cell_x = 0}), "along x");
    says(HeightField::build({.columns = 3, .rows = 3, .heights = heights, .cell_z = 0.001, .origin = {0, 0, 1e6}}),
         "along z");
    says(HeightField::build({.columns = 3, .rows = 3, .heights = heights, .origin = {0, 2e9, 0}}), "sample 0");
    says(HeightField::build({.columns = 3, .rows = 3, .heights = heights, .cell_x = std::nan("")}), "along x");
    std::vector<float> bad = heights;
    bad[5] = std::numeric_limits<float>::infinity();
    says(HeightField::build({.columns = 3, .rows = 3, .heights = bad}), "sample 5");
    const std::vector<std::uint8_t> materials{0, 1, 2, 0, 1, 2, 0, 3};
    const std::vector<std::uint32_t> surfaces{5, 6, 7};
    says(
        HeightField::build({.columns = 3, .rows = 3, .heights = heights, .materials = materials, .surfaces = surfaces}),
        "material 3");

    auto field = HeightField::build({.columns = 3, .rows = 3, .heights = heights});
    ASSERT_TRUE(field.has_value());
    EXPECT_FALSE(field->set({.column = 2, .row = 0, .columns = 2, .rows = 1, .heights = {heights.data(), 2}}));
    EXPECT_FALSE(field->set({.columns = 1, .rows = 1, .levels = {levels.data(), 1}}));
    EXPECT_FALSE(field->set({.columns = 2, .rows = 2, .quads = {materials.data(), 1}}));
    bad[0] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_FALSE(field->set({.columns = 1, .rows = 1, .heights = {bad.data(), 1}}));
    EXPECT_EQ(field->bounds().max.y, 1.0);
}

TEST(HeightField, of_16_bits_takes_three_bytes_a_triangle) {
    const Terrain terrain(257, 257, true, 5);
    const auto field = HeightField::build(terrain.input);
    ASSERT_TRUE(field.has_value());
    EXPECT_LT(static_cast<double>(field->bytes()) / field->triangle_count(), 3.0);
}

TEST(HeightField, an_invalid_query_is_blocked) {
    const Terrain terrain(5, 5, true, 5);
    const auto field = HeightField::build(terrain.input);
    ASSERT_TRUE(field.has_value());
    const auto hit = field->sweep(Sphere{0}, {{0, 9, 0}, {0, 8, 0}});
    ASSERT_TRUE(hit.has_value());
    EXPECT_EQ(hit->status, HitStatus::invalid);
    EXPECT_TRUE(field->sweep_any(Sphere{}, {{0, std::nan(""), 0}, {0, 8, 0}}));
}

}  // namespace
}  // namespace surefoot
