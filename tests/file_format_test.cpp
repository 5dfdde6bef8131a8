// docs/file-format.md shows a whole file, byte for byte: it is what the writer writes, and it can be read.
#include <cstdio>
#include <gtest/gtest.h>
#include <sstream>

#include "file_things.hpp"

namespace surefoot::tests {
namespace {

using Format = FileTest;

/// As the document shows bytes: sixteen a line, behind their offset; a star for lines that are all zeros.
std::string dump_of(std::span<const std::byte> bytes) {
    std::string out;
    bool starred = false;
    for (std::size_t at = 0; at < bytes.size(); at += 16) {
        const auto line = bytes.subspan(at, std::min<std::size_t>(16, bytes.size() - at));
        const bool zeros = std::all_of(line.begin(), line.end(), [](std::byte byte) { return byte == std::byte{0}; });
        if (zeros && at + 16 < bytes.size()) {
            if (!starred) out += "*\n";
            starred = true;
            continue;
        }
        starred = false;
        char text[24];
        std::snprintf(text, sizeof text, "%06zx", at);
        out += text;
        for (const std::byte byte : line) {
            std::snprintf(text, sizeof text, " %02x", std::to_integer<unsigned>(byte));
            out += text;
        }
        out += '\n';
    }
    return out;
}

/// The bytes that such lines mean.
Bytes bytes_of(const std::string& dump) {
    Bytes bytes;
    std::istringstream lines(dump);
    for (std::string line; std::getline(lines, line);) {
        if (line == "*") continue;
        std::istringstream words(line);
        std::size_t at = 0;
        words >> std::hex >> at;
        bytes.resize(at);
        for (unsigned byte = 0; words >> std::hex >> byte;) bytes.push_back(static_cast<std::byte>(byte));
    }
    return bytes;
}

std::string dump_in_document() {
    const Bytes text = read_bytes(SUREFOOT_DOCS_DIR "/file-format.md");
    const std::string document(reinterpret_cast<const char*>(text.data()), text.size());
    const std::string fence = "```hex\n";
    const std::size_t begin = document.find(fence);
    if (begin == std::string::npos) return {};
    return document.substr(begin + fence.size(), document.find("```", begin + 3) - begin - fence.size());
}

TEST_F(Format, the_file_in_the_document_is_what_the_writer_writes) {
    const std::vector<vec3> vertices{{0, 0, 0}, {0, 0, 2}, {2, 0, 0}};
    const std::vector<std::uint32_t> indices{0, 1, 2};
    const std::vector<std::uint32_t> surfaces{7};
    const auto mesh = Mesh::build({.vertices = vertices, .indices = indices, .surfaces = surfaces});
    ASSERT_TRUE(mesh.has_value());
    ASSERT_TRUE(mesh->write(path("one.surefoot")).has_value());
    const std::string written = dump_of(read_bytes(path("one.surefoot")));
    EXPECT_EQ(written, dump_in_document()) << "if the format has changed on purpose, its version has to change too";
}

TEST_F(Format, the_file_in_the_document_can_be_read) {
    const auto mesh = Mesh::read(bytes_of(dump_in_document()), Check::everything);
    ASSERT_TRUE(mesh.has_value()) << mesh.error().text;
    EXPECT_EQ(mesh->triangle_count(), 1U);
    EXPECT_EQ(mesh->surface(0), 7U);
    EXPECT_EQ(mesh->triangle(0).b, dvec3(0, 0, 2));
    EXPECT_TRUE(mesh->ray({{0.5, 1, 0.5}, {0.5, -1, 0.5}}).has_value());
}

}  // namespace
}  // namespace surefoot::tests
