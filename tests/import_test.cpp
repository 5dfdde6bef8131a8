#include <chrono>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <string>
#include <sys/stat.h>

#include <surefoot/import.hpp>

#include "import_blend_file.hpp"
#include "import_files.hpp"

namespace surefoot {
namespace {

using test::corners;
using test::Folder;
using test::glb;
using test::gltf;
using test::gltf_buffer;
using test::good;
using test::refused;
using test::Vertices;
using Indices = std::vector<std::uint32_t>;

const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

TEST(Import, an_obj_becomes_a_mesh) {
    const Folder folder;
    const auto mesh = build_mesh(good(folder.write("level.obj", obj)));
    ASSERT_TRUE(mesh.has_value());
    EXPECT_EQ(mesh->triangle_count(), 1u);
    EXPECT_EQ(mesh->triangle(0).b, dvec3(1, 0, 0));
}

TEST(Import, names_may_hold_spaces_letters_of_any_language_and_capitals) {
    const Folder folder;
    EXPECT_EQ(good(folder.write("Mein Schloß 城.OBJ", obj)).triangle_count(), 1u);
    EXPECT_EQ(good(folder.write("Mein Schloß 城.GLB", glb(gltf(R"({"mesh":0})", "0"), gltf_buffer()))).triangle_count(),
              2u);
    EXPECT_EQ(good(folder.write("-x.glb", glb(gltf(R"({"mesh":0})", "0"), gltf_buffer()))).triangle_count(), 2u);
}

TEST(Import, an_ascii_ply_is_read_with_its_polygons_in_place_and_z_up) {
    const Folder folder;
    const ImportedLevel level =
        good(folder.write("level.ply",
                          "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float "
                          "y\nproperty float z\nelement face 2\nproperty list uchar int vertex_indices\n"
                          "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 2\n4 0 1 2 3\n3 0 1 3\n"));
    EXPECT_EQ(
        corners(level),
        (Vertices{
            {0, 0, 0}, {1, 0, 0}, {1, 0, -1}, {0, 0, 0}, {1, 0, -1}, {0, 2, -1}, {0, 0, 0}, {1, 0, 0}, {0, 2, -1}}));
    EXPECT_EQ(level.surface_names, (std::vector<std::string>{""}));
}

TEST(Import, a_binary_ply_is_read) {
    const Folder folder;
    std::string bytes =
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    for (const float f : {0.f, 0.f, 0.f, 0.1f, 0.f, 0.f, 0.f, 0.f, 0.3f}) test::append_bytes(bytes, f);
    bytes += '\3';
    for (const std::int32_t i : {0, 1, 2}) test::append_bytes(bytes, i);
    EXPECT_EQ(corners(good(folder.write("level.ply", bytes), {.up = UpAxis::y})),
              (Vertices{{0, 0, 0}, {0.1f, 0, 0}, {0, 0, 0.3f}}));
}

std::string binary_stl(std::uint32_t says, const std::vector<float>& floats) {
    std::string bytes(80, ' ');
    test::append_bytes(bytes, says);
    for (std::size_t i = 0; i < floats.size(); i += 9) {
        for (int k = 0; k < 3; ++k) test::append_bytes(bytes, 0.0f);
        for (std::size_t k = 0; k < 9; ++k) test::append_bytes(bytes, floats[i + k]);
        test::append_bytes(bytes, std::uint16_t{0});
    }
    return bytes;
}

TEST(Import, a_stl_is_read_in_both_forms_and_z_up) {
    const Folder folder;
    const Vertices expected{{0, 0, 0}, {1, 0, 0}, {0, 0.1f, -1}};
    EXPECT_EQ(corners(good(folder.write("binary.stl", binary_stl(1, {0, 0, 0, 1, 0, 0, 0, 1, 0.1f})))), expected);
    EXPECT_EQ(
        corners(good(folder.write("text.stl",
                                  "solid part\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
                                  "0.1\nendloop\nendfacet\nendsolid part\n"))),
        expected);
}

TEST(Import, an_ac_is_read_with_materials_and_places) {
    const Folder folder;
    const ImportedLevel level =
        good(folder.write("level.ac",
                          "AC3Db\nMATERIAL \"grass\" rgb 1 1 1 amb 0 0 0 emis 0 0 0 spec 0 0 0 shi 0 trans 0\n"
                          "MATERIAL \"stone\" rgb 1 1 1 amb 0 0 0 emis 0 0 0 spec 0 0 0 shi 0 trans 0\nOBJECT "
                          "world\nkids 1\nOBJECT poly\n"
                          "name \"floor\"\nloc 0 10 0\nnumvert 4\n0 0 0\n0 0 1\n1 0 1\n1 0 0\nnumsurf 1\nSURF 0x0\nmat "
                          "1\nrefs 4\n0 0 0\n1 0 0\n2 "
                          "0 0\n3 0 0\nkids 0\n"));
    EXPECT_EQ(corners(level), (Vertices{{0, 10, 0}, {0, 10, 1}, {1, 10, 1}, {0, 10, 0}, {1, 10, 1}, {1, 10, 0}}));
    ASSERT_EQ(level.surface_names.size(), 2u);
    EXPECT_EQ(level.surface_names[1], "stone");
}

TEST(Import, a_gltf_finds_its_buffer_beside_it) {
    const Folder folder;
    static_cast<void>(folder.write("a buffer.bin", gltf_buffer()));
    const ImportedLevel level =
        good(folder.write("level.gltf", gltf(R"({"name":"floor","mesh":0})", "0", "a%20buffer.bin")));
    EXPECT_EQ(corners(level), (Vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {0, 0, 1}}));
    EXPECT_EQ(level.surface_names, (std::vector<std::string>{"", "ice"}));
    EXPECT_EQ(level.surface_extras, (std::vector<std::string>{"", R"({"friction":0.05})"}));
    EXPECT_EQ(level.surfaces, (Indices{1, 1}));
    ASSERT_EQ(level.parts.size(), 1u);
    EXPECT_EQ(level.parts[0].name, "floor");
}

TEST(Import, nodes_of_a_glb_place_their_meshes_and_mirrors_keep_fronts_in_front) {
    const Folder folder;
    const std::string nodes =
        R"({"name":"there","translation":[10,0,0],"children":[1]},{"name":"mirrored","mesh":0,"scale":[-1,1,1]})";
    const ImportedLevel level = good(folder.write("level.glb", glb(gltf(nodes, "0"), gltf_buffer())));
    EXPECT_EQ(corners(level), (Vertices{{10, 0, 0}, {10, 1, 0}, {9, 0, 0}, {10, 0, 0}, {10, 0, 1}, {9, 0, 0}}));
}

TEST(Import, extras_become_markers_with_the_pose_of_their_node) {
    const Folder folder;
    const std::string nodes =
        R"({"name":"floor","mesh":0},)"
        R"({"name":"turned","rotation":[0,0.6,0,0.8],"translation":[1,2,3],"scale":[2,2,2],"children":[2]},)"
        R"({"name":"start","translation":[0,0,1],"extras":{"surefoot":{"kind":"spawn","order":3},"z":[1,[2,{"a":null}]],"a":"ö"}},)"
        R"({"name":"bare","translation":[0.1,0.2,0.3]},)"
        R"({"name":"lift","mesh":0,"extras":{"kind":"platform"}})";
    const std::string path = folder.write("level.glb", glb(gltf(nodes, "0,1,3,4"), gltf_buffer()));
    const ImportedLevel level = good(path);
    ASSERT_EQ(level.markers.size(), 3u);
    const ImportedMarker& start = level.markers[0];
    EXPECT_EQ(start.name, "start");
    EXPECT_EQ(start.kind, "spawn");
    EXPECT_EQ(start.extras, R"({"surefoot":{"kind":"spawn","order":3},"z":[1,[2,{"a":null}]],"a":"ö"})");
    // Turned by the angle whose half has cosine 0.8: its sine is 0.96 and its cosine 0.28.
    EXPECT_NEAR(start.position.x, 1 + 2 * 0.96, 1e-12);
    EXPECT_NEAR(start.position.y, 2, 1e-12);
    EXPECT_NEAR(start.position.z, 3 + 2 * 0.28, 1e-12);
    EXPECT_NEAR(start.orientation.w, 0.8, 1e-12);
    EXPECT_NEAR(start.orientation.y, 0.6, 1e-12);
    EXPECT_NEAR(start.scale.x, 2, 1e-12);
    EXPECT_EQ(level.markers[1].name, "bare");
    EXPECT_EQ(level.markers[1].position, dvec3(0.1, 0.2, 0.3));
    EXPECT_EQ(level.markers[1].extras, "");
    EXPECT_EQ(level.markers[2].name, "lift");
    EXPECT_EQ(level.markers[2].kind, "platform");

    const ImportedLevel small = good(path, {.scale = 0.5, .up = UpAxis::z});
    EXPECT_NEAR(small.markers[1].position.x, 0.05, 1e-15);
    EXPECT_NEAR(small.markers[1].position.y, 0.15, 1e-15);
    EXPECT_NEAR(small.markers[1].position.z, -0.1, 1e-15);
    EXPECT_NEAR(small.markers[0].orientation.z, -0.6, 1e-12);
    EXPECT_EQ(corners(small)[2], vec3(0, 0, -0.5f));
}

TEST(Import, an_old_blend_is_read_with_z_up) {
    const Folder folder;
    const ImportedLevel level = good(folder.write("level.blend", test::old_blend()));
    EXPECT_EQ(corners(level),
              (Vertices{{10, 30, -20}, {14, 30, -20}, {14, 30, -23}, {10, 30, -20}, {14, 30, -23}, {10, 30.5f, -23}}));
    EXPECT_EQ(level.surface_names, (std::vector<std::string>{"", "wood"}));
    ASSERT_EQ(level.parts.size(), 1u);
    EXPECT_EQ(level.parts[0].name, "floor");
    ASSERT_EQ(level.markers.size(), 1u);
    EXPECT_EQ(level.markers[0].name, "start");
    EXPECT_EQ(level.markers[0].position, dvec3(10, 30, -20));
}

TEST(Import, options_out_of_range_are_refused) {
    const Folder folder;
    const std::string path = folder.write("level.obj", obj);
    EXPECT_EQ(refused(path, {.scale = 0}).code, ErrorCode::invalid);
    EXPECT_EQ(refused(path, {.scale = std::nan("")}).code, ErrorCode::invalid);
    EXPECT_EQ(refused(path, {.scale = -1}).code, ErrorCode::invalid);
    EXPECT_EQ(refused(path, {.time_limit = 0}).code, ErrorCode::invalid);
    EXPECT_EQ(refused(path, {.time_limit = 1e300}).code, ErrorCode::invalid);
    EXPECT_EQ(refused(path, {.memory_limit = 1}).code, ErrorCode::invalid);
    EXPECT_EQ(refused(path, {.up = static_cast<UpAxis>(9)}).code, ErrorCode::invalid);
}

TEST(Import, what_is_no_readable_file_is_refused_in_words) {
    const Folder folder;
    EXPECT_EQ(refused((folder.path() / "missing.obj").string()).code, ErrorCode::not_found);
    EXPECT_EQ(refused(folder.path().string()).code, ErrorCode::not_found);
    EXPECT_EQ(refused("").code, ErrorCode::not_found);
    EXPECT_EQ(refused(folder.write("empty.glb", "")).code, ErrorCode::unreadable);
    EXPECT_EQ(refused(folder.write("level.xyz", "1 2 3")).code, ErrorCode::unsupported);
    EXPECT_EQ(refused(folder.write("level", "1 2 3")).code, ErrorCode::unsupported);
    const std::string pipe = (folder.path() / "pipe.glb").string();
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_EQ(refused(pipe).code, ErrorCode::unsupported);
}

TEST(Import, damaged_files_of_every_format_are_refused) {
    const Folder folder;
    const std::string whole = glb(gltf(R"({"mesh":0})", "0"), gltf_buffer());
    for (std::size_t n = 1; n < whole.size(); n += 37) refused(folder.write("cut.glb", whole.substr(0, n)));
    EXPECT_EQ(refused(folder.write("noise.gltf", "{\"asset\":")).code, ErrorCode::unreadable);
    EXPECT_EQ(refused(folder.write("old.gltf", R"({"asset":{"version":"1.0"}})")).code, ErrorCode::unreadable);
    EXPECT_EQ(refused(folder.write("noise.stl", "solid\nfacet")).code, ErrorCode::invalid);
    EXPECT_EQ(refused(folder.write("noise.ac", "AC3Db\nOBJECT poly\nnumvert 4000000000\n")).code,
              ErrorCode::unreadable);
    EXPECT_EQ(refused(folder.write("noise.blend", "BLENDERx")).code, ErrorCode::unreadable);
    EXPECT_EQ(refused(folder.write("short.blend", "BLENDER-v249")).code, ErrorCode::unreadable);
}

// Assimp 5.2 looks for ever for the end of such a header.
TEST(Import, a_ply_that_ends_within_its_header_is_refused_at_once) {
    const Folder folder;
    const std::string head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n";
    for (const char* const end : {"", "end_head", "end_header", "end_header\n", "comment end_header\n0 0 0\n"}) {
        EXPECT_EQ(refused(folder.write("cut.ply", head + end), {.time_limit = 20}).code, ErrorCode::unreadable) << end;
    }
}

TEST(Import, huge_counts_in_a_small_file_are_refused) {
    const Folder folder;
    refused(folder.write("huge.stl", binary_stl(0xffffffffu, {0, 0, 0, 1, 0, 0, 0, 1, 0})));
    std::string text = gltf(R"({"mesh":0})", "0");
    text.replace(text.find("\"count\":6"), 9, "\"count\":4000000000");
    refused(folder.write("huge.glb", glb(text, gltf_buffer())));
}

TEST(Import, vertices_that_are_not_finite_are_refused_with_their_place) {
    const Folder folder;
    std::string buffer = gltf_buffer();
    const float bad = std::nanf("");
    std::memcpy(buffer.data() + 12, &bad, sizeof bad);
    const Error error = refused(folder.write("nan.glb", glb(gltf(R"({"name":"hall","mesh":0})", "0"), buffer)));
    EXPECT_EQ(error.code, ErrorCode::invalid);
    EXPECT_NE(error.text.find("vertex 1"), std::string::npos) << error.text;
    EXPECT_NE(error.text.find("hall"), std::string::npos) << error.text;
}

TEST(Import, a_gltf_that_needs_more_than_is_read_here_is_refused_by_name) {
    const Folder folder;
    for (const std::string needs :
         {R"("extensionsRequired":["EXT_meshopt_compression"])", R"("extensionsUsed":["EXT_mesh_gpu_instancing"])"}) {
        const std::string text = gltf(R"({"mesh":0})", "0", {}, "," + needs);
        const Error error = refused(folder.write("needs.glb", glb(text, gltf_buffer())));
        EXPECT_EQ(error.code, ErrorCode::unsupported);
        EXPECT_NE(error.text.find("EXT_mesh"), std::string::npos);
    }
    const std::string harmless =
        R"(,"extensionsUsed":["KHR_materials_unlit"],"extensionsRequired":["KHR_materials_unlit"])";
    good(folder.write("unlit.glb", glb(gltf(R"({"mesh":0})", "0", {}, harmless), gltf_buffer())));
}

TEST(Import, a_gltf_whose_nodes_go_round_in_a_circle_does_no_harm) {
    const Folder folder;
    const std::string nodes =
        R"({"mesh":0},{"name":"a","extras":{},"children":[2]},{"name":"b","extras":{},"children":[1]})";
    static_cast<void>(import_level(folder.write("circle.glb", glb(gltf(nodes, "0,1"), gltf_buffer()))));
}

}  // namespace
}  // namespace surefoot
