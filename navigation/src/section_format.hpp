// The bytes of a navigation section, as they lie in the file: little-endian, no pointers. docs/file-format.md is the
// same in words.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <type_traits>

namespace surefoot::navigation {

inline constexpr std::string_view section_owner = "surefoot";
inline constexpr std::string_view section_name = "navigation";
inline constexpr std::uint32_t section_version = 2;
inline constexpr std::array<char, 8> section_magic{'S', 'F', 'T', 'N', 'A', 'V', '\r', '\n'};
inline constexpr std::uint64_t tile_alignment = 64;  // [bytes]

/// Behind it lie, each at the next multiple of 8: the areas, their names one after another, the links, their inputs,
/// the table of tiles; and at multiples of 64 the tiles.
struct SectionHeader {
    std::array<char, 8> magic = section_magic;
    std::uint32_t version = section_version;
    std::uint32_t detour_version = 0;  ///< of Detour's own layout of a tile
    std::uint64_t size = 0;            ///< of the whole section [bytes]
    double origin[3] = {};             ///< the frame
    double x[3] = {};
    double y[3] = {};
    double z[3] = {};
    double radius = 0;  ///< the agent
    double height = 0;
    double climb = 0;
    double slope_limit_deg = 0;
    double feet = 0;
    double cell_size = 0;
    double cell_height = 0;
    double tile_size = 0;
    std::uint64_t layers = 0;
    float low = 0;
    float high = 0;
    std::int32_t tile_cells = 0;
    std::int32_t tiles_x = 0;
    std::int32_t tiles_z = 0;
    std::uint32_t areas = 0;
    std::uint32_t name_bytes = 0;
    std::uint32_t links = 0;
    std::uint32_t inputs = 0;
    std::uint32_t tiles = 0;
};

struct SectionArea {
    double cost = 1;
    std::uint32_t closed = 0;
    std::uint32_t name_bytes = 0;
};

struct SectionLink {
    double from[3] = {};
    double to[3] = {};
    double takeoff[3] = {};
    double end[3] = {};
    double speed = 0;
    double seconds = 0;
    double tick = 0;
    std::uint32_t kind = 0;
    std::uint32_t air_jumps = 0;
    std::uint32_t inputs = 0;  ///< how many of them, behind those of the links before
    std::uint32_t reserved = 0;
};

struct SectionTile {
    std::uint64_t offset = 0;  ///< from the beginning of the section
    std::uint64_t size = 0;    ///< [bytes]
    std::int32_t x = 0;
    std::int32_t z = 0;
};

static_assert(std::is_trivially_copyable_v<SectionHeader> && sizeof(SectionHeader) == 232);
static_assert(std::is_trivially_copyable_v<SectionArea> && sizeof(SectionArea) == 16);
static_assert(std::is_trivially_copyable_v<SectionLink> && sizeof(SectionLink) == 136);
static_assert(std::is_trivially_copyable_v<SectionTile> && sizeof(SectionTile) == 24);

[[nodiscard]] constexpr std::uint64_t aligned(std::uint64_t offset, std::uint64_t to) {
    return (offset + (to - 1)) / to * to;
}

/// Where everything begins.
struct SectionLayout {
    std::uint64_t areas = 0;
    std::uint64_t names = 0;
    std::uint64_t links = 0;
    std::uint64_t inputs = 0;
    std::uint64_t table = 0;
    std::uint64_t tiles = 0;
};

/// Counts are of 32 bits, so that nothing here can overflow.
[[nodiscard]] constexpr SectionLayout layout_of(const SectionHeader& header, std::uint64_t input_size) {
    SectionLayout layout;
    layout.areas = sizeof(SectionHeader);
    layout.names = layout.areas + header.areas * std::uint64_t{sizeof(SectionArea)};
    layout.links = aligned(layout.names + header.name_bytes, 8);
    layout.inputs = layout.links + header.links * std::uint64_t{sizeof(SectionLink)};
    layout.table = layout.inputs + header.inputs * input_size;
    layout.tiles = aligned(layout.table + header.tiles * std::uint64_t{sizeof(SectionTile)}, tile_alignment);
    return layout;
}

}  // namespace surefoot::navigation
