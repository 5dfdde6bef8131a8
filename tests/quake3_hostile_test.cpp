// Maps that no compiler would make: an error that names the place and the cure, or a sound level, and never more.
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <span>
#include <string>

#include <surefoot/import.hpp>

#include "quake3/reader.hpp"
#include "quake3_map.hpp"
#include "splitmix.hpp"

namespace surefoot {
namespace {

using internal::ReadLimits;
using test::MapWriter;

Expected<ImportedLevel> read(const std::string& bytes, const internal::quake3::MapOptions& options = {},
                             ReadLimits limits = {.bytes = std::uint64_t{1} << 28}) {
    limits.deadline = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    return internal::quake3::read_bsp(std::as_bytes(std::span(bytes)), {.scale = 1.0 / 32, .up = UpAxis::z}, limits,
                                      options);
}

void expect_sound(const Expected<ImportedLevel>& level) {
    if (!level) {
        EXPECT_FALSE(level.error().text.empty());
        return;
    }
    ASSERT_EQ(level->indices.size(), 3 * level->surfaces.size());
    for (const std::uint32_t index : level->indices) ASSERT_LT(index, level->vertices.size());
    for (const std::uint32_t surface : level->surfaces) ASSERT_LT(surface, level->surface_names.size());
    for (const vec3& v : level->vertices) ASSERT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z));
    for (const ImportedMarker& marker : level->markers) ASSERT_TRUE(std::isfinite(marker.position.x));
}

Error error_of(const std::string& bytes, const internal::quake3::MapOptions& options = {}) {
    auto level = read(bytes, options);
    EXPECT_FALSE(level.has_value());
    return level ? Error{} : level.error();
}

void expect_text(const Error& error, ErrorCode code, std::initializer_list<const char*> parts) {
    EXPECT_EQ(error.code, code) << error.text;
    for (const char* const part : parts) EXPECT_NE(error.text.find(part), std::string::npos) << error.text;
}

/// Where a lump begins, as the header says.
std::uint32_t lump_at(const std::string& bytes, std::size_t lump) {
    std::uint32_t place = 0;
    std::memcpy(&place, bytes.data() + 8 + 8 * lump, 4);
    return place;
}

template <typename T>
std::string with(std::string bytes, std::size_t place, const T& value) {
    std::memcpy(bytes.data() + place, &value, sizeof value);
    return bytes;
}

const std::vector<vec3> square{{0, 0, 0}, {0, 64, 0}, {64, 64, 0}, {64, 0, 0}};

TEST(Quake3Hostile, the_sample_itself_is_read) {
    const auto level = read(test::sample_map().bytes());
    ASSERT_TRUE(level.has_value()) << level.error().text;
    EXPECT_EQ(level->notes.patches, 2u);
    EXPECT_EQ(level->notes.brushes, 2u);
}

TEST(Quake3Hostile, every_flipped_bit_of_the_header_is_survived) {
    const std::string whole = test::sample_map().bytes();
    for (std::size_t bit = 0; bit < 8 * MapWriter::header_size; ++bit) {
        std::string bytes = whole;
        bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
        expect_sound(read(bytes));
    }
}

TEST(Quake3Hostile, thousands_of_flipped_bits_of_the_body_are_survived) {
    const std::string whole = test::sample_map().bytes();
    tests::SplitMix random(3);
    for (int round = 0; round < 4000; ++round) {
        std::string bytes = whole;
        for (std::uint64_t n = 1 + random.next() % 4; n > 0; --n) {
            const std::size_t bit =
                8 * MapWriter::header_size + random.next() % (8 * (bytes.size() - MapWriter::header_size));
            bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
        }
        expect_sound(read(bytes, {.solids = round % 2 == 0 ? Quake3Solids::drawn : Quake3Solids::brushes}));
    }
}

TEST(Quake3Hostile, a_file_cut_anywhere_is_refused) {
    const std::string whole = test::sample_map().bytes();
    for (std::size_t n = 0; n < whole.size() - 104; n += 7) EXPECT_FALSE(read(whole.substr(0, n)).has_value()) << n;
}

TEST(Quake3Hostile, what_is_no_map_says_so) {
    const std::string whole = test::sample_map().bytes();
    expect_text(error_of("IBSP"), ErrorCode::unreadable, {"ends within its header"});
    expect_text(error_of(with(whole, 0, 'V')), ErrorCode::unreadable, {"does not begin with IBSP", ".glb"});
    const Error old = error_of(with(whole, 4, 47u));
    expect_text(old, ErrorCode::unsupported, {"47", "46"});
    EXPECT_EQ(old.byte, 4u);
}

TEST(Quake3Hostile, lumps_beyond_the_file_are_named) {
    const std::string whole = test::sample_map().bytes();
    for (const std::uint32_t offset : {0x7fffffffu, 0xffffffffu, static_cast<std::uint32_t>(whole.size())}) {
        const Error error = error_of(with(whole, 8 + 8 * 13, offset));
        expect_text(error, ErrorCode::unreadable, {"lump 13 (faces)", "at byte 112", "compile"});
        EXPECT_EQ(error.byte, 112u);
    }
    expect_text(error_of(with(whole, 12 + 8 * 2, 17u)), ErrorCode::unreadable, {"lump 2 (planes)", "multiple of 16"});
    expect_text(error_of(with(whole, 12 + 8 * 7, 0u)), ErrorCode::invalid, {"lump 7 (models)", "no world"});
}

TEST(Quake3Hostile, runs_and_indices_out_of_range_are_named) {
    const std::string whole = test::sample_map().bytes();
    const std::uint32_t faces = lump_at(whole, 13);
    const Error texture = error_of(with(whole, faces, 99u));
    expect_text(texture, ErrorCode::invalid, {"lump 13 (faces), face 0", "element 99 of lump 1 (textures)"});
    EXPECT_EQ(texture.byte, faces);
    expect_text(error_of(with(whole, faces + 12, 0xfffffff0u)), ErrorCode::invalid, {"lump 10 (vertices)"});
    expect_text(error_of(with(whole, faces + 8, 9u)), ErrorCode::invalid, {"type is 9"});
    expect_text(error_of(with(whole, faces + 24, 4u)), ErrorCode::invalid, {"no multiple of 3"});
    expect_text(error_of(with(whole, lump_at(whole, 7) + 28, 0x80000000u)), ErrorCode::invalid,
                {"lump 7 (models), model 0"});
    expect_text(error_of(with(whole, lump_at(whole, 8) + 4, 0xffffffffu)), ErrorCode::invalid,
                {"lump 8 (brushes), brush 0"});
    expect_text(error_of(with(whole, lump_at(whole, 9), 0xffffffffu)), ErrorCode::invalid,
                {"lump 9 (brush sides), side 0"});
    expect_text(error_of(with(whole, lump_at(whole, 11), 4u)), ErrorCode::invalid,
                {"lump 11 (mesh vertices)", "face 0", "its vertex 4"});
}

TEST(Quake3Hostile, patches_of_impossible_sizes_are_named) {
    const std::string whole = test::sample_map().bytes();
    const std::uint32_t patch = lump_at(whole, 13) + 4 * 104;
    for (const std::uint32_t width : {0u, 1u, 2u, 4u, 9u, 0x10001u, 0xffffffffu}) {
        expect_text(error_of(with(whole, patch + 96, width)), ErrorCode::invalid,
                    {"face 4", "odd numbers of control points"});
    }
}

TEST(Quake3Hostile, places_that_are_not_finite_are_named) {
    const std::string whole = test::sample_map().bytes();
    const float nan = std::numeric_limits<float>::quiet_NaN();
    expect_text(error_of(with(whole, lump_at(whole, 10) + 44, nan)), ErrorCode::invalid,
                {"lump 10 (vertices), vertex 1"});
    expect_text(error_of(with(whole, lump_at(whole, 10) + 44 * 11, nan)), ErrorCode::invalid,
                {"lump 10 (vertices), vertex 11"});
    expect_text(error_of(with(whole, lump_at(whole, 2) + 12, nan)), ErrorCode::invalid, {"lump 2 (planes), plane 0"});
    expect_text(error_of(with(whole, lump_at(whole, 2), 7.0f)), ErrorCode::invalid, {"normal has the length 7"});
}

TEST(Quake3Hostile, a_brush_without_end_is_named_and_one_without_space_is_counted) {
    MapWriter map = test::sample_map();
    const std::uint32_t clip = map.texture("clip", 0, test::player_clip);
    map.begin_model();
    map.box(clip, {0, 0, 0}, {-8, 8, 8});
    map.entities += "{ classname func_wall model *3 }";
    const auto level = read(map.bytes());
    ASSERT_TRUE(level.has_value());
    EXPECT_EQ(level->notes.brushes_empty, 1u);

    auto sides = MapWriter::box_sides(clip, {0, 0, 0}, {8, 8, 8});
    sides.pop_back();
    map.brush(clip, sides);
    expect_text(error_of(map.bytes()), ErrorCode::invalid,
                {"lump 8 (brushes), brush 6", "no bounded space", "delete it"});
    sides.assign(2000, sides[0]);
    MapWriter many;
    const std::uint32_t only = many.texture("clip", 0, test::player_clip);
    for (MapWriter::Side& side : sides) side.texture = only;
    many.brush(only, sides);
    expect_text(error_of(many.bytes()), ErrorCode::invalid, {"2000 sides", "1024"});
}

TEST(Quake3Hostile, damaged_entities_are_named_by_byte) {
    for (const char* const text : {"{ \"classname", "{ classname }", "worldspawn", "{ { } }", "{ a b", "}"}) {
        MapWriter map = test::sample_map();
        map.entities = text;
        expect_text(error_of(map.bytes()), ErrorCode::invalid, {"lump 0 (entities), byte 1"});
    }
}

TEST(Quake3Hostile, a_map_in_which_nothing_stops_a_player_is_refused) {
    MapWriter map;
    map.polygon(map.texture("water", 0, test::water), square, {0, 1, 2});
    expect_text(error_of(map.bytes()), ErrorCode::invalid, {"nothing in the map stops a player"});
}

TEST(Quake3Hostile, curves_that_ask_for_too_many_triangles_are_refused_with_the_cure) {
    expect_text(error_of(test::sample_map().bytes(), {.tolerance = 1e-6}), ErrorCode::limit,
                {"face 4", "1024 pieces", "tolerance"});
    // One patch of nearly a million triangles, a hundred times over.
    MapWriter map;
    const std::uint32_t stone = map.texture("stone", 0, test::solid);
    map.patch(stone, 3, 3,
              {{0, 0, 0},
               {64, 0, 9000},
               {128, 0, 0},
               {0, 64, 9000},
               {64, 64, 0},
               {128, 64, 9000},
               {0, 128, 0},
               {64, 128, 9000},
               {128, 128, 0}});
    for (int i = 0; i < 100; ++i) map.raw_face({stone, 0, 2, 0, 9, 0, 0}, 3, 3);
    expect_text(error_of(map.bytes(), {.tolerance = 0.001}), ErrorCode::limit, {"16 million", "tolerance"});
}

/// Small files whose parts are used again and again.
TEST(Quake3Hostile, bombs_meet_the_limits_on_memory_and_work) {
    MapWriter map;
    const std::uint32_t stone = map.texture("stone", 0, test::solid);
    map.mesh(stone, std::vector<vec3>(3000, vec3(1, 2, 3)), std::vector<std::uint32_t>(9000, 1));
    for (int i = 0; i < 100000; ++i) map.raw_face({stone, 0, 3, 0, 3000, 0, 9000}, 0, 0);
    auto level = read(map.bytes(), {}, {.bytes = std::uint64_t{1} << 24});
    ASSERT_FALSE(level.has_value());
    expect_text(level.error(), ErrorCode::limit, {"memory"});

    MapWriter patches;
    patches.patch(patches.texture("stone", 0, test::solid), 99, 99, std::vector<vec3>(9801, vec3(1, 2, 3)));
    for (int i = 0; i < 100000; ++i) patches.raw_face({0, 0, 2, 0, 9801, 0, 0}, 99, 99);
    expect_text(error_of(patches.bytes()), ErrorCode::limit, {"control points"});
}

}  // namespace
}  // namespace surefoot
