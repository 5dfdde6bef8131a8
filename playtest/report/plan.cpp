#include "playtest/report/plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "playtest/report/picture.hpp"
#include "playtest/vectors.hpp"

namespace surefoot::playtest {
namespace {

constexpr double margin = 3;  // around the level [m]

// Draws triangles from above into a picture, the highest in front.
class Painter {
public:
    Painter(const PlanFrame& frame, double low, double high)
        : frame_(frame),
          low_(low),
          high_(std::max(high, low + 1)),
          picture_(frame.width, frame.height),
          depth_(std::size_t(frame.width * frame.height), -1e300) {}

    void draw(const Mesh& mesh, const dvec3& origin, bool moves) {
        for (std::uint32_t i = 0; i < mesh.triangle_count(); ++i) {
            const Triangle triangle = mesh.triangle(i);
            draw({triangle.a + origin, triangle.b + origin, triangle.c + origin}, moves);
        }
    }

    [[nodiscard]] const Picture& picture() const { return picture_; }

private:
    void draw(const std::array<dvec3, 3>& corners, bool moves) {
        const dvec3 u = corners[1] - corners[0];
        const dvec3 v = corners[2] - corners[0];
        const dvec3 normal = unit({u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x});
        const double light = 0.45 + 0.55 * std::max(0.0, dot(normal, unit({0.4, 1, 0.3})));
        std::array<double, 3> x{};
        std::array<double, 3> y{};
        for (std::size_t i = 0; i < 3; ++i) {
            x[i] = frame_.x(corners[i]);
            y[i] = frame_.y(corners[i]);
        }
        const double area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        if (std::abs(area) < 1e-9) return;
        const int left = std::max(0, int(std::min({x[0], x[1], x[2]})));
        const int right = std::min(frame_.width - 1, int(std::max({x[0], x[1], x[2]})));
        const int top = std::max(0, int(std::min({y[0], y[1], y[2]})));
        const int bottom = std::min(frame_.height - 1, int(std::max({y[0], y[1], y[2]})));
        for (int row = top; row <= bottom; ++row)
            for (int column = left; column <= right; ++column) {
                const double px = column + 0.5;
                const double py = row + 0.5;
                const double b = ((px - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (py - y[0])) / area;
                const double c = ((x[1] - x[0]) * (py - y[0]) - (px - x[0]) * (y[1] - y[0])) / area;
                if (b < 0 || c < 0 || b + c > 1) continue;
                paint(column, row, corners[0].y + b * u.y + c * v.y, light, moves);
            }
    }

    void paint(int column, int row, double height, double light, bool moves) {
        const auto at = std::size_t(row * frame_.width + column);
        if (height <= depth_[at]) return;
        depth_[at] = height;
        const double share = (height - low_) / (high_ - low_);
        // From slate in the deep to pale on high; what moves is blue.
        const std::array<double, 3> deep =
            moves ? std::array<double, 3>{70, 90, 190} : std::array<double, 3>{96, 102, 116};
        const std::array<double, 3> pale =
            moves ? std::array<double, 3>{140, 165, 250} : std::array<double, 3>{244, 240, 228};
        for (std::size_t i = 0; i < 3; ++i)
            picture_.rgba[4 * at + i] =
                std::uint8_t(std::clamp((deep[i] + (pale[i] - deep[i]) * share) * light, 0.0, 255.0));
        picture_.rgba[4 * at + 3] = 255;
    }

    PlanFrame frame_;
    double low_;
    double high_;
    Picture picture_;
    std::vector<double> depth_;
};

}  // namespace

PlanFrame plan_frame(const game::Level& level, int longest) {
    Bounds box = level.ground.bounds();
    for (const game::BodyPlan& body : level.bodies) {
        const Bounds own = body.mesh.bounds();
        for (int i = 0; i < 3; ++i) {
            box.min[i] = std::min(box.min[i], own.min[i] + body.origin[i]);
            box.max[i] = std::max(box.max[i], own.max[i] + body.origin[i]);
        }
    }
    const double wide = box.max.x - box.min.x + 2 * margin;
    const double deep = box.max.z - box.min.z + 2 * margin;
    const double scale = std::min(8.0, longest / std::max(wide, deep));
    return {.west = box.min.x - margin,
            .north = box.min.z - margin,
            .scale = scale,
            .width = std::max(1, int(wide * scale)),
            .height = std::max(1, int(deep * scale))};
}

std::string plan_picture(const game::Level& level, const PlanFrame& frame) {
    const Bounds box = level.ground.bounds();
    Painter painter(frame, box.min.y, box.max.y);
    painter.draw(level.ground, {0, 0, 0}, false);
    for (const game::BodyPlan& body : level.bodies) painter.draw(body.mesh, body.origin, true);
    return data_uri(painter.picture());
}

std::string heat_picture(const HeatMap& heat, const PlanFrame& frame) {
    Picture picture(frame.width, frame.height);
    std::uint32_t most = 1;
    for (const auto& [cell, count] : heat) most = std::max(most, count);
    for (const auto& [cell, count] : heat) {
        const double share = std::log1p(double(count)) / std::log1p(double(most));
        const double left = (cell[0] * heat_cell - frame.west) * frame.scale;
        const double top = (cell[1] * heat_cell - frame.north) * frame.scale;
        const double size = std::max(1.0, heat_cell * frame.scale);
        for (int row = int(top); row < int(top + size + 0.5); ++row)
            for (int column = int(left); column < int(left + size + 0.5); ++column) {
                if (row < 0 || column < 0 || row >= frame.height || column >= frame.width) continue;
                std::uint8_t* const pixel = &picture.rgba[std::size_t(row * frame.width + column) * 4];
                pixel[0] = std::uint8_t(60 + 195 * share);
                pixel[1] = std::uint8_t(90 + 90 * share * (1 - share) * 2);
                pixel[2] = std::uint8_t(200 * (1 - share) + 20);
                pixel[3] = std::uint8_t(70 + 160 * share);
            }
    }
    return data_uri(picture);
}

}  // namespace surefoot::playtest
