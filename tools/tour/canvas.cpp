#include "tour/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace surefoot::tools {

void Canvas::blend(int x, int y, const Colour& colour, double alpha) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_ || alpha <= 0) return;
    at(x, y) = glm::mix(at(x, y), colour, std::min(alpha, 1.0));
}

void Canvas::round_box(double left, double top, double right, double bottom, double radius, const Colour& colour,
                       double alpha) {
    for (int y = static_cast<int>(top) - 1; y <= static_cast<int>(bottom) + 1; ++y)
        for (int x = static_cast<int>(left) - 1; x <= static_cast<int>(right) + 1; ++x) {
            const double dx = std::max({left + radius - x - 0.5, x + 0.5 - right + radius, 0.0});
            const double dy = std::max({top + radius - y - 0.5, y + 0.5 - bottom + radius, 0.0});
            blend(x, y, colour, alpha * std::clamp(radius - std::hypot(dx, dy) + 0.5, 0.0, 1.0));
        }
}

bool Canvas::write_png(const std::string& file) const {
    std::vector<unsigned char> bytes;
    bytes.reserve(pixels_.size() * 3);
    for (const Colour& pixel : pixels_)
        for (const double channel : {pixel.x, pixel.y, pixel.z})
            bytes.push_back(static_cast<unsigned char>(std::lround(255 * std::clamp(channel, 0.0, 1.0))));
    return stbi_write_png(file.c_str(), width_, height_, 3, bytes.data(), width_ * 3) != 0;
}

}  // namespace surefoot::tools
