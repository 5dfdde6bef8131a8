/// The letters: a font of the system where there is one, else the small one that Dear ImGui brings.
#pragma once

struct ImFont;

namespace surefoot::view {

struct Fonts {
    ImFont* plain = nullptr;
    ImFont* large = nullptr;  ///< titles
    ImFont* mono = nullptr;   ///< numbers in columns
};

/// Makes all fonts anew, `height` pixels high.
void make_fonts(double height);

[[nodiscard]] const Fonts& fonts();

}  // namespace surefoot::view
