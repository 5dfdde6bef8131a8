#include "tour/legend.hpp"

#include <algorithm>
#include <limits>

#include "tour/letters.hpp"

namespace surefoot::tools {

void draw_legend(Canvas& canvas, const std::string& title, const std::string& under,
                 const std::vector<LegendLine>& lines, std::span<const Projected> keep_clear) {
    const double x_height = std::max(5.0, canvas.height() / 100.0);
    const double row = 3.3 * x_height;
    const double pad = 2.4 * x_height;
    const double title_size = 1.45 * x_height;
    const Colour ink(0.17, 0.19, 0.22);
    const Colour quiet(0.36, 0.39, 0.43);
    double width = std::max(text_width(title, title_size), text_width(under, x_height));
    for (const LegendLine& line : lines) width = std::max(width, text_width(line.text, x_height) + 2.6 * x_height);
    const double height = 2 * pad + 1.6 * title_size + row + row * static_cast<double>(lines.size()) - 1.2 * x_height;
    const double inset = 2.2 * x_height;
    double left = inset;
    double top = canvas.height() - inset - height;
    std::ptrdiff_t fewest = std::numeric_limits<std::ptrdiff_t>::max();
    for (const bool lower : {true, false})
        for (const bool leftmost : {true, false}) {
            const double x = leftmost ? inset : canvas.width() - inset - width - 2 * pad;
            const double y = lower ? canvas.height() - inset - height : inset;
            const auto hidden = std::count_if(keep_clear.begin(), keep_clear.end(), [&](const Projected& p) {
                return p.x > x && p.x < x + width + 2 * pad && p.y > y && p.y < y + height;
            });
            if (hidden >= fewest) continue;
            fewest = hidden;
            left = x;
            top = y;
        }
    canvas.round_box(left, top, left + width + 2 * pad, top + height, 1.6 * x_height, Colour(0.98, 0.98, 0.97), 0.86);
    double y = top + pad + 1.5 * title_size;
    draw_text(canvas, left + pad, y, title_size, title, ink);
    y += 0.85 * row;
    draw_text(canvas, left + pad, y, x_height, under, quiet);
    for (const LegendLine& line : lines) {
        y += row;
        double x = left + pad;
        if (line.dot) {
            const double radius = 0.72 * x_height;
            canvas.round_box(x, y - 0.5 * x_height - radius, x + 2 * radius, y - 0.5 * x_height + radius, radius,
                             line.colour, 1);
            x += 2.6 * x_height;
        }
        draw_text(canvas, x, y, x_height, line.text, ink);
    }
}

}  // namespace surefoot::tools
