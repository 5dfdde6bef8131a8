// A picture without a display: the smallest rasteriser that will do.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdio>

#include "scene.hpp"

namespace day {

class Picture {
public:
    Picture(int width, int height)
        : width_(width),
          height_(height),
          pixels_(std::size_t(width) * std::size_t(height), Pixel{{0.62, 0.78, 0.92}}) {}

    void draw(const Scene& scene) {
        for (const Drawn& triangle : scene.triangles) {
            std::vector<glm::dvec4> corners;
            for (const dvec3& corner : triangle.corners)
                corners.push_back(scene.view_and_projection * glm::dvec4(corner, 1));
            const std::vector<dvec3> outline = on_screen(corners);
            for (std::size_t i = 2; i < outline.size(); ++i)
                fill(outline[0], outline[i - 1], outline[i], triangle.colour);
        }
    }

    /// As a .ppm, which most viewers open.
    [[nodiscard]] bool save(const std::string& path) const {
        std::FILE* const file = std::fopen(path.c_str(), "wb");
        if (file == nullptr) return false;
        std::fprintf(file, "P6 %d %d 255\n", width_, height_);
        for (const Pixel& pixel : pixels_)
            for (const double value : {pixel.colour.r, pixel.colour.g, pixel.colour.b})
                std::fputc(int(255 * std::clamp(value, 0.0, 1.0)), file);
        return std::fclose(file) == 0;
    }

    /// How many pixels show something.
    [[nodiscard]] double covered() const {
        const auto is_drawn = [](const Pixel& pixel) { return pixel.nearness > 0; };
        return double(std::ranges::count_if(pixels_, is_drawn)) / double(pixels_.size());
    }

private:
    struct Pixel {
        Colour colour;
        double nearness = 0;  // 1 / distance, which is what varies evenly over a triangle on the screen
    };

    // [on_screen]
    /// What of a polygon is in front of the eye, in pixels, with its nearness.
    [[nodiscard]] std::vector<dvec3> on_screen(const std::vector<glm::dvec4>& corners) const {
        constexpr double near = 0.1;
        std::vector<dvec3> outline;
        const auto put = [&](const glm::dvec4& p) {
            outline.push_back({(0.5 + 0.5 * p.x / p.w) * width_, (0.5 - 0.5 * p.y / p.w) * height_, 1 / p.w});
        };
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const glm::dvec4& a = corners[i];
            const glm::dvec4& b = corners[(i + 1) % corners.size()];
            if (a.w >= near) put(a);
            if ((a.w >= near) != (b.w >= near)) put(glm::mix(a, b, (near - a.w) / (b.w - a.w)));
        }
        return outline;
    }
    // [/on_screen]

    // [fill]
    void fill(const dvec3& a, const dvec3& b, const dvec3& c, const Colour& colour) {
        const auto side = [](const dvec3& p, const dvec3& q, double x, double y) {
            return (q.x - p.x) * (y - p.y) - (q.y - p.y) * (x - p.x);
        };
        const double area = side(a, b, c.x, c.y);
        if (area == 0) return;
        const int left = int(std::clamp(std::min({a.x, b.x, c.x}), 0.0, double(width_)));
        const int right = int(std::clamp(std::max({a.x, b.x, c.x}) + 1, 0.0, double(width_)));
        const int top = int(std::clamp(std::min({a.y, b.y, c.y}), 0.0, double(height_)));
        const int bottom = int(std::clamp(std::max({a.y, b.y, c.y}) + 1, 0.0, double(height_)));
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                const double u = side(b, c, x + 0.5, y + 0.5) / area;
                const double v = side(c, a, x + 0.5, y + 0.5) / area;
                const double w = 1 - u - v;
                if (u < 0 || v < 0 || w < 0) continue;
                Pixel& pixel = pixels_[std::size_t(y) * std::size_t(width_) + std::size_t(x)];
                const double nearness = u * a.z + v * b.z + w * c.z;
                if (nearness > pixel.nearness) pixel = {colour, nearness};
            }
    }
    // [/fill]

    int width_, height_;
    std::vector<Pixel> pixels_;
};

}  // namespace day
