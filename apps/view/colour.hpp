/// Colours as they are written down, and the palette of everything that is drawn here.
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/ext/vector_float4.hpp>
#include <string_view>

#include <surefoot/debug_draw.hpp>

namespace surefoot::view {

using Colour = DebugColour;

/// 0xRRGGBB, as in every paint program.
[[nodiscard]] constexpr Colour rgb(std::uint32_t code, double opacity = 1) {
    return {static_cast<std::uint8_t>(code >> 16 & 0xFF), static_cast<std::uint8_t>(code >> 8 & 0xFF),
            static_cast<std::uint8_t>(code & 0xFF),
            static_cast<std::uint8_t>(std::clamp(opacity, 0.0, 1.0) * 255 + 0.5)};
}

[[nodiscard]] constexpr Colour with_opacity(Colour colour, double opacity) {
    colour.a = static_cast<std::uint8_t>(std::clamp(opacity, 0.0, 1.0) * 255 + 0.5);
    return colour;
}

[[nodiscard]] constexpr glm::vec4 to_vec4(Colour c) {
    return {float(c.r) / 255.0F, float(c.g) / 255.0F, float(c.b) / 255.0F, float(c.a) / 255.0F};
}

[[nodiscard]] constexpr Colour mixed(Colour a, Colour b, double share) {
    const auto mix = [&](std::uint8_t x, std::uint8_t y) {
        return static_cast<std::uint8_t>(x + (double(y) - x) * std::clamp(share, 0.0, 1.0) + 0.5);
    };
    return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b), mix(a.a, b.a)};
}

/// What colours mean, in every room.
namespace paint {
inline constexpr Colour start = rgb(0xE0483E);    ///< where a motion begins
inline constexpr Colour end = rgb(0x3FA65A);      ///< where it would like to end
inline constexpr Colour hit = rgb(0xF2912B);      ///< where it stops
inline constexpr Colour result = rgb(0x3F7FD0);   ///< where sliding would leave it
inline constexpr Colour normal = rgb(0x2FB7C9);   ///< normals of contacts
inline constexpr Colour contact = rgb(0xFFE08A);  ///< points of contact
inline constexpr Colour face = rgb(0x6FC3DF);     ///< features of a triangle
inline constexpr Colour edge = rgb(0xF3B04C);
inline constexpr Colour vertex = rgb(0xE46FA8);
inline constexpr Colour ink = rgb(0x1C242C);
inline constexpr Colour paper = rgb(0xF4F6F8);
inline constexpr Colour accent = rgb(0x4FB3A5);
}  // namespace paint

/// What a surface looks like: as its name says where it is a common one, else a quiet colour of its own.
[[nodiscard]] Colour colour_of_surface(std::uint32_t surface, std::string_view name);

}  // namespace surefoot::view
