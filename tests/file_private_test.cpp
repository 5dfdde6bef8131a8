// A section mapped so that it may be written into.
#include <surefoot/private_section.hpp>

#include "file_things.hpp"

namespace surefoot::tests {
namespace {

using PrivateSectionTest = FileTest;

Bytes numbered(std::size_t size) {
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::byte>(i * 7);
    return bytes;
}

void write_with(const std::string& path, const Bytes& bytes) {
    const std::array<vec3, 3> corners{vec3{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    const std::array<std::uint32_t, 3> indices{0, 1, 2};
    const auto mesh = Mesh::build({.vertices = corners, .indices = indices});
    ASSERT_TRUE(mesh.has_value());
    const Section section{.owner = "game", .name = "water", .version = 3, .made_from = 9, .bytes = bytes};
    ASSERT_TRUE(mesh->write(path, std::span(&section, 1)).has_value());
}

// Would catch a mapping that is shared with the file or with another of the same file.
TEST_F(PrivateSectionTest, WhatIsWrittenIntoItStaysHere) {
    const Bytes bytes = numbered(9000);
    write_with(path("level.surefoot"), bytes);
    const Bytes file = read_bytes(path("level.surefoot"));
    auto opened = PrivateSection::open(path("level.surefoot"), "game", "water", Check::everything);
    ASSERT_TRUE(opened.has_value() && opened->has_value());
    PrivateSection section = **std::move(opened);
    EXPECT_EQ(section.version(), 3U);
    EXPECT_EQ(section.made_from(), 9U);
    EXPECT_EQ(section.mesh_made_from(), 0U);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(section.bytes().data()) % 64, 0U);
    ASSERT_TRUE(std::equal(bytes.begin(), bytes.end(), section.bytes().begin(), section.bytes().end()));
    EXPECT_EQ(file[section.offset() + 8], bytes[8]);
    for (std::byte& byte : section.bytes()) byte = std::byte{0xee};
    const auto other = PrivateSection::open(path("level.surefoot"), "game", "water");
    ASSERT_TRUE(other.has_value() && other->has_value());
    EXPECT_TRUE(std::equal(bytes.begin(), bytes.end(), (*other)->bytes().begin()));
    EXPECT_EQ(read_bytes(path("level.surefoot")), file);
    PrivateSection moved = std::move(section);
    EXPECT_EQ(moved.bytes()[4000], std::byte{0xee}) << "and moves with its owner";
}

TEST_F(PrivateSectionTest, AFileWithoutItHasNoneAndADamagedOneIsRefusedWhenAsked) {
    write_with(path("level.surefoot"), numbered(500));
    const auto none = PrivateSection::open(path("level.surefoot"), "game", "lava");
    ASSERT_TRUE(none.has_value());
    EXPECT_FALSE(none->has_value());
    EXPECT_EQ(PrivateSection::open(path("gone.surefoot"), "game", "water").error().code, ErrorCode::not_found);
    Bytes file = read_bytes(path("level.surefoot"));
    const auto sound = PrivateSection::open(path("level.surefoot"), "game", "water");
    ASSERT_TRUE(sound.has_value() && sound->has_value());
    file[(*sound)->offset() + 77] ^= std::byte{1};
    write_bytes(path("bad.surefoot"), file);
    EXPECT_TRUE(PrivateSection::open(path("bad.surefoot"), "game", "water").has_value());
    const auto bad = PrivateSection::open(path("bad.surefoot"), "game", "water", Check::everything);
    ASSERT_FALSE(bad.has_value());
    EXPECT_EQ(bad.error().code, ErrorCode::unreadable);
    EXPECT_EQ(bad.error().byte, (*sound)->offset());
}

}  // namespace
}  // namespace surefoot::tests
