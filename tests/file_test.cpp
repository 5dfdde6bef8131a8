// A mesh in a file: what comes back, what is refused, and that nothing that the bytes may be does harm.
#include <bit>
#include <cstring>
#include <gtest/gtest.h>

#include "file/container.hpp"
#include "file_things.hpp"

namespace surefoot::tests {
namespace {

using File = FileTest;

/// A header that is as it should be, whatever has been done to it and to the table.
void sum_again(Bytes& bytes) {
    std::uint32_t sections = 0;
    std::memcpy(&sections, bytes.data() + offsetof(internal::FileHeader, section_count), sizeof sections);
    const std::size_t end = sizeof(internal::FileHeader) + sections * sizeof(internal::FileSection);
    if (end > bytes.size()) return;
    const std::size_t from = offsetof(internal::FileHeader, byte_order);
    const std::uint64_t sum = hash_bytes(std::span(bytes).subspan(from, end - from));
    std::memcpy(bytes.data() + offsetof(internal::FileHeader, checksum), &sum, sizeof sum);
}

void flip(Bytes& bytes, std::size_t bit) {
    bytes[bit / 8] ^= std::byte{1} << (bit % 8);
}

Bytes bytes_of(const Mesh& mesh, const std::string& path) {
    EXPECT_TRUE(mesh.write(path).has_value());
    return read_bytes(path);
}

TEST_F(File, a_mesh_answers_from_its_file_as_from_memory) {
    const Cooked made = cooked(hills(20));
    ASSERT_TRUE(made.mesh.write(path("hills.surefoot")).has_value());
    for (const Check check : {Check::header, Check::structure, Check::everything}) {
        const auto opened = Mesh::open(path("hills.surefoot"), check);
        ASSERT_TRUE(opened.has_value()) << opened.error().text;
        const auto read = Mesh::read(path("hills.surefoot"), check);
        ASSERT_TRUE(read.has_value()) << read.error().text;
        EXPECT_EQ(ask_everything(*opened, 1, 200), ask_everything(made.mesh, 1, 200));
        EXPECT_EQ(ask_everything(*read, 1, 200), ask_everything(made.mesh, 1, 200));
        for (std::uint32_t id = 0; id < made.mesh.triangle_count(); ++id) {
            EXPECT_EQ(opened->triangle(id).a, made.mesh.triangle(id).a);
            EXPECT_EQ(opened->triangle(id).c, made.mesh.triangle(id).c);
        }
    }
}

TEST_F(File, a_mesh_that_was_built_can_be_written_and_opened) {
    const std::vector<vec3> vertices{{0, 0, 0}, {0, 0, 2}, {2, 0, 0}};
    const std::vector<std::uint32_t> indices{0, 1, 2};
    const std::vector<std::uint32_t> surfaces{7};
    const auto built = Mesh::build({.vertices = vertices, .indices = indices, .surfaces = surfaces});
    ASSERT_TRUE(built.has_value());
    ASSERT_TRUE(built->write(path("one.surefoot")).has_value());
    const auto opened = Mesh::open(path("one.surefoot"), Check::everything);
    ASSERT_TRUE(opened.has_value()) << opened.error().text;
    EXPECT_EQ(opened->triangle_count(), 1U);
    EXPECT_EQ(opened->surface(0), 7U);
    EXPECT_TRUE(opened->ray({{0.5, 1, 0.5}, {0.5, -1, 0.5}}).has_value());
}

TEST_F(File, an_empty_mesh_is_a_file_too) {
    const auto built = Mesh::build({});
    ASSERT_TRUE(built.has_value());
    ASSERT_TRUE(built->write(path("none.surefoot")).has_value());
    const auto opened = Mesh::open(path("none.surefoot"), Check::everything);
    ASSERT_TRUE(opened.has_value()) << opened.error().text;
    EXPECT_EQ(opened->triangle_count(), 0U);
    ask_everything(*opened, 1, 10);
}

TEST_F(File, sections_of_others_are_carried_along_and_replaced_by_name) {
    const Bytes navigation(100, std::byte{42});
    const Section first{.owner = "navigation", .name = "tiles", .version = 3, .made_from = 77, .bytes = navigation};
    ASSERT_TRUE(cooked(hills(4)).mesh.write(path("a.surefoot"), std::span(&first, 1)).has_value());
    const auto a = Mesh::open(path("a.surefoot"));
    ASSERT_TRUE(a.has_value());
    const auto found = a->section("navigation", "tiles");
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(found->version, 3U);
    EXPECT_EQ(found->made_from, 77U);
    EXPECT_EQ(Bytes(found->bytes.begin(), found->bytes.end()), navigation);
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(found->bytes.data()) % 64, 0U);
    EXPECT_FALSE(a->section("navigation", "tile").has_value());

    const Bytes better(3, std::byte{43});
    const Section second{.owner = "navigation", .name = "tiles", .version = 4, .bytes = better};
    ASSERT_TRUE(a->write(path("b.surefoot"), std::span(&second, 1)).has_value());
    const auto b = Mesh::open(path("b.surefoot"), Check::everything);
    ASSERT_TRUE(b.has_value()) << b.error().text;
    EXPECT_EQ(b->section("navigation", "tiles")->bytes.size(), 3U);
    EXPECT_EQ(b->sections().size(), a->sections().size());
}

TEST_F(File, a_section_without_a_proper_name_is_refused) {
    const Mesh mesh = cooked(hills(2)).mesh;
    for (const Section& bad :
         {Section{.owner = "", .name = "x"}, Section{.owner = "me", .name = "with space"},
          Section{.owner = "seventeen letters", .name = "x"}, Section{.owner = "surefoot", .name = "nodes"}}) {
        const auto written = mesh.write(path("x.surefoot"), std::span(&bad, 1));
        ASSERT_FALSE(written.has_value());
        EXPECT_EQ(written.error().code, ErrorCode::invalid);
    }
    EXPECT_EQ(file_count(), 0U);
}

TEST_F(File, a_file_cut_short_anywhere_says_so) {
    const Bytes whole = bytes_of(cooked(hills(2)).mesh, path("h.surefoot"));
    for (std::size_t size = 0; size < whole.size(); ++size) {
        const auto read = Mesh::read(std::span(whole).first(size));
        ASSERT_FALSE(read.has_value()) << size;
        EXPECT_NE(read.error().text.find("cook"), std::string::npos) << read.error().text;
    }
}

TEST_F(File, errors_name_the_file_the_byte_and_the_cure) {
    Bytes bytes = bytes_of(cooked(hills(2)).mesh, path("h.surefoot"));
    bytes.resize(bytes.size() - 64);
    write_bytes(path("cut.surefoot"), bytes);
    const auto opened = Mesh::open(path("cut.surefoot"));
    ASSERT_FALSE(opened.has_value());
    EXPECT_EQ(opened.error().code, ErrorCode::unreadable);
    EXPECT_EQ(opened.error().file, path("cut.surefoot"));
    EXPECT_EQ(opened.error().byte, bytes.size());
    EXPECT_NE(opened.error().text.find("surefoot cook IN -o"), std::string::npos);
}

TEST_F(File, files_of_other_kinds_and_versions_are_told_apart) {
    const Bytes good = bytes_of(cooked(hills(2)).mesh, path("h.surefoot"));
    const auto code_after = [&](std::size_t at, std::uint32_t value) {
        Bytes bytes = good;
        std::memcpy(bytes.data() + at, &value, sizeof value);
        sum_again(bytes);
        const auto read = Mesh::read(bytes);
        EXPECT_FALSE(read.has_value());
        return read ? ErrorCode::not_found : read.error().code;
    };
    EXPECT_EQ(code_after(0, 0x46546B50), ErrorCode::unreadable);
    EXPECT_EQ(code_after(offsetof(internal::FileHeader, byte_order), 0x04030201), ErrorCode::unreadable);
    EXPECT_EQ(code_after(offsetof(internal::FileHeader, version), 2), ErrorCode::unsupported);
    EXPECT_EQ(code_after(offsetof(internal::FileHeader, version), 0), ErrorCode::unsupported);
    EXPECT_EQ(code_after(sizeof(internal::FileHeader) + offsetof(internal::FileSection, version), 9),
              ErrorCode::unsupported);
    EXPECT_EQ(Mesh::open(path("nowhere.surefoot")).error().code, ErrorCode::not_found);
    EXPECT_EQ(Mesh::open(folder_.string()).error().code, ErrorCode::unreadable);
    write_bytes(path("empty.surefoot"), {});
    EXPECT_EQ(Mesh::open(path("empty.surefoot")).error().code, ErrorCode::unreadable);
}

TEST_F(File, every_bit_of_the_header_is_looked_at) {
    const Bytes good = bytes_of(cooked(hills(3)).mesh, path("h.surefoot"));
    std::uint32_t sections = 0;
    std::memcpy(&sections, good.data() + offsetof(internal::FileHeader, section_count), sizeof sections);
    const std::size_t end = sizeof(internal::FileHeader) + sections * sizeof(internal::FileSection);
    Bytes bytes = good;
    for (std::size_t bit = 0; bit < 8 * end; ++bit) {
        flip(bytes, bit);
        EXPECT_FALSE(Mesh::read(bytes).has_value()) << "bit " << bit;
        flip(bytes, bit);
    }
}

TEST_F(File, a_header_with_any_bit_flipped_and_a_good_checksum_does_no_harm) {
    const Bytes good = bytes_of(cooked(hills(3)).mesh, path("h.surefoot"));
    std::uint32_t sections = 0;
    std::memcpy(&sections, good.data() + offsetof(internal::FileHeader, section_count), sizeof sections);
    const std::size_t end = sizeof(internal::FileHeader) + sections * sizeof(internal::FileSection);
    std::size_t opened = 0;
    for (std::size_t bit = 0; bit < 8 * end; ++bit) {
        Bytes bytes = good;
        flip(bytes, bit);
        sum_again(bytes);
        const auto mesh = Mesh::read(bytes);
        if (!mesh) continue;
        ++opened;
        ask_everything(*mesh, bit, 2);
        static_cast<void>(level_notes(*mesh));
        static_cast<void>(cook_report(*mesh));
    }
    EXPECT_GT(opened, 0U);
}

TEST_F(File, thousands_of_flipped_bits_in_the_body_do_no_harm_and_a_full_check_finds_each) {
    const Bytes good = bytes_of(cooked(hills(8)).mesh, path("h.surefoot"));
    SplitMix random(3);
    const std::size_t begin = internal::aligned(sizeof(internal::FileHeader) + 9 * sizeof(internal::FileSection));
    for (int i = 0; i < 4000; ++i) {
        Bytes bytes = good;
        const auto bits = 1 + random.next() % 4;
        for (std::uint64_t k = 0; k < bits; ++k) flip(bytes, 8 * begin + random.next() % (8 * (bytes.size() - begin)));
        EXPECT_FALSE(bytes != good && Mesh::read(bytes, Check::everything).has_value());
        if (const auto mesh = Mesh::read(bytes, Check::header)) {
            ask_everything(*mesh, static_cast<std::uint64_t>(i), 4);
            static_cast<void>(level_notes(*mesh));
            static_cast<void>(cook_report(*mesh));
        }
        if (const auto mesh = Mesh::read(bytes, Check::structure)) ask_everything(*mesh, 5, 1);
    }
}

/// Overwrites 32-bit words in one of the mesh's sections.
void poison(Bytes& bytes, std::string_view name, std::uint32_t value, std::size_t every, std::size_t first) {
    const auto container = internal::Container::parse(bytes, "test");
    ASSERT_TRUE(container.has_value());
    const Section* const section = container->find("surefoot", name);
    ASSERT_NE(section, nullptr);
    const auto begin = static_cast<std::size_t>(section->bytes.data() - bytes.data());
    const std::size_t size = section->bytes.size();
    for (std::size_t at = 4 * first; at + 4 <= size; at += 4 * every) std::memcpy(bytes.data() + begin + at, &value, 4);
}

TEST_F(File, offsets_out_of_range_circles_and_vertices_that_are_no_numbers_do_no_harm) {
    const Bytes good = bytes_of(cooked(hills(12)).mesh, path("h.surefoot"));
    const std::uint32_t nan = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::quiet_NaN());
    const std::uint32_t infinity = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity());
    for (const char* const name : {"nodes", "leaves", "places"}) {
        for (const std::uint32_t value : {0U, 1U, 2U, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU, 0x80000001U, nan, infinity,
                                          0x08080808U, 0x00000303U, 0xFFFF1808U}) {
            for (const std::size_t every : {1U, 3U, 24U}) {
                for (std::size_t first = 0; first < every; first += every == 24 ? 1 : 2) {
                    Bytes bytes = good;
                    poison(bytes, name, value, every, first);
                    EXPECT_FALSE(bytes != good && Mesh::read(bytes, Check::everything).has_value());
                    if (const auto mesh = Mesh::read(bytes)) ask_everything(*mesh, 9, 2);
                }
            }
        }
    }
}

TEST_F(File, a_look_at_the_structure_finds_a_tree_that_is_none) {
    const Bytes good = bytes_of(cooked(hills(12)).mesh, path("h.surefoot"));
    ASSERT_TRUE(Mesh::read(good, Check::structure).has_value());
    const std::uint32_t nan = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::quiet_NaN());
    const auto error_of = [&](const char* name, std::uint32_t value, std::size_t every, std::size_t first) {
        Bytes bytes = good;
        poison(bytes, name, value, every, first);
        const auto mesh = Mesh::read(bytes, Check::structure);
        EXPECT_FALSE(mesh.has_value());
        return mesh ? std::string() : mesh.error().text;
    };
    EXPECT_NE(error_of("nodes", 0, 24, 16).find("not behind it"), std::string::npos);           // a circle
    EXPECT_NE(error_of("nodes", 0x7FFFFFFF, 24, 16).find("not behind it"), std::string::npos);  // out of range
    EXPECT_NE(error_of("nodes", 0xFFFFFFF0, 24, 16).find("leaf that is none"), std::string::npos);
    EXPECT_NE(error_of("leaves", nan, 1, 1).find("has a"), std::string::npos);
    EXPECT_NE(error_of("places", 8, 1, 0).find("elsewhere"), std::string::npos);
}

}  // namespace
}  // namespace surefoot::tests
