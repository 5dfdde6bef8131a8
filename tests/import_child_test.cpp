// The limits around the reader: other programs stand in its place, and Blender works for it.
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <surefoot/import.hpp>

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

class ImportChild : public testing::Test {
protected:
    Error run(const std::string& script, ImportOptions options = {}) {
        options.importer = folder_.write_program("reader", script);
        return refused(level_, options);
    }

    Folder folder_;
    std::string level_ = folder_.write("level.glb", glb(gltf(R"({"mesh":0})", "0"), gltf_buffer()));
};

TEST_F(ImportChild, a_crash_becomes_an_error) {
    const Error error = run("kill -SEGV $$");
    EXPECT_EQ(error.code, ErrorCode::unreadable);
    EXPECT_NE(error.text.find("crashed (Segmentation fault)"), std::string::npos) << error.text;
}

TEST_F(ImportChild, a_hang_becomes_an_error_and_leaves_nothing_running) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_EQ(run("sleep 1000 & sleep 1000", {.time_limit = 0.3}).code, ErrorCode::limit);
    EXPECT_EQ(run("exec >&-; sleep 1000", {.time_limit = 0.3}).code, ErrorCode::limit);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20));
}

TEST_F(ImportChild, endless_output_becomes_an_error) {
    EXPECT_EQ(run("cat /dev/zero", {.memory_limit = std::uint64_t{16} << 20}).code, ErrorCode::limit);
}

TEST_F(ImportChild, an_answer_that_makes_no_sense_becomes_an_error) {
    EXPECT_EQ(run("echo hello").code, ErrorCode::unreadable);
    EXPECT_EQ(run("exit 7").code, ErrorCode::unreadable);
    EXPECT_EQ(run("printf surefoot-reply-1").code, ErrorCode::unreadable);
}

TEST_F(ImportChild, memory_is_limited) {
    std::string buffer = gltf_buffer();
    // 40,000 nodes share one mesh of 30,000 triangles: a small file, 43 GB of level.
    std::string nodes = R"({"mesh":0})";
    std::string roots = "0";
    for (int i = 1; i < 40'000; ++i) {
        nodes += R"(,{"mesh":0})";
        roots.append(",").append(std::to_string(i));
    }
    std::string text = gltf(nodes, roots);
    text.replace(text.find("\"count\":6"), 9, "\"count\":90000");
    text.replace(text.find("\"byteOffset\":48,\"byteLength\":12"), 31, "\"byteOffset\":48,\"byteLength\":180000");
    text.replace(text.find("\"byteLength\":60"), 15, "\"byteLength\":180048");
    buffer.resize(48 + 180'000);
    const std::string bomb = folder_.write("bomb.glb", glb(text, buffer));
    const Error error = refused(bomb, {.memory_limit = std::uint64_t{256} << 20});
    EXPECT_EQ(error.code, ErrorCode::limit) << error.text;
    EXPECT_NE(error.text.find("memory_limit"), std::string::npos) << error.text;
}

TEST_F(ImportChild, a_missing_helper_is_named_with_the_cure) {
    const Error error = refused(level_, {.importer = "/nowhere/surefoot-importer"});
    EXPECT_EQ(error.code, ErrorCode::unsupported);
    EXPECT_NE(error.text.find("/nowhere/surefoot-importer"), std::string::npos);
    ASSERT_EQ(setenv("SUREFOOT_IMPORTER", "/nowhere/else", 1), 0);
    const Error from_environment = refused(level_);
    unsetenv("SUREFOOT_IMPORTER");
    EXPECT_EQ(from_environment.code, ErrorCode::unsupported);
    EXPECT_NE(from_environment.text.find("SUREFOOT_IMPORTER"), std::string::npos);
}

TEST_F(ImportChild, a_current_blend_without_blender_says_what_to_install) {
    ASSERT_EQ(setenv("SUREFOOT_BLENDER", "/nowhere/blender", 1), 0);
    const Error plain = refused(folder_.write("new.blend", "BLENDER-v304REND"));
    const Error packed = refused(folder_.write("packed.blend", "\x28\xb5\x2f\xfd and so on"));
    unsetenv("SUREFOOT_BLENDER");
    EXPECT_EQ(plain.code, ErrorCode::unsupported);
    EXPECT_EQ(packed.code, ErrorCode::unsupported);
    EXPECT_NE(plain.text.find(".glb"), std::string::npos);
}

TEST_F(ImportChild, a_program_that_ignores_the_end_of_its_children_can_import) {
    const auto before = std::signal(SIGCHLD, SIG_IGN);
    const ImportedLevel level = good(level_);
    std::signal(SIGCHLD, before);
    EXPECT_EQ(level.triangle_count(), 2u);
}

TEST_F(ImportChild, many_threads_may_import_at_once) {
    std::array<std::size_t, 8> triangles{};
    std::vector<std::thread> threads;
    for (std::size_t& count : triangles) {
        threads.emplace_back([&count, this] {
            const auto level = import_level(level_);
            count = level ? level->triangle_count() : 0;
        });
    }
    for (std::thread& thread : threads) thread.join();
    for (const std::size_t count : triangles) EXPECT_EQ(count, 2u);
}

/// A .blend as the installed Blender writes it, plain and packed: a floor 2 m up with the material "wood", and a spawn.
class ImportBlender : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder = std::make_unique<Folder>();
        const std::string script = folder->write("make.py", R"py(
import bpy, numpy, sys
bpy.ops.wm.read_factory_settings(use_empty=True)
mesh = bpy.data.meshes.new('floor')
mesh.from_pydata([(0, 0, 2), (4, 0, 2), (4, 3, 2), (0, 3, 2)], [], [(0, 1, 2, 3)])
mesh.materials.append(bpy.data.materials.new('wood'))
bpy.context.scene.collection.objects.link(bpy.data.objects.new('floor', mesh))
start = bpy.data.objects.new('start', None)
start.location = (1, 2, 3)
start['surefoot'] = {'kind': 'spawn', 'order': [1, 2]}
bpy.context.scene.collection.objects.link(start)
text = bpy.data.texts.new('bad.py')
text.write("open('" + sys.argv[-1] + ".ran', 'w')")
text.use_module = True
bpy.ops.wm.save_as_mainfile(filepath=sys.argv[-2])
bpy.ops.wm.save_as_mainfile(filepath=sys.argv[-1], compress=True)
)py");
        const std::string command = "blender -b --factory-startup --python-exit-code 4 -P '" + script + "' -- '" +
                                    plain() + "' '" + packed() + "' >/dev/null 2>&1";
        available = std::system(command.c_str()) == 0;
    }

    static void TearDownTestSuite() { folder.reset(); }

    void SetUp() override {
        if (!available)
            GTEST_SKIP() << "Blender and its glTF exporter (Debian: blender python3-numpy) are not installed";
    }

    static std::string plain() { return (folder->path() / "my level.blend").string(); }
    static std::string packed() { return (folder->path() / "packed.blend").string(); }

    static inline std::unique_ptr<Folder> folder;
    static inline bool available = false;
};

TEST_F(ImportBlender, reads_a_packed_file_and_runs_none_of_its_scripts) {
    const ImportedLevel level = good(packed());
    EXPECT_EQ(corners(level), (Vertices{{0, 2, 0}, {4, 2, 0}, {4, 2, -3}, {0, 2, 0}, {4, 2, -3}, {0, 2, -3}}));
    EXPECT_EQ(level.surface_names, (std::vector<std::string>{"", "wood"}));
    ASSERT_EQ(level.markers.size(), 1u);
    EXPECT_EQ(level.markers[0].kind, "spawn");
    EXPECT_EQ(level.markers[0].position, dvec3(1, 3, -2));
    EXPECT_EQ(level.markers[0].extras, R"({"surefoot":{"kind":"spawn","order":[1,2]}})");
    EXPECT_FALSE(std::filesystem::exists(packed() + ".ran"));
}

TEST_F(ImportBlender, reads_a_plain_file_in_the_axes_it_is_told) {
    EXPECT_EQ(corners(good(plain(), {.up = UpAxis::y}))[2], vec3(4, 3, 2));
}

TEST_F(ImportBlender, out_of_time_is_an_error) {
    EXPECT_EQ(refused(plain(), {.time_limit = 0.1}).code, ErrorCode::limit);
}

TEST_F(ImportBlender, a_damaged_file_is_an_error) {
    EXPECT_EQ(refused(folder->write("cut.blend", "BLENDER-v304RENDH")).code, ErrorCode::unreadable);
}

}  // namespace
}  // namespace surefoot
