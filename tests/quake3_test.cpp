// Maps of Quake III: what of a map becomes what of a level.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>
#include <string>
#include <vector>

#include <surefoot/import.hpp>

#include "import_files.hpp"
#include "quake3_map.hpp"

namespace surefoot {
namespace {

using test::corners;
using test::Folder;
using test::good;
using test::MapWriter;
using test::refused;
using test::Vertices;

ImportedLevel level_of(const MapWriter& map, const ImportOptions& options = {}) {
    const Folder folder;
    return good(folder.write("level.bsp", map.bytes()), options);
}

const ImportedMarker& marker(const ImportedLevel& level, const std::string& name) {
    static const ImportedMarker none;
    const auto found = std::ranges::find(level.markers, name, &ImportedMarker::name);
    EXPECT_NE(found, level.markers.end()) << name;
    return found == level.markers.end() ? none : *found;
}

bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Clockwise when seen from above.
const std::vector<vec3> floor_corners{{0, 0, 32}, {0, 64, 32}, {64, 64, 32}, {64, 0, 32}};

TEST(Quake3, a_polygon_becomes_triangles_in_metres_with_y_up_and_fronts_counter_clockwise) {
    MapWriter map;
    map.polygon(map.texture("textures/test/stone", 0, test::solid), floor_corners, {0, 1, 2, 0, 2, 3});
    const ImportedLevel level = level_of(map);
    // 32 units are a metre; x stays, z becomes y, and y becomes -z.
    EXPECT_EQ(corners(level), (Vertices{{2, 1, -2}, {0, 1, -2}, {0, 1, 0}, {2, 1, 0}, {2, 1, -2}, {0, 1, 0}}));
    const auto mesh = build_mesh(level);
    ASSERT_TRUE(mesh.has_value());
    EXPECT_TRUE(mesh->ray({{1, 2, -1}, {1, 0, -1}}, {.one_sided = true}).has_value());
    EXPECT_FALSE(mesh->ray({{1, 0, -1}, {1, 2, -1}}, {.one_sided = true}).has_value());
}

TEST(Quake3, scale_and_up_can_be_chosen) {
    MapWriter map;
    map.polygon(map.texture("stone", 0, test::solid), floor_corners, {0, 1, 2});
    EXPECT_EQ(corners(level_of(map, {.scale = 1, .up = UpAxis::y})), (Vertices{{64, 64, 32}, {0, 64, 32}, {0, 0, 32}}));
}

TEST(Quake3, a_polygon_without_mesh_vertices_is_cut_like_any_other) {
    MapWriter map;
    map.polygon(map.texture("stone", 0, test::solid), floor_corners, {});
    const ImportedLevel level = level_of(map);
    EXPECT_EQ(level.triangle_count(), 2u);
    const auto mesh = build_mesh(level);
    EXPECT_TRUE(mesh->ray({{1, 2, -1}, {1, 0, -1}}, {.one_sided = true}).has_value());
}

TEST(Quake3, meshes_are_read_and_what_stops_nobody_is_left_out_and_counted) {
    MapWriter map;
    const std::uint32_t stone = map.texture("stone", 0, test::solid);
    const std::uint32_t water = map.texture("water", 0, test::water);
    map.polygon(water, floor_corners, {0, 1, 2, 0, 2, 3});
    map.mesh(stone, {{0, 0, 0}, {0, 32, 0}, {32, 0, 0}, {9, 9, 9}}, {0, 1, 2});
    map.flare();
    map.box(water, {0, 0, 0}, {64, 64, 64});
    const ImportedLevel level = level_of(map);
    EXPECT_EQ(corners(level), (Vertices{{1, 0, 0}, {0, 0, -1}, {0, 0, 0}}));
    EXPECT_EQ(level.notes.nonsolid_skipped, 1u);
    EXPECT_EQ(level.surface_names, (std::vector<std::string>{"", "stone"}));
    ASSERT_EQ(level.parts.size(), 1u);
    EXPECT_EQ(level.parts[0].name, "world meshes");
}

TEST(Quake3, flags_become_extras_of_surfaces) {
    MapWriter map;
    map.polygon(map.texture("ice", test::slick | 0x1000, test::solid | 0x8000000), floor_corners, {0, 1, 2});
    map.polygon(map.texture("ice", test::slick | 0x1000, test::solid), floor_corners, {0, 1, 2});
    map.polygon(map.texture("ice", 0, test::solid), floor_corners, {0, 1, 2});
    const ImportedLevel level = level_of(map);
    // Detail or structural is one surface; slick or not is two.
    EXPECT_EQ(level.surfaces, (std::vector<std::uint32_t>{1, 1, 2}));
    EXPECT_EQ(
        level.surface_extras[1],
        R"({"surefoot":{"friction":0,"slippery":1},"quake3":{"surface":["slick","metalsteps"],"contents":["solid"]}})");
    EXPECT_EQ(level.surface_extras[2], R"({"quake3":{"surface":[],"contents":["solid"]}})");
}

TEST(Quake3, invisible_brushes_that_stop_players_are_part_of_what_is_drawn) {
    MapWriter map;
    const std::uint32_t stone = map.texture("stone", 0, test::solid);
    const std::uint32_t clip = map.texture("clip", test::nodraw, test::player_clip);
    const std::uint32_t caulk = map.texture("caulk", test::nodraw, test::solid);
    map.polygon(stone, floor_corners, {0, 1, 2, 0, 2, 3});
    auto sides = MapWriter::box_sides(stone, {0, 0, 0}, {64, 64, 32});
    sides[0].texture = caulk;
    map.brush(stone, sides);
    map.box(clip, {100, 0, 0}, {101, 1, 1});
    map.box(map.texture("fog", test::nodraw, 0x40), {200, 0, 0}, {201, 1, 1});
    const ImportedLevel drawn = level_of(map);
    EXPECT_EQ(drawn.triangle_count(), 2u + 2u + 12u);
    EXPECT_EQ(drawn.notes.brushes, 2u);
    ASSERT_EQ(drawn.parts.size(), 2u);
    EXPECT_EQ(drawn.parts[0].name, "world polygons");
    EXPECT_EQ(drawn.parts[1].name, "world invisible brushes");
    const ImportedLevel brushes = level_of(map, {.quake3 = Quake3Solids::brushes});
    EXPECT_EQ(brushes.triangle_count(), 12u + 12u);
    ASSERT_EQ(brushes.parts.size(), 1u);
    EXPECT_EQ(brushes.parts[0].name, "world brushes");
}

TEST(Quake3, movers_stand_where_they_are_made_and_triggers_are_no_obstacles) {
    MapWriter map;
    const std::uint32_t stone = map.texture("stone", 0, test::solid);
    map.polygon(stone, floor_corners, {0, 1, 2});
    for (int i = 0; i < 4; ++i) {
        map.begin_model({0, 0, 0}, {32, 32, 32});
        map.mesh(stone, {{0, 0, 0}, {0, 32, 0}, {32, 0, 0}}, {0, 1, 2});
    }
    map.entities +=
        "{ classname func_train model *1 origin \"320 0 0\" }\n"
        "{ classname trigger_hurt model *2 }\n"
        "{ classname func_illusionary model *3 }\n";  // *4 is nobody's
    const ImportedLevel level = level_of(map);
    ASSERT_EQ(level.parts.size(), 2u);
    EXPECT_EQ(level.parts[1].name, "func_train *1 meshes");
    EXPECT_EQ(level.vertices[level.indices[3]], vec3(11, 0, 0));
    EXPECT_EQ(marker(level, "func_train").kind, "mover");
    EXPECT_EQ(marker(level, "func_train").position, dvec3(10.5, 0.5, -0.5));
    EXPECT_EQ(marker(level, "trigger_hurt").kind, "hurt");
    EXPECT_TRUE(holds(marker(level, "trigger_hurt").extras, R"("half_extents":[0.5,0.5,0.5])"));
}

TEST(Quake3, starts_stand_on_the_floor_and_look_the_right_way) {
    const ImportedLevel level = level_of(test::sample_map());
    const ImportedMarker& start = marker(level, "info_player_deathmatch");
    EXPECT_EQ(start.kind, "spawn");
    EXPECT_EQ(start.position, dvec3(0, 0, 0));
    // 90 degrees is the map's +y, which is -z here.
    const dvec3 front = start.orientation * dvec3(0, 0, 1);
    EXPECT_NEAR(glm::distance(front, dvec3(0, 0, -1)), 0, 1e-12);
    const dvec3 up = start.orientation * dvec3(0, 1, 0);
    EXPECT_NEAR(glm::distance(up, dvec3(0, 1, 0)), 0, 1e-12);
    EXPECT_EQ(
        start.extras,
        R"({"surefoot":{"kind":"spawn"},"quake3":{"classname":"info_player_deathmatch","origin":"0 0 24","angle":"90"}})");
}

TEST(Quake3, kinds_of_entities) {
    MapWriter map;
    map.polygon(map.texture("stone", 0, test::solid), floor_corners, {0, 1, 2});
    const std::vector<std::pair<std::string, std::string>> kinds{{"info_player_start", "spawn"},
                                                                 {"info_player_intermission", "view"},
                                                                 {"team_CTF_redspawn", "spawn"},
                                                                 {"team_CTF_blueflag", "item"},
                                                                 {"item_health", "item"},
                                                                 {"weapon_bfg", "item"},
                                                                 {"ammo_cells", "item"},
                                                                 {"holdable_medkit", "item"},
                                                                 {"misc_teleporter_dest", "destination"},
                                                                 {"trigger_teleport", "teleporter"},
                                                                 {"trigger_multiple", "trigger"},
                                                                 {"func_plat", "mover"},
                                                                 {"light", ""},
                                                                 {"target_position", ""}};
    for (const auto& [name, kind] : kinds) map.entities += "{ \"classname\" \"" + name + "\" }\n";
    const ImportedLevel level = level_of(map);
    ASSERT_EQ(level.markers.size(), kinds.size());
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        EXPECT_EQ(level.markers[i].name, kinds[i].first);
        EXPECT_EQ(level.markers[i].kind, kinds[i].second) << kinds[i].first;
    }
}

TEST(Quake3, a_jump_pad_says_how_it_throws) {
    const ImportedLevel level = level_of(test::sample_map());
    const ImportedMarker& pad = marker(level, "trigger_push");
    EXPECT_EQ(pad.kind, "jump_pad");
    EXPECT_EQ(pad.position, dvec3(0, 0.25, 0));
    // From (0, 0, 8) to (0, 256, 264): 8 m up and 8 m ahead under 25 m/s^2, which takes 0.8 s: 20 m/s up, 10 m/s ahead.
    EXPECT_TRUE(holds(pad.extras, R"("target":[0,8.25,-8])")) << pad.extras;
    EXPECT_TRUE(holds(pad.extras, R"("velocity":[0,20,-10],"gravity":25)")) << pad.extras;
}

TEST(Quake3, a_teleporter_says_where_to) {
    MapWriter map = test::sample_map();
    map.entities +=
        "{ classname trigger_teleport model *2 target there }\n"
        "{ classname misc_teleporter_dest targetname there origin \"32 64 24\" }\n";
    const ImportedLevel level = level_of(map);
    EXPECT_TRUE(holds(marker(level, "trigger_teleport").extras, R"("target":[1,0,-2])"))
        << marker(level, "trigger_teleport").extras;
    EXPECT_EQ(marker(level, "misc_teleporter_dest").position, dvec3(1, 0, -2));
}

TEST(Quake3, strange_letters_in_entities_are_sound_json) {
    MapWriter map = test::sample_map();
    map.entities += "{ classname info_null \"a\\b\" \"caf\xe9 \x01\" }\n";
    EXPECT_TRUE(holds(marker(level_of(map), "info_null").extras, R"("a\\b":"caf\u00e9 \u0001")"));
}

TEST(Quake3, numbers_that_are_none_count_as_zero_as_in_the_game) {
    MapWriter map = test::sample_map();
    map.entities += "{ classname info_notnull origin \"nan 1e99 32\" }{ classname info_camp origin \"64 here\" }";
    const ImportedLevel level = level_of(map);
    EXPECT_EQ(marker(level, "info_notnull").position, dvec3(0, 1, 0));
    EXPECT_EQ(marker(level, "info_camp").position, dvec3(2, 0, 0));
}

}  // namespace
}  // namespace surefoot
