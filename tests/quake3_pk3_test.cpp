// Maps within a .pk3.
#include <gtest/gtest.h>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <surefoot/import.hpp>

#include "import_files.hpp"
#include "quake3/pk3.hpp"
#include "quake3_map.hpp"
#include "splitmix.hpp"
#include "zipped.hpp"

namespace surefoot {
namespace {

using test::Folder;
using test::good;
using test::refused;
using test::zipped;

std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

const std::string sample = test::sample_map().bytes();

TEST(Quake3Pk3, the_only_map_needs_no_name) {
    const Folder folder;
    const std::string path =
        zipped(folder.path() / "pak0.pk3", {{"scripts/a.txt", "x"}, {"maps/Hall.bsp", sample}, {"maps/hall.aas", "y"}});
    const ImportedLevel packed = good(path);
    const ImportedLevel loose = good(folder.write("hall.bsp", sample));
    EXPECT_EQ(packed.vertices, loose.vertices);
    EXPECT_EQ(packed.indices, loose.indices);
    EXPECT_EQ(packed.markers.size(), loose.markers.size());
}

TEST(Quake3Pk3, one_of_several_is_named_behind_a_colon) {
    const Folder folder;
    test::MapWriter other;
    other.box(other.texture("clip", 0, test::player_clip), {0, 0, 0}, {32, 32, 32});
    const std::string path =
        zipped(folder.path() / "PAK0.PK3", {{"maps/hall.bsp", sample}, {"maps/box.bsp", other.bytes()}});
    for (const char* const name : {"maps/box.bsp", "box.bsp", "box", "Maps/BOX.bsp"})
        EXPECT_EQ(good(path + ":" + name).triangle_count(), 12u) << name;

    Error error = refused(path);
    EXPECT_EQ(error.code, ErrorCode::not_found);
    EXPECT_NE(error.text.find("maps/box.bsp\n  maps/hall.bsp"), std::string::npos) << error.text;
    error = refused(path + ":cellar");
    EXPECT_EQ(error.code, ErrorCode::not_found);
    EXPECT_NE(error.text.find("no map \"cellar\""), std::string::npos) << error.text;
    EXPECT_NE(error.text.find("maps/hall.bsp"), std::string::npos) << error.text;
}

TEST(Quake3Pk3, its_maps_are_listed_by_name_and_nothing_else_in_it) {
    const Folder folder;
    const std::string path = zipped(folder.path() / "Pak0.PK3", {{"maps/hall.bsp", "not read"},
                                                                 {"maps/box.bsp", sample},
                                                                 {"maps/box.aas", "y"},
                                                                 {"maps/old/attic.bsp", sample},
                                                                 {"scripts/box.bsp", sample}});
    const auto maps = maps_in(path);
    ASSERT_TRUE(maps) << maps.error().text;
    EXPECT_EQ(*maps, (std::vector<std::string>{"maps/box.bsp", "maps/hall.bsp"}));
    EXPECT_EQ(good(path + ":" + maps->front()).vertices, good(folder.write("box.bsp", sample)).vertices);

    const auto none = maps_in(zipped(folder.path() / "sounds.pk3", {{"sound/step.wav", "x"}}));
    ASSERT_TRUE(none) << none.error().text;
    EXPECT_TRUE(none->empty());
}

TEST(Quake3Pk3, only_a_pk3_holds_maps_and_one_that_cannot_be_read_says_why) {
    const Folder folder;
    const auto other = maps_in(folder.write("yard.obj", "v 0 0 0"));
    ASSERT_TRUE(other);
    EXPECT_TRUE(other->empty());
    const auto missing = maps_in(folder.path() / "none.pk3");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::not_found);
    EXPECT_NE(missing.error().text.find("none.pk3"), std::string::npos) << missing.error().text;
    const auto damaged = maps_in(folder.write("torn.pk3", "PK\3\4 and no more"));
    ASSERT_FALSE(damaged);
    EXPECT_EQ(damaged.error().code, ErrorCode::unreadable);
    const auto wrong = maps_in(folder.path() / "none.pk3", {.time_limit = -1});
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.error().code, ErrorCode::invalid);
}

TEST(Quake3Pk3, a_path_is_taken_apart_unless_there_is_such_a_file) {
    const Folder folder;
    EXPECT_EQ(level_path("a.pk3:maps/b.bsp").file, "a.pk3");
    EXPECT_EQ(level_path("a.pk3:maps/b.bsp").inside, "maps/b.bsp");
    EXPECT_EQ(level_path("C:\\a.bsp").file, "C:\\a.bsp");
    const std::string odd = folder.write("a.pk3:b.bsp", sample);
    EXPECT_EQ(level_path(odd).file, odd);
    EXPECT_EQ(good(odd).notes.patches, 2u);
}

TEST(Quake3Pk3, what_is_wrong_with_a_packed_map_names_it) {
    const Folder folder;
    std::string bad = sample;
    bad[4] = 1;
    const Error error = refused(zipped(folder.path() / "a.pk3", {{"maps/hall.bsp", bad}}));
    EXPECT_NE(error.text.find("a.pk3: maps/hall.bsp: byte 4: its version"), std::string::npos) << error.text;
    EXPECT_EQ(refused(zipped(folder.path() / "b.pk3", {{"readme.txt", "hello"}})).code, ErrorCode::not_found);
    EXPECT_EQ(refused(folder.write("c.pk3", "this is no zip")).code, ErrorCode::unreadable);
}

TEST(Quake3Pk3, a_zip_bomb_meets_the_limit_on_memory) {
    const Folder folder;
    const std::string path =
        zipped(folder.path() / "bomb.pk3", {{"maps/bomb.bsp", std::string(std::size_t{40} << 20, '\0')}});
    EXPECT_LT(bytes_of(path).size(), 100000u);
    EXPECT_EQ(refused(path, {.memory_limit = std::uint64_t{32} << 20}).code, ErrorCode::limit);
}

TEST(Quake3Pk3, damaged_zips_are_survived_and_a_damaged_map_is_never_read) {
    const Folder folder;
    const std::string whole =
        bytes_of(zipped(folder.path() / "a.pk3", {{"maps/hall.bsp", sample}, {"maps/two.bsp", sample}}));
    tests::SplitMix random(5);
    for (int round = 0; round < 3000; ++round) {
        std::string bytes = whole;
        const std::size_t bit = random.next() % (8 * bytes.size());
        bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
        std::istringstream file(bytes);
        const auto map = internal::quake3::read_pk3(file, "hall", {.bytes = std::uint64_t{1} << 24});
        if (map) {
            EXPECT_EQ(map->bytes, sample);
        } else {
            EXPECT_FALSE(map.error().text.empty());
        }
    }
    for (std::size_t n = 0; n < whole.size(); n += 11) {
        std::istringstream file(whole.substr(0, n));
        EXPECT_FALSE(internal::quake3::read_pk3(file, "hall", {}).has_value());
    }
}

}  // namespace
}  // namespace surefoot
