/// What a surface is like, by the words in its name.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <surefoot/character_surface.hpp>

namespace surefoot::tools {

/// What paths think of a surface.
enum class SurfaceGround : std::uint8_t {
    plain,
    ice,        ///< dearer: feet hardly stop on it
    mud,        ///< dearer
    water,      ///< dearer
    forbidden,  ///< nobody is to set foot on it
};

struct SurfaceMeaning {
    SurfaceRule rule{};
    SurfaceGround ground = SurfaceGround::plain;
};

/// By the first word of the name that means something, whatever its case: "Ice_blue" is ice, "plaster 2" is nothing.
/// Words are ice, mud, water, ladder, slippery, and lava, acid, spikes and deadly, which forbid.
[[nodiscard]] SurfaceMeaning surface_meaning(std::string_view name);

/// One rule for each name, in their order, for `CharacterSettings::surfaces`.
[[nodiscard]] std::vector<SurfaceRule> surface_rules(std::span<const std::string> names);

}  // namespace surefoot::tools
