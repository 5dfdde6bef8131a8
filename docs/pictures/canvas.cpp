#include "canvas.hpp"

#include <cmath>
#include <cstdio>

namespace pictures {
namespace {

// Two decimals, no "-0.00": the same text for the same picture, every time.
std::string number(double value) {
    if (std::abs(value) < 0.005) value = 0;
    char text[32];
    std::snprintf(text, sizeof(text), "%.2f", value);
    std::string out(text);
    while (out.back() == '0') out.pop_back();
    if (out.back() == '.') out.pop_back();
    return out;
}

std::string attribute(std::string_view name, std::string_view value) {
    std::string out(1, ' ');
    out += name;
    out += "=\"";
    out += value;
    out += '"';
    return out;
}

std::string attribute(std::string_view name, double value) {
    return attribute(name, number(value));
}

std::string look(const Style& style) {
    std::string out = attribute("fill", style.fill);
    if (style.width > 0 && style.stroke != colour::none) {
        out += attribute("stroke", style.stroke) + attribute("stroke-width", style.width);
        out += " stroke-linejoin=\"round\" stroke-linecap=\"round\"";
        if (style.dashed) out += " stroke-dasharray=\"2 5\"";
    }
    if (style.opacity < 1) out += attribute("opacity", style.opacity);
    return out;
}

std::string list(std::span<const Point> points) {
    std::string out = " points=\"";
    for (const Point& p : points) out += number(p.x) + "," + number(p.y) + " ";
    out.back() = '"';
    return out;
}

std::string escaped(std::string_view words) {
    std::string out;
    for (const char letter : words) {
        if (letter == '<') {
            out += "&lt;";
        } else if (letter == '>') {
            out += "&gt;";
        } else if (letter == '&') {
            out += "&amp;";
        } else {
            out += letter;
        }
    }
    return out;
}

}  // namespace

double length(Point a) {
    return std::sqrt(a.x * a.x + a.y * a.y);
}
Point unit(Point a) {
    return (1 / length(a)) * a;
}

Canvas::Canvas(double width, double height, std::string_view description) {
    body_ = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width) + attribute("height", height) +
            " viewBox=\"0 0 " + number(width) + " " + number(height) + "\" role=\"img\">\n<title>" +
            escaped(description) + "</title>\n";
    box({0.5, 0.5}, width - 1, height - 1, {.stroke = "#e6e2d8", .width = 1, .fill = colour::paper}, 10);
}

void Canvas::line(Point from, Point to, const Style& style) {
    body_ += "<line" + attribute("x1", from.x) + attribute("y1", from.y) + attribute("x2", to.x) +
             attribute("y2", to.y) + look(style) + "/>\n";
}

void Canvas::polyline(std::span<const Point> points, const Style& style) {
    body_ += "<polyline" + list(points) + look(style) + "/>\n";
}

void Canvas::polygon(std::span<const Point> points, const Style& style) {
    body_ += "<polygon" + list(points) + look(style) + "/>\n";
}

void Canvas::circle(Point centre, double radius, const Style& style) {
    body_ += "<circle" + attribute("cx", centre.x) + attribute("cy", centre.y) + attribute("r", radius) + look(style) +
             "/>\n";
}

void Canvas::ellipse(Point centre, double radius_x, double radius_y, double degrees, const Style& style) {
    body_ += "<ellipse" + attribute("rx", radius_x) + attribute("ry", radius_y) + " transform=\"translate(" +
             number(centre.x) + " " + number(centre.y) + ") rotate(" + number(degrees) + ")\"" + look(style) + "/>\n";
}

void Canvas::box(Point corner, double width, double height, const Style& style, double rounding) {
    body_ += "<rect" + attribute("x", corner.x) + attribute("y", corner.y) + attribute("width", width) +
             attribute("height", height) + (rounding > 0 ? attribute("rx", rounding) : std::string()) + look(style) +
             "/>\n";
}

void Canvas::arrow(Point from, Point to, const Style& style) {
    const Point ahead = unit(to - from);
    const Point aside{-ahead.y, ahead.x};
    const double size = 5 + 2 * style.width;
    const Point neck = to - size * ahead;
    line(from, neck, style);
    const Point head[] = {to, neck + 0.42 * size * aside, neck - 0.42 * size * aside};
    polygon(head, {.stroke = style.stroke, .width = 0.6, .fill = style.stroke, .opacity = style.opacity});
}

void Canvas::dot(Point at, std::string_view fill, double radius) {
    circle(at, radius, {.stroke = colour::paper, .width = 1.2, .fill = fill});
}

void Canvas::right_angle(Point corner, Point along, Point other, double size) {
    const Point u = size * unit(along - corner);
    const Point v = size * unit(other - corner);
    const Point mark[] = {corner + u, corner + u + v, corner + v};
    polyline(mark, {.stroke = colour::quiet, .width = 1.1});
}

void Canvas::text(Point at, std::string_view words, const Lettering& lettering) {
    static constexpr std::string_view anchors[] = {"start", "middle", "end"};
    body_ += "<text" + attribute("x", at.x) + attribute("y", at.y) + attribute("font-size", lettering.size) +
             attribute("fill", lettering.fill) +
             attribute("font-family", lettering.mono ? "ui-monospace,'DejaVu Sans Mono',Menlo,Consolas,monospace"
                                                     : "'Segoe UI','Helvetica Neue','DejaVu Sans',Arial,sans-serif");
    if (lettering.anchor != Anchor::start) {
        body_ += attribute("text-anchor", anchors[static_cast<int>(lettering.anchor)]);
    }
    if (lettering.bold) body_ += " font-weight=\"600\"";
    if (lettering.italic) body_ += " font-style=\"italic\"";
    body_ += '>';
    body_ += escaped(words);
    body_ += "</text>\n";
}

std::string Canvas::svg() const {
    return body_ + "</svg>\n";
}

std::vector<Point> View::operator()(std::span<const Point> points) const {
    std::vector<Point> out;
    out.reserve(points.size());
    for (const Point& p : points) out.push_back((*this)(p));
    return out;
}

}  // namespace pictures
