/// What the flags of a Quake III texture mean, by bit and by name.
#pragma once

#include <cstdint>
#include <string>

namespace surefoot::internal::quake3 {

/// Bits of a texture's content flags that decide here.
enum Contents : std::uint32_t {
    contents_solid = 0x1,
    contents_player_clip = 0x10000,
};

/// Bits of a texture's surface flags that decide here.
enum Surface : std::uint32_t {
    surface_slick = 0x2,
    surface_ladder = 0x8,
    surface_nodraw = 0x80,
};

/// A player is stopped by it. The game asks the contents alone; the surface flag "nonsolid" only tells its compiler.
[[nodiscard]] constexpr bool stops_players(std::uint32_t content_flags) noexcept {
    return (content_flags & (contents_solid | contents_player_clip)) != 0;
}

/// The flags as a surface's extras, JSON text: the names under "quake3", and under "surefoot" what they mean to
/// movement.
[[nodiscard]] std::string surface_extras(std::uint32_t surface_flags, std::uint32_t content_flags);

}  // namespace surefoot::internal::quake3
