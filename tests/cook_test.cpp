// Cooking keeps what it is given, and says what is odd about it.
#include <algorithm>
#include <bit>
#include <gtest/gtest.h>

#include "file_things.hpp"

namespace surefoot::tests {
namespace {

Cooked cook_these(std::vector<dvec3> vertices, std::vector<std::uint32_t> indices, const CookOptions& options = {}) {
    return cooked({std::move(vertices), std::move(indices)}, options);
}

bool same_triangle(const Triangle& a, const Triangle& b) {
    return a.a == b.a && a.b == b.b && a.c == b.c;
}

TEST(Cook, triangles_keep_their_ids_and_their_corners) {
    const Level level = hills(30);
    const Cooked made = cooked(level);
    ASSERT_EQ(made.mesh.triangle_count(), 1800U);
    for (std::uint32_t id = 0; id < 1800; ++id) {
        const Triangle t = made.mesh.triangle(id);
        EXPECT_TRUE(same_triangle(t, {level.vertices[level.indices[3 * id]], level.vertices[level.indices[3 * id + 1]],
                                      level.vertices[level.indices[3 * id + 2]]}))
            << id;
    }
    EXPECT_EQ(made.report.vertices_moved, 0U);
    EXPECT_EQ(made.report.tiles, 1U);
}

TEST(Cook, a_cooked_mesh_answers_as_one_that_was_built) {
    const Level level = hills(30);
    const std::vector<vec3> vertices(level.vertices.begin(), level.vertices.end());
    const auto built = Mesh::build({.vertices = vertices, .indices = level.indices});
    ASSERT_TRUE(built.has_value());
    EXPECT_EQ(ask_everything(cooked(level).mesh, 3, 300), ask_everything(*built, 3, 300));
}

TEST(Cook, vertices_at_one_place_are_one_and_those_of_no_triangle_are_gone) {
    const Cooked made =
        cook_these({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 0}, {0, 0, 1}, {1, 0, 1}, {9, 9, 9}}, {0, 1, 2, 3, 4, 5});
    EXPECT_EQ(made.report.vertices_given, 7U);
    EXPECT_EQ(made.report.vertices_kept, 4U);
    EXPECT_EQ(made.report.vertices_unused, 1U);
    EXPECT_EQ(made.report.open_edges.count, 4U);
}

TEST(Cook, a_tolerance_closes_cracks_and_moves_nothing_farther_than_itself) {
    const std::vector<dvec3> vertices{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1.0009765625, 0, 0}, {0, 0, 1}, {1, 0, 1}};
    const std::vector<std::uint32_t> indices{0, 1, 2, 3, 4, 5};
    EXPECT_EQ(cook_these(vertices, indices).report.open_edges.count, 6U);
    const CookReport report = cook_these(vertices, indices, {.tolerance = 0.002}).report;
    EXPECT_EQ(report.open_edges.count, 4U);
    EXPECT_EQ(report.vertices_moved, 1U);
    EXPECT_DOUBLE_EQ(report.largest_move, 0.0009765625);
}

TEST(Cook, triangles_without_area_are_kept_and_told) {
    const Cooked made = cook_these({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, 2}}, {0, 1, 2, 0, 1, 3, 2, 2, 0});
    EXPECT_EQ(made.mesh.triangle_count(), 3U);
    ASSERT_EQ(made.report.degenerate.count, 2U);
    EXPECT_EQ(made.report.degenerate.places[0].triangle, 1U);
    EXPECT_EQ(made.report.degenerate.places[1].triangle, 2U);
}

TEST(Cook, edges_of_three_triangles_and_of_triangles_that_face_opposite_ways_are_told) {
    const Cooked fan =
        cook_these({{0, 0, 0}, {0, 0, 2}, {2, 0, 0}, {-2, 0, 0}, {0, 2, 0}}, {0, 1, 2, 1, 0, 3, 0, 1, 4});
    EXPECT_EQ(fan.report.non_manifold_edges.count, 3U);
    EXPECT_EQ(fan.report.non_manifold_edges.places[0].point, dvec3(0, 0, 1));
    const Cooked flipped = cook_these({{0, 0, 0}, {0, 0, 2}, {2, 0, 0}, {-2, 0, 0}}, {0, 1, 2, 0, 1, 3});
    EXPECT_EQ(flipped.report.flipped_edges.count, 1U);
    EXPECT_EQ(flipped.report.flipped_edges.places[0].triangle, 0U);
    EXPECT_EQ(cook_these({{0, 0, 0}, {0, 0, 2}, {2, 0, 0}, {-2, 0, 0}}, {0, 1, 2, 1, 0, 3}).report.flipped_edges.count,
              0U);
}

TEST(Cook, a_corner_on_the_edge_of_another_triangle_is_told_with_its_place) {
    // A large triangle on one side of x = 0, two small ones on the other, which meet in the middle of its edge.
    const Cooked made =
        cook_these({{0, 0, 0}, {0, 0, 2}, {-2, 0, 0}, {0, 0, 1}, {2, 0, 1}}, {0, 2, 1, 0, 3, 4, 3, 1, 4});
    ASSERT_EQ(made.report.t_junctions.count, 1U);
    EXPECT_EQ(made.report.t_junctions.places[0].triangle, 0U);
    EXPECT_EQ(made.report.t_junctions.places[0].point, dvec3(0, 0, 1));
    EXPECT_EQ(cooked(hills(10)).report.t_junctions.count, 0U);
}

TEST(Cook, every_t_junction_along_a_long_edge_is_found) {
    // A wall of one edge, 100 m long, beside a fan with a corner at every metre, not along an axis.
    Level level;
    const auto on_edge = [](double t) { return dvec3(t, 0.25 * t, -0.5 * t); };
    level.vertices = {on_edge(0), on_edge(100), {0, 50, 0}, {0, -60, 9}};
    level.indices = {0, 1, 2};
    for (std::uint32_t i = 1; i < 100; ++i) level.vertices.push_back(on_edge(i));
    const auto corner = [](std::uint32_t i) { return i == 0 ? 0U : i == 100 ? 1U : 3 + i; };
    for (std::uint32_t i = 0; i < 100; ++i)
        for (const std::uint32_t index : {corner(i + 1), corner(i), 3U}) level.indices.push_back(index);
    const CookReport report = cooked(level).report;
    EXPECT_EQ(report.t_junctions.count, 99U);
    EXPECT_EQ(report.t_junctions.places.size(), 32U);
    EXPECT_EQ(report.edges_unsearched, 0U);
}

TEST(Cook, the_report_and_the_notes_come_back_from_the_file) {
    Level level = hills(3);
    CookInput input = level.input();
    input.notes.surface_names = {"", "grass"};
    input.notes.surface_extras = {"", R"({"friction":0.5})"};
    input.notes.parts = {{"ground", 0, 18}};
    input.notes.markers = {{"start", "spawn", "{}", {1, 2, 3}, {0, 1, 0, 0}, {1, 1, 2}}};
    const auto made = cook(input, {.made_from = 99});
    ASSERT_TRUE(made.has_value());
    EXPECT_EQ(made->mesh.made_from(), 99U);
    const auto notes = level_notes(made->mesh);
    ASSERT_TRUE(notes.has_value());
    EXPECT_EQ(notes->surface_names, input.notes.surface_names);
    EXPECT_EQ(notes->surface_extras, input.notes.surface_extras);
    ASSERT_EQ(notes->parts.size(), 1U);
    EXPECT_EQ(notes->parts[0].name, "ground");
    ASSERT_EQ(notes->markers.size(), 1U);
    EXPECT_EQ(notes->markers[0].kind, "spawn");
    EXPECT_EQ(notes->markers[0].position, dvec3(1, 2, 3));
    EXPECT_EQ(notes->markers[0].orientation.x, 1);
    EXPECT_EQ(notes->markers[0].scale, dvec3(1, 1, 2));
    const auto report = cook_report(made->mesh);
    ASSERT_TRUE(report.has_value());
    EXPECT_EQ(report->open_edges.count, 12U);
    EXPECT_EQ(report->open_edges.places.size(), 12U);
    EXPECT_EQ(report->open_edges.places[3].point, made->report.open_edges.places[3].point);
}

TEST(Cook, edges_are_handed_out_with_their_kinds) {
    const Cooked made = cook_these({{0, 0, 0}, {0, 0, 2}, {2, 0, 0}, {-2, 1, 0}}, {0, 1, 2, 1, 0, 3});
    std::array<SourceTriangle, 2> found;
    ASSERT_EQ(made.mesh.gather({{-9, -9, -9}, {9, 9, 9}}, found), 2U);
    EXPECT_EQ(found[0].edges[0], EdgeKind::concave);
    EXPECT_EQ(found[0].edges[1], EdgeKind::open);
}

TEST(Cook, neighbouring_tiles_share_the_same_real_points) {
    const Level level = hills(64, 100.3, {-2500, 10, 70000});
    const Cooked made = cooked(level);
    EXPECT_GT(made.report.tiles, 30U);
    EXPECT_LE(made.report.largest_move, 0x1p-14);
    EXPECT_EQ(made.report.open_edges.count, 4U * 64U) << "tiles tear no edges apart";
    std::vector<dvec3> seen(level.vertices.size(), dvec3(-1, -1, -1));
    for (std::uint32_t id = 0; id < made.mesh.triangle_count(); ++id) {
        const Triangle t = made.mesh.triangle(id);
        std::uint32_t k = 0;
        for (const dvec3& corner : {t.a, t.b, t.c}) {
            const std::uint32_t index = level.indices[3 * id + k++];
            if (seen[index] == dvec3(-1, -1, -1)) seen[index] = corner;
            ASSERT_EQ(seen[index], corner) << "one vertex, one place, in every triangle";
            for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(corner[axis], level.vertices[index][axis], 0x1p-15);
        }
    }
    ask_everything(made.mesh, 5, 100);
}

TEST(Cook, a_ray_goes_through_no_seam_between_tiles) {
    const Level level = hills(40, 200.1, {-4000, 0, -4000});
    const Cooked made = cooked(level);
    ASSERT_GT(made.report.tiles, 1U);
    SplitMix random(2);
    for (int i = 0; i < 300; ++i) {
        // Along the seams, where a crack would be.
        const double seam = 1024 * static_cast<double>(random.next() % 7) - 3072 + 512;
        const double along = random.in(-3900, 3900);
        const dvec3 above = i % 2 == 0 ? dvec3(seam, 50, along) : dvec3(along, 50, seam);
        EXPECT_TRUE(made.mesh.ray({above, above - dvec3(0, 100, 0)}).has_value()) << above.x << " " << above.z;
    }
}

TEST(Cook, floats_stay_what_they_are_however_far_out) {
    const Cooked made = cook_these({{1e-30, 16777216, 0}, {0.25, -1e8, 3}, {9, 9, 9}}, {0, 1, 2});
    EXPECT_GT(made.report.largest_move, 0);  // 1e-30 is no float
    const std::vector<dvec3> floats{dvec3(vec3(1e-30F, 16777216, 0)), dvec3(vec3(0.1F, -1e8F, 3)), {9, 9, 9}};
    const Cooked kept = cook_these(floats, {0, 1, 2});
    EXPECT_EQ(kept.report.vertices_moved, 0U);
    EXPECT_EQ(kept.mesh.triangle(0).a, floats[0]);
    EXPECT_EQ(kept.mesh.triangle(0).b, floats[1]);
}

TEST(Cook, triangles_larger_than_a_tile_are_rounded_more_coarsely_but_together) {
    const Cooked made =
        cook_these({{0, 0, 0}, {0, 0, 50000.1}, {40000.3, 0, 0}, {40000.3, 0, 50000.1}, {40000.3, 0, -1.7}},
                   {0, 1, 2, 1, 3, 2, 2, 4, 0});
    const double coarse = 0x1p-8;
    EXPECT_LE(made.report.largest_move, coarse);
    EXPECT_EQ(made.mesh.triangle(0).c, made.mesh.triangle(1).c);
    EXPECT_EQ(made.mesh.triangle(0).c, made.mesh.triangle(2).a);
    EXPECT_EQ(made.report.open_edges.count, 5U);
}

TEST(Cook, a_level_far_from_the_origin_is_as_fine_as_one_at_it) {
    const Level level = hills(10, 0.5, {8388608, 0, -8388608});
    const Cooked made = cooked(level);
    EXPECT_LE(made.report.largest_move, 0x1p-14);
    const auto hit = made.mesh.ray({{8388609.1, 9, -8388606.9}, {8388609.1, -9, -8388606.9}});
    EXPECT_TRUE(hit.has_value());
}

TEST(Cook, the_number_of_threads_changes_nothing) {
    const Level level = hills(64, 30.1);
    const auto bytes_with = [&](int threads) {
        const Mesh mesh = cooked(level, {.threads = threads}).mesh;
        Bytes bytes;
        for (const Section& section : mesh.sections())
            bytes.insert(bytes.end(), section.bytes.begin(), section.bytes.end());
        return bytes;
    };
    EXPECT_EQ(bytes_with(1), bytes_with(2));
    EXPECT_EQ(bytes_with(1), bytes_with(7));
}

TEST(Cook, progress_begins_at_nothing_and_ends_at_all) {
    std::vector<double> told;
    const auto progress = [&](double done) { told.push_back(done); };
    cooked(hills(4), {.progress = progress});
    ASSERT_GE(told.size(), 2U);
    EXPECT_EQ(told.front(), 0);
    EXPECT_EQ(told.back(), 1);
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
}

TEST(Cook, bad_input_is_refused_in_words) {
    const std::vector<dvec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 0, std::numeric_limits<double>::quiet_NaN()}};
    const std::vector<std::uint32_t> indices{0, 1, 2};
    const std::vector<std::uint32_t> beyond{0, 1, 3};
    const std::vector<std::uint32_t> two{0, 1};
    const std::vector<dvec3> good{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    const auto code_of = [](const CookInput& input, const CookOptions& options = {}) {
        const auto result = cook(input, options);
        EXPECT_FALSE(result.has_value());
        return result ? ErrorCode::not_found : result.error().code;
    };
    EXPECT_EQ(code_of({.vertices = vertices, .indices = indices}), ErrorCode::invalid);
    EXPECT_EQ(code_of({.vertices = good, .indices = beyond}), ErrorCode::invalid);
    EXPECT_EQ(code_of({.vertices = good, .indices = two}), ErrorCode::invalid);
    EXPECT_EQ(code_of({.vertices = good, .indices = indices, .surfaces = two}), ErrorCode::invalid);
    EXPECT_EQ(code_of({.vertices = good, .indices = indices}, {.tolerance = -1}), ErrorCode::invalid);
    EXPECT_EQ(code_of({.vertices = good, .indices = indices}, {.threads = 0}), ErrorCode::invalid);
    EXPECT_TRUE(cook({.vertices = good, .indices = indices}).has_value());
    EXPECT_TRUE(cook({}).has_value());
}

}  // namespace
}  // namespace surefoot::tests
