// The first bytes of a .surefoot file, as they lie on the disk: little-endian, no pointers. docs/file-format.md is the
// same in words.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace surefoot::internal {

inline constexpr std::uint32_t format_version = 1;
inline constexpr std::uint32_t byte_order_mark = 0x01020304;
inline constexpr std::size_t section_alignment = 64;  // [bytes] a cache line, and the widest SIMD register
inline constexpr std::uint32_t most_sections = 1024;  // keeps opening under a millisecond

// A high bit and both kinds of line ends, so that a transfer as text is noticed at once.
inline constexpr std::array<unsigned char, 8> magic{0x89, 'S', 'F', 'T', '\r', '\n', 0x1A, '\n'};

struct FileHeader {
    std::array<unsigned char, 8> magic{};
    std::uint64_t checksum = 0;  ///< XXH3-64 of the bytes from `byte_order` to the end of the table
    std::uint32_t byte_order = byte_order_mark;
    std::uint32_t version = format_version;
    std::uint64_t file_size = 0;  ///< [bytes]
    std::uint32_t section_count = 0;
    std::uint32_t zero = 0;
    std::uint64_t made_from = 0;  ///< a hash of the sources and of the options of cooking; 0 if nobody said
    std::array<std::uint64_t, 2> zeros{};
};

/// The table: one of these a section, right behind the header, in the order of their offsets.
struct FileSection {
    std::array<char, 16> owner{};  ///< padded with zeros
    std::array<char, 24> name{};   ///< padded with zeros
    std::uint32_t version = 0;
    std::uint32_t zero = 0;
    std::uint64_t offset = 0;  ///< from the beginning of the file; a multiple of 64
    std::uint64_t size = 0;    ///< [bytes] without the zeros that follow up to the next multiple of 64
    std::uint64_t made_from = 0;
    std::uint64_t checksum = 0;  ///< XXH3-64 of its bytes
};

static_assert(std::is_trivially_copyable_v<FileHeader> && sizeof(FileHeader) == 64);
static_assert(std::is_trivially_copyable_v<FileSection> && sizeof(FileSection) == 80);

constexpr std::uint64_t aligned(std::uint64_t offset) noexcept {
    return (offset + (section_alignment - 1)) / section_alignment * section_alignment;
}

/// Files are little-endian and used where they lie.
inline constexpr bool machine_fits = std::endian::native == std::endian::little;

}  // namespace surefoot::internal
