/// Letters made of straight strokes and arcs, so that a picture can be labelled without any font file.
#pragma once

#include <string_view>

#include "tour/canvas.hpp"

namespace surefoot::tools {

/// How wide `text` is when small letters are `size` pixels high [pixels].
[[nodiscard]] double text_width(std::string_view text, double size);

/// Draws `text` with its base line at `y` [pixels from the top]; `size` is the height of a small x. Capital letters are
/// drawn as small ones, and what has no glyph as a gap.
void draw_text(Canvas& canvas, double x, double y, double size, std::string_view text, const Colour& colour);

}  // namespace surefoot::tools
