/// The drawings on flat triangles: one small picture that repeats, a pattern in each of its channels.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "view/gl.hpp"

namespace surefoot::view {

inline constexpr int pattern_texels = 256;         ///< of a side
inline constexpr double pattern_metres = 6;        ///< so far apart are its repetitions
using PatternTexel = std::array<std::uint8_t, 4>;  ///< patches, bricks, boards, strata; 128 leaves a colour as it is

/// Row by row. It joins itself at all sides, and each channel's mean is 128, to a step: from afar it is not there.
[[nodiscard]] std::vector<PatternTexel> pattern_picture();

/// The same on the graphics card, with smaller ones for what is far away.
[[nodiscard]] gl::Texture pattern_texture();

}  // namespace surefoot::view
