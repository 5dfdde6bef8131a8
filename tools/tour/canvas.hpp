/// A picture in memory: colours as the eye takes them (sRGB), from 0 to 1, and the PNG that is made of it.
#pragma once

#include <string>
#include <vector>

#include <surefoot/math.hpp>

namespace surefoot::tools {

/// Red, green, blue [0, 1].
using Colour = dvec3;

class Canvas {
public:
    Canvas(int width, int height)
        : width_(width), height_(height), pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

    [[nodiscard]] int width() const { return width_; }
    [[nodiscard]] int height() const { return height_; }
    [[nodiscard]] Colour& at(int x, int y) { return pixels_[index(x, y)]; }
    [[nodiscard]] const Colour& at(int x, int y) const { return pixels_[index(x, y)]; }

    /// Lays `colour` over a pixel; a pixel outside the picture is no error.
    void blend(int x, int y, const Colour& colour, double alpha);

    /// A rectangle with round corners, laid over what is there.
    void round_box(double left, double top, double right, double bottom, double radius, const Colour& colour,
                   double alpha);

    /// Writes a PNG. False if the file could not be written.
    [[nodiscard]] bool write_png(const std::string& file) const;

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    }

    int width_;
    int height_;
    std::vector<Colour> pixels_;
};

}  // namespace surefoot::tools
