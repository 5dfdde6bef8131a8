// A sheet of paper for the pictures of the docs: a few marks, one style, SVG out. Coordinates are in pixels with y
// down; `View` carries a picture's own coordinates (y up) onto the sheet.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace pictures {

struct Point {
    double x = 0;
    double y = 0;
};

inline Point operator+(Point a, Point b) {
    return {a.x + b.x, a.y + b.y};
}
inline Point operator-(Point a, Point b) {
    return {a.x - b.x, a.y - b.y};
}
inline Point operator*(double s, Point a) {
    return {s * a.x, s * a.y};
}
double length(Point a);
Point unit(Point a);

// The colours of every picture, by what they stand for.
namespace colour {
inline constexpr std::string_view ink = "#2f343b";
inline constexpr std::string_view quiet = "#7d858f";
inline constexpr std::string_view faint = "#c9cdd2";
inline constexpr std::string_view paper = "#fcfbf8";
inline constexpr std::string_view shape = "#2f6f9f";  // what moves
inline constexpr std::string_view shape_fill = "#d5e5f0";
inline constexpr std::string_view ground = "#8a6d3b";  // what is hit
inline constexpr std::string_view ground_fill = "#efe4cd";
inline constexpr std::string_view motion = "#3f8f5f";  // the way it goes
inline constexpr std::string_view touch = "#c0492f";   // where it stops, and the normal there
inline constexpr std::string_view plane = "#7a5aa6";   // a candidate
inline constexpr std::string_view plane_fill = "#e9e2f3";
inline constexpr std::string_view none = "none";
}  // namespace colour

struct Style {
    std::string_view stroke = colour::ink;
    double width = 1.6;
    std::string_view fill = colour::none;
    bool dashed = false;
    double opacity = 1;
};

enum class Anchor { start, middle, end };

struct Lettering {
    double size = 15;
    std::string_view fill = colour::ink;
    Anchor anchor = Anchor::start;
    bool bold = false;
    bool italic = false;
    bool mono = false;
};

class Canvas {
public:
    // `description` is read aloud to those who cannot see the picture.
    Canvas(double width, double height, std::string_view description);

    void line(Point from, Point to, const Style& style = {});
    void polyline(std::span<const Point> points, const Style& style = {});
    void polygon(std::span<const Point> points, const Style& style = {});
    void circle(Point centre, double radius, const Style& style = {});
    void ellipse(Point centre, double radius_x, double radius_y, double degrees = 0, const Style& style = {});
    void box(Point corner, double width, double height, const Style& style = {}, double rounding = 0);
    void arrow(Point from, Point to, const Style& style = {});
    void dot(Point at, std::string_view fill, double radius = 4);
    void right_angle(Point corner, Point along, Point other, double size = 9);
    void text(Point at, std::string_view words, const Lettering& lettering = {});

    [[nodiscard]] std::string svg() const;

private:
    std::string body_;
};

// From a picture's own coordinates (y up) to the sheet.
struct View {
    Point origin;
    double scale = 1;
    [[nodiscard]] Point operator()(Point p) const { return {origin.x + scale * p.x, origin.y - scale * p.y}; }
    [[nodiscard]] Point operator()(double x, double y) const { return (*this)(Point{x, y}); }
    [[nodiscard]] std::vector<Point> operator()(std::span<const Point> points) const;
};

// A picture and the name of its file.
struct Picture {
    std::string_view name;
    std::string (*draw)();
};

}  // namespace pictures
