/// How widgets look: calm, dark and a little see-through, so that the world stays the brightest thing.
#pragma once

#include "view/colour.hpp"

struct ImVec4;

namespace surefoot::view {

/// Sets Dear ImGui's style; `scale` is that of letters.
void apply_theme(double scale);

[[nodiscard]] ImVec4 to_imgui(Colour colour);
[[nodiscard]] std::uint32_t packed(Colour colour);  ///< as draw lists take it

}  // namespace surefoot::view
