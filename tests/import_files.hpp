/// Small level files, written by the tests that read them, and how they are read.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

#include <surefoot/import.hpp>

namespace surefoot::test {

/// A folder for one test, removed at its end.
class Folder {
public:
    Folder() {
        std::string pattern = (std::filesystem::temp_directory_path() / "surefoot-test-XXXXXX").string();
        path_ = mkdtemp(pattern.data());
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }

    [[nodiscard]] std::string write(const std::string& name, std::string_view bytes) const {
        const std::filesystem::path file = path_ / name;
        std::ofstream(file, std::ios::binary) << bytes;
        return file.string();
    }

    /// A shell script in place of the helper program.
    [[nodiscard]] std::string write_program(const std::string& name, const std::string& body) const {
        const std::string file = write(name, "#!/bin/sh\n" + body + "\n");
        std::filesystem::permissions(file, std::filesystem::perms::owner_all);
        return file;
    }

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
};

template <typename T>
void append_bytes(std::string& bytes, const T& value) {
    const std::size_t old = bytes.size();
    bytes.resize(old + sizeof value);
    std::memcpy(bytes.data() + old, &value, sizeof value);
}

/// A .glb of one JSON text and one buffer.
inline std::string glb(std::string json, std::string buffer) {
    while (json.size() % 4 != 0) json += ' ';
    while (buffer.size() % 4 != 0) buffer += '\0';
    std::string bytes = "glTF";
    append_bytes(bytes, std::uint32_t{2});
    append_bytes(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + buffer.size()));
    append_bytes(bytes, static_cast<std::uint32_t>(json.size()));
    bytes += "JSON" + json;
    append_bytes(bytes, static_cast<std::uint32_t>(buffer.size()));
    bytes += std::string("BIN\0", 4) + buffer;
    return bytes;
}

/// The corners (0,0,0), (1,0,0), (0,1,0), (0,0,1) and the triangles 0 1 2 and 0 1 3.
inline std::string gltf_buffer() {
    std::string buffer;
    for (const float f : {0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f}) append_bytes(buffer, f);
    for (const int i : {0, 1, 2, 0, 1, 3}) append_bytes(buffer, static_cast<std::uint16_t>(i));
    return buffer;
}

/// A glTF text around gltf_buffer(). `nodes` is what stands between the brackets of the nodes, all of them roots but
/// for `inner` at the end; `more` is put into the top object.
inline std::string gltf(const std::string& nodes, const std::string& roots, const std::string& uri = {},
                        const std::string& more = {}) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[)" + roots + R"(]}],"nodes":[)" + nodes +
           R"(],"meshes":[{"name":"corner","primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],)"
           R"("materials":[{"name":"ice","extras":{"friction":0.05}}],)"
           R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},)"
           R"({"bufferView":1,"componentType":5123,"count":6,"type":"SCALAR"}],)"
           R"("bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}],)"
           R"("buffers":[{"byteLength":60)" +
           (uri.empty() ? "" : R"(,"uri":")" + uri + '"') + "}]" + more + "}";
}

using Vertices = std::vector<vec3>;

inline ImportedLevel good(const std::string& path, const ImportOptions& options = {}) {
    auto level = import_level(path, options);
    EXPECT_TRUE(level.has_value()) << (level ? "" : level.error().text);
    return level ? *level : ImportedLevel{};
}

inline Error refused(const std::string& path, const ImportOptions& options = {}) {
    auto level = import_level(path, options);
    EXPECT_FALSE(level.has_value()) << path << " was read";
    if (level) return {};
    EXPECT_EQ(level.error().file, path);
    EXPECT_EQ(level.error().text.substr(0, path.size() + 2), path + ": ");
    return level.error();
}

/// The corners of every triangle, in order: what a format may not change, whatever it does to the list of vertices.
inline Vertices corners(const ImportedLevel& level) {
    Vertices all;
    for (const std::uint32_t i : level.indices) all.push_back(level.vertices[i]);
    return all;
}

}  // namespace surefoot::test
