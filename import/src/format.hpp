/// Which kind of file a path names, and who reads it.
#pragma once

#include <string>

#include <surefoot/import.hpp>

namespace surefoot::internal {

enum class Format : std::uint8_t { obj, gltf, glb, ply, stl, ac, blend, bsp, pk3 };

/// By the end of the name, in any case of letters. Fails with `unsupported`.
[[nodiscard]] Expected<Format> format_of(const std::string& path);

/// The axis that points up when the file does not say.
[[nodiscard]] UpAxis usual_up(Format format) noexcept;

/// Metres for one unit when nobody says: 1, and 1/32 for Quake III, whose players are 56 units tall. A power of two
/// leaves every coordinate exact.
[[nodiscard]] double usual_scale(Format format) noexcept;

/// What the first bytes of a .blend tell.
enum class BlendAge : std::uint8_t {
    old,       ///< before 2.80: Assimp reads it
    current,   ///< 2.80 and later, or packed so that its age cannot be seen: Blender itself has to read it
    no_blend,  ///< no .blend at all
};

/// Requires: `head` holds the first 16 bytes, or all if there are fewer.
[[nodiscard]] BlendAge blend_age(std::string_view head) noexcept;

}  // namespace surefoot::internal
