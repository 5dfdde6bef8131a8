#include <chrono>
#include <cmath>
#include <gtest/gtest.h>
#include <string>

#include <surefoot/import.hpp>

#include "obj_reader.hpp"

namespace surefoot {
namespace {

using internal::Placement;
using internal::ReadLimits;
using Indices = std::vector<std::uint32_t>;

Expected<ImportedLevel> read(const std::string& text, const Placement& placement = {}, const ReadLimits& limits = {}) {
    return internal::read_obj(text, placement, limits);
}

ImportedLevel good(const std::string& text, const Placement& placement = {}) {
    auto level = read(text, placement);
    EXPECT_TRUE(level.has_value()) << (level ? "" : level.error().text);
    return level ? *level : ImportedLevel{};
}

std::string refused(const std::string& text, ErrorCode code = ErrorCode::invalid) {
    const auto level = read(text);
    EXPECT_FALSE(level.has_value());
    if (level) return {};
    EXPECT_EQ(level.error().code, code);
    return level.error().text;
}

const std::string corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(ImportObj, a_triangle_is_read_as_it_is) {
    const ImportedLevel level = good(corner + "f 1 2 3\n");
    EXPECT_EQ(level.vertices, (std::vector<vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
    EXPECT_EQ(level.indices, (Indices{0, 1, 2}));
    EXPECT_EQ(level.surfaces, (Indices{0}));
    EXPECT_EQ(level.surface_names, (std::vector<std::string>{""}));
    ASSERT_EQ(level.parts.size(), 1u);
    EXPECT_EQ(level.parts[0].triangle_count, 1u);
}

// Each of these lies so close to the middle between two floats that a reader that rounds twice, or sums up digits in
// floating point, goes to the wrong one. The expected floats are written in hexadecimal.
TEST(ImportObj, coordinates_are_the_nearest_floats) {
    const ImportedLevel level = good(
        "v 1.00000005960464477539062499999999999 1.00000005960464477539062500000000001 1.000000059604644775390625\n"
        "v 16777217 16777219.0000000000000000001 -5.285142\n"
        "v +1.5e-3 1e-46 -1e-400\n"
        "v .5 5. 1e0\n"
        "f 1 2 3\n");
    EXPECT_EQ(level.vertices[0], vec3(0x1p0f, 0x1.000002p0f, 0x1p0f));
    EXPECT_EQ(level.vertices[1], vec3(16777216.0f, 16777220.0f, -0x1.523fc4p+2f));
    EXPECT_EQ(level.vertices[2], vec3(0x1.89374cp-10f, 0.0f, 0.0f));
    EXPECT_TRUE(std::signbit(level.vertices[2].z));
    EXPECT_EQ(level.vertices[3], vec3(0.5f, 5.0f, 1.0f));
}

TEST(ImportObj, corners_may_carry_texture_and_normal_and_count_backwards) {
    const ImportedLevel level = good(corner + "f 1/7 2//8 3/9/9\nf -3 -2 -1\nv 2 0 0\nf -4/-1 -3/-1 -1/-1\n");
    EXPECT_EQ(level.indices, (Indices{0, 1, 2, 0, 1, 2, 0, 1, 3}));
}

TEST(ImportObj, a_convex_polygon_becomes_a_fan_in_place) {
    const ImportedLevel level = good("v 0 0 0\nv 2 0 0\nv 3 1 0\nv 2 2 0\nv 0 2 0\nf 1 2 3\nf 1 2 3 4 5\nf 3 4 5\n");
    EXPECT_EQ(level.indices, (Indices{0, 1, 2, 0, 1, 2, 0, 2, 3, 0, 3, 4, 2, 3, 4}));
    EXPECT_EQ(level.notes.polygons_split, 1u);
    EXPECT_EQ(level.notes.polygons_concave, 0u);
}

double area(const ImportedLevel& level) {
    double sum = 0;
    for (std::size_t i = 0; i < level.indices.size(); i += 3) {
        const vec3 a = level.vertices[level.indices[i]];
        const vec3 b = level.vertices[level.indices[i + 1]];
        const vec3 c = level.vertices[level.indices[i + 2]];
        const double twice = (double{b.x} - a.x) * (double{c.y} - a.y) - (double{b.y} - a.y) * (double{c.x} - a.x);
        EXPECT_GE(twice, 0) << "triangle " << i / 3 << " is turned over";
        sum += twice / 2;
    }
    return sum;
}

TEST(ImportObj, a_concave_polygon_keeps_its_outline) {
    // An arrowhead whose fan from the first corner would cover the notch.
    const ImportedLevel level = good("v 4 0 0\nv 0 4 0\nv 1 0 0\nv 0 -4 0\nf 1 2 3 4\n");
    EXPECT_EQ(level.triangle_count(), 2u);
    EXPECT_DOUBLE_EQ(area(level), 12.0);
    const ImportedLevel notched = good("v 0 4 0\nv 1 0 0\nv 0 -4 0\nv 4 0 0\nf 1 2 3 4\n");
    EXPECT_DOUBLE_EQ(area(notched), 12.0);
    EXPECT_EQ(level.notes.polygons_concave + notched.notes.polygons_concave, 1u);
}

TEST(ImportObj, a_staircase_seen_from_the_side_keeps_its_steps) {
    const ImportedLevel level =
        good("v 0 0 0\nv 3 0 0\nv 3 3 0\nv 2 3 0\nv 2 2 0\nv 1 2 0\nv 1 1 0\nv 0 1 0\nf 8 1 2 3 4 5 6 7\n");
    EXPECT_EQ(level.triangle_count(), 6u);
    EXPECT_DOUBLE_EQ(area(level), 6.0);
    EXPECT_EQ(level.notes.polygons_crossed, 0u);
}

TEST(ImportObj, corners_in_a_row_stay_part_of_the_outline) {
    const ImportedLevel level = good("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4 5\n");
    EXPECT_EQ(level.triangle_count(), 3u);
    EXPECT_DOUBLE_EQ(area(level), 4.0);
    EXPECT_EQ(level.notes.degenerate_triangles, 1u);
}

TEST(ImportObj, a_polygon_that_crosses_itself_is_counted) {
    const ImportedLevel level = good("v 0 0 0\nv 2 2 0\nv 2 0 0\nv 0 3 0\nf 1 2 3 4\n");
    EXPECT_EQ(level.triangle_count(), 2u);
    EXPECT_EQ(level.notes.polygons_crossed + level.notes.polygons_concave, 1u);
}

TEST(ImportObj, degenerate_triangles_are_kept_with_their_ids) {
    const ImportedLevel level = good(corner + "v 2 0 0\nf 1 1 2\nf 1 2 4\nf 1 2 3\n");
    EXPECT_EQ(level.indices, (Indices{0, 0, 1, 0, 1, 3, 0, 1, 2}));
    EXPECT_EQ(level.notes.degenerate_triangles, 2u);
}

TEST(ImportObj, surfaces_are_numbered_by_first_use_and_zero_says_nothing) {
    const ImportedLevel level =
        good(corner + "f 1 2 3\nusemtl unused\nusemtl wet stone \nf 1 2 3\nusemtl ice\nf 1 2 3\n" +
             "usemtl wet stone\nf 1 2 3\nusemtl\nf 1 2 3\n");
    EXPECT_EQ(level.surface_names, (std::vector<std::string>{"", "wet stone", "ice"}));
    EXPECT_EQ(level.surfaces, (Indices{0, 1, 2, 1, 0}));
}

TEST(ImportObj, parts_follow_objects_and_groups_and_cover_all_triangles) {
    const ImportedLevel level = good(corner + "f 1 2 3\no house\ng door\nf 1 2 3\nf 1 2 3\ng roof\nf 1 2 3\ng empty\n");
    ASSERT_EQ(level.parts.size(), 3u);
    EXPECT_EQ(level.parts[0].name, "");
    EXPECT_EQ(level.parts[1].name, "door");
    EXPECT_EQ(level.parts[1].first_triangle, 1u);
    EXPECT_EQ(level.parts[1].triangle_count, 2u);
    EXPECT_EQ(level.parts[2].name, "roof");
}

TEST(ImportObj, points_lines_and_curves_are_skipped_and_counted) {
    const ImportedLevel level = good(corner + "p 1 2\nl 1 2 3\nf 1 2\nf 1\ncurv 0 1 1 2\nf 1 2 3\n");
    EXPECT_EQ(level.triangle_count(), 1u);
    EXPECT_EQ(level.notes.points_skipped, 3u);
    EXPECT_EQ(level.notes.lines_skipped, 2u);
    EXPECT_EQ(level.notes.curves_skipped, 1u);
}

TEST(ImportObj, lines_may_end_in_any_way_and_go_on_after_a_backslash) {
    const ImportedLevel level =
        good("\xef\xbb\xbf# from C:\\levels\\\nv 0 0 0\r\nv 1 \\\r\n 0 0\r\n\tv\t0 1 0 \nf 1 2 \\\n3 # last");
    EXPECT_EQ(level.indices, (Indices{0, 1, 2}));
    EXPECT_EQ(level.vertices[1], vec3(1, 0, 0));
}

TEST(ImportObj, colours_after_the_coordinates_do_no_harm) {
    EXPECT_EQ(good("v 1 2 3 0.5 0.5 0.5\nf 1 1 1\n").vertices[0], vec3(1, 2, 3));
}

TEST(ImportObj, axes_turn_exactly_and_stay_right_handed) {
    EXPECT_EQ(good("v 1 2 3\nf 1 1 1", {.up = UpAxis::y}).vertices[0], vec3(1, 2, 3));
    EXPECT_EQ(good("v 1 2 3\nf 1 1 1", {.up = UpAxis::z}).vertices[0], vec3(1, 3, -2));
    EXPECT_EQ(good("v 1 2 3\nf 1 1 1", {.up = UpAxis::x}).vertices[0], vec3(-2, 1, 3));
    EXPECT_EQ(good("v 1 2 3\nf 1 1 1", {.scale = 0.01}).vertices[0], vec3(0.01f, 0.02f, 0.03f));
}

TEST(ImportObj, an_error_names_the_line_and_the_byte) {
    const auto level = read("v 0 0 0\n# two\nv 1 \\\n 0 0\nv nan 0 0\n");
    ASSERT_FALSE(level.has_value());
    EXPECT_EQ(level.error().text.substr(0, 8), "line 5: ");
    EXPECT_EQ(level.error().byte, 25u);
}

TEST(ImportObj, coordinates_that_are_not_finite_are_refused) {
    for (const char* const bad : {"nan", "inf", "-inf", "1e39", "-1e400", "3.5e38"}) {
        EXPECT_NE(refused("v 0 0 " + std::string(bad) + "\nf 1 1 1\n").find("no finite float"), std::string::npos)
            << bad;
    }
    EXPECT_NE(read("v 0 0 3e38\nf 1 1 1\n", {.scale = 10}).error().text.find("scale"), std::string::npos);
}

TEST(ImportObj, what_is_no_number_is_refused) {
    for (const char* const bad :
         {"v 1 2\n", "v 1 2 x\n", "v 1 2 0x10\n", "v 1 2 3.4.5\n", "v 1,2 3 4\n", "v 1 2 --3\n", "v 1 2 +-3\n", "v"}) {
        EXPECT_EQ(refused(bad).substr(0, 8), "line 1: ") << bad;
    }
}

TEST(ImportObj, indices_out_of_range_are_refused) {
    for (const char* const bad :
         {"f 1 2 4", "f 0 1 2", "f -4 1 2", "f 1 2 99999999999999999999", "f 1 2 -9223372036854775808",
          "f 1 2 9223372036854775807", "f 1 2 3x", "f", "f /1 2 3", "f 1.0 2 3"}) {
        EXPECT_EQ(refused(corner + bad + "\n").substr(0, 8), "line 4: ") << bad;
    }
}

TEST(ImportObj, a_file_without_faces_is_refused_in_words) {
    EXPECT_NE(refused(corner).find("no face"), std::string::npos);
    EXPECT_NE(refused("\x7f"
                      "ELF whatever",
                      ErrorCode::unreadable)
                  .find("no Wavefront OBJ"),
              std::string::npos);
    refused("", ErrorCode::unreadable);
}

TEST(ImportObj, memory_is_limited) {
    std::string text = "v 0 0 0\n";
    for (int i = 0; i < 20'000; ++i) text += "f 1 1 1\n";
    const auto level = read(text, {}, {.bytes = 100'000});
    ASSERT_FALSE(level.has_value());
    EXPECT_EQ(level.error().code, ErrorCode::limit);
}

TEST(ImportObj, time_is_limited_even_within_one_polygon) {
    // A comb: every tooth is concave, so that ears are hard to find.
    std::string text;
    std::string face = "f";
    const int teeth = 20'000;
    for (int i = 0; i < teeth; ++i) {
        text.append("v ").append(std::to_string(i)).append(i % 2 == 0 ? " 0 0\n" : " 9 0\n");
        face.append(" ").append(std::to_string(i + 1));
    }
    text += "v 20000 -1 0\nv 0 -1 0\n";
    face += " 20001 20002\n";
    const auto begin = std::chrono::steady_clock::now();
    const auto level = read(text + face, {}, {.deadline = begin + std::chrono::milliseconds(50)});
    ASSERT_FALSE(level.has_value());
    EXPECT_EQ(level.error().code, ErrorCode::limit);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

}  // namespace
}  // namespace surefoot
