/// The words in a picture: a title, and what the colours mean.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "tour/camera.hpp"
#include "tour/canvas.hpp"

namespace surefoot::tools {

struct LegendLine {
    std::string text;
    Colour colour{0, 0, 0};
    bool dot = false;  ///< with a dot of that colour before it
};

/// Draws a panel in the corner that hides the fewest of the points `keep_clear`: a title, smaller words under it, and
/// lines with dots.
void draw_legend(Canvas& canvas, const std::string& title, const std::string& under,
                 const std::vector<LegendLine>& lines, std::span<const Projected> keep_clear);

}  // namespace surefoot::tools
