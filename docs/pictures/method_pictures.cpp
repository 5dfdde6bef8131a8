// The pictures of docs/method.md about the closed forms.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "canvas.hpp"
#include "scene.hpp"
#include "sheets.hpp"

namespace pictures {
namespace {

constexpr Lettering quiet_label{.size = 13.5, .fill = colour::quiet};
constexpr Lettering title{.size = 14, .fill = colour::quiet, .anchor = Anchor::middle};

std::vector<Point> arc(const View& view, Point centre, double radius, double from, double to, int steps = 48) {
    std::vector<Point> points;
    for (int i = 0; i <= steps; ++i) {
        const double angle = from + (to - from) * i / steps;
        points.push_back(view(centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)));
    }
    return points;
}

// Entry and exit of a point that passes a disc: the chord.
std::string draw_chord() {
    Canvas c(760, 344,
             "A line of motion that cuts a circle: the closest approach w, and half the chord h on either side.");
    const View view{{272, 206}, 100};
    const double radius = 1.15, distance = 0.62;
    const double half = std::sqrt(radius * radius - distance * distance);
    c.circle(view(0, 0), 100 * radius, {.stroke = colour::ground, .width = 1.8, .fill = colour::ground_fill});
    c.arrow(view(-2.3, distance), view(2.0, distance), {.stroke = colour::motion, .width = 1.8});
    c.line(view(0, 0), view(0, distance), {.stroke = colour::plane, .width = 2});
    c.right_angle(view(0, distance), view(-1, distance), view(0, 0));
    c.arrow(view(0, 0), view(-half, distance), {.stroke = colour::touch, .width = 2.2});
    c.line(view(0, 0), view(half, distance), {.stroke = colour::quiet, .width = 1.4, .dashed = true});
    c.dot(view(0, 0), colour::ground, 5);
    c.dot(view(-half, distance), colour::touch, 5);
    c.dot(view(half, distance), colour::quiet, 4.5);
    c.dot(view(0, distance), colour::plane, 4.5);
    c.dot(view(-2.1, distance), colour::motion, 4.5);
    c.text(view(-2.1, distance) + Point{-2, -12}, "A", {.size = 15, .fill = colour::motion});
    c.text(view(0.06, 0.28), "w", {.size = 16, .fill = colour::plane, .italic = true});
    c.text(view(-0.74, 0.2), "R", {.size = 16, .fill = colour::touch, .italic = true});
    c.text(view(-0.52, distance) + Point{0, -9}, "h", {.size = 16, .fill = colour::ink, .italic = true});
    c.text(view(0.45, distance) + Point{0, -9}, "h", {.size = 16, .fill = colour::ink, .italic = true});
    c.text(view(1.75, distance) + Point{0, -10}, "u", {.size = 16, .fill = colour::motion, .italic = true});
    c.text(view(0, 0) + Point{0, 24}, "feature", {.size = 13.5, .fill = colour::ground, .anchor = Anchor::middle});
    c.text(view(-half, distance) + Point{-12, -14}, "entry",
           {.size = 14, .fill = colour::touch, .anchor = Anchor::end});
    c.text(view(half, distance) + Point{10, -14}, "exit", {.size = 14, .fill = colour::quiet});

    const double x = 516;
    c.text({x, 106}, "h = √( (R − |w|)(R + |w|) )", {.size = 15});
    c.text({x, 146}, "entry normal  w − h u", {.size = 15, .fill = colour::touch});
    c.text({x, 172}, "exit normal   w + h u", {.size = 15, .fill = colour::quiet});
    c.text({x, 212}, "|w| ≥ R: the line passes by,", {.size = 15, .fill = colour::plane});
    c.text({x, 234}, "and w itself separates", {.size = 15, .fill = colour::plane});
    return c.svg();
}

// A triangle thickened by a ball, seen from above: the patches that face the viewer.
std::string draw_patches() {
    Canvas c(760, 352, "A triangle thickened by a ball: a flat patch, three pieces of cylinder, three pieces of ball.");
    const dvec3 corners[3] = {{-1.5, 0.1, 0.9}, {1.6, -0.1, 0.6}, {0.2, 0.2, -1.6}};
    const double radius = 0.5;
    const Camera camera(20, 38, {300, 190}, 110);
    const dvec3 normal = unit(cross(corners[1] - corners[0], corners[2] - corners[0]));
    const dvec3 eye = camera.towards_viewer();

    std::vector<Point> everything;
    for (const dvec3& corner : corners) {
        for (int i = 0; i < 120; ++i) {
            const double angle = 2 * std::numbers::pi * i / 120;
            everything.push_back(
                camera(corner + radius * (camera.right() * std::cos(angle) + camera.up() * std::sin(angle))));
        }
    }
    c.polygon(hull(everything), {.stroke = colour::touch, .width = 1.8, .fill = "#f6e2dc"});

    // Each piece of cylinder from the face's normal outwards, as far as it faces the viewer.
    for (int i = 0; i < 3; ++i) {
        const dvec3 a = corners[i], b = corners[(i + 1) % 3];
        const dvec3 outward = unit(cross(b - a, normal));
        std::vector<Point> start, end;
        for (int step = 0; step <= 60; ++step) {
            const double angle = std::numbers::pi * step / 60;
            const dvec3 m = normal * std::cos(angle) + outward * std::sin(angle);
            if (dot(m, eye) < 0) break;
            start.push_back(camera(a + radius * m));
            end.push_back(camera(b + radius * m));
        }
        std::vector<Point> patch = start;
        patch.insert(patch.end(), end.rbegin(), end.rend());
        c.polygon(patch, {.stroke = colour::none, .fill = colour::plane_fill});
        c.polyline(start, {.stroke = colour::plane, .width = 1.2});
        c.polyline(end, {.stroke = colour::plane, .width = 1.2});
    }
    c.polygon(hull(everything), {.stroke = colour::ink, .width = 1.6});
    std::vector<Point> face;
    for (const dvec3& corner : corners) face.push_back(camera(corner + radius * normal));
    c.polygon(face, {.stroke = colour::ground, .width = 1.8, .fill = colour::ground_fill});
    std::vector<Point> inside;
    for (const dvec3& corner : corners) inside.push_back(camera(corner));
    inside.push_back(inside.front());
    c.polyline(inside, {.stroke = colour::ground, .width = 1.2, .dashed = true});

    const double x = 556;
    const auto key = [&](double y, std::string_view fill, std::string_view stroke, const char* words,
                         const char* more) {
        c.box({x, y - 13}, 22, 16, {.stroke = stroke, .width = 1.4, .fill = fill}, 3);
        c.text({x + 32, y}, words, {.size = 15});
        c.text({x + 32, y + 19}, more, quiet_label);
    };
    key(104, colour::ground_fill, colour::ground, "face", "the plane, moved out");
    key(164, colour::plane_fill, colour::plane, "edge", "a piece of cylinder");
    key(224, "#f6e2dc", colour::touch, "vertex", "a piece of ball");
    return c.svg();
}

// A capsule's M: the prism inside, and its thickened outline.
std::string draw_prism() {
    Canvas c(760, 330, "The triangle drawn out along the capsule's core is a prism; thickened by the radius it is M.");
    const dvec3 corners[3] = {{-1.2, 0.1, 0.8}, {1.3, -0.2, 0.5}, {0.2, 0.35, -1.2}};
    const double radius = 0.36, half = 0.5;
    const Camera camera(24, 26, {290, 172}, 104);
    std::vector<Point> everything;
    for (const dvec3& corner : corners) {
        for (int i = 0; i < 120; ++i) {
            const double angle = 2 * std::numbers::pi * i / 120;
            const dvec3 m = radius * (camera.right() * std::cos(angle) + camera.up() * std::sin(angle));
            for (const double end : {-half, half}) everything.push_back(camera(corner + dvec3(0, end, 0) + m));
        }
    }
    c.polygon(hull(everything), {.stroke = colour::ink, .width = 1.6, .fill = "#f4eee2"});
    const auto ring = [&](double height, const Style& style) {
        std::vector<Point> points;
        for (const dvec3& corner : corners) points.push_back(camera(corner + dvec3(0, height, 0)));
        c.polygon(points, style);
    };
    ring(-half, {.stroke = colour::ground, .width = 1.3, .opacity = 0.7});
    for (const dvec3& corner : corners) {
        c.line(camera(corner + dvec3(0, -half, 0)), camera(corner + dvec3(0, half, 0)),
               {.stroke = colour::shape, .width = 2.4});
    }
    ring(half, {.stroke = colour::ground, .width = 1.8, .fill = colour::ground_fill, .opacity = 0.85});
    std::vector<Point> middle;
    for (const dvec3& corner : corners) middle.push_back(camera(corner));
    middle.push_back(middle.front());
    c.polyline(middle, {.stroke = colour::ground, .width = 1.2, .dashed = true});

    const double x = 508;
    const auto key = [&](double y, std::string_view tint, double width, bool dashed, const char* words) {
        c.line({x, y - 5}, {x + 26, y - 5}, {.stroke = tint, .width = width, .dashed = dashed});
        c.text({x + 36, y}, words, {.size = 14.5});
    };
    key(108, colour::ground, 1.2, true, "the triangle");
    key(144, colour::shape, 2.4, false, "the capsule's core");
    key(180, colour::ground, 1.8, false, "the prism they make");
    key(216, colour::ink, 1.6, false, "M: the radius further out");
    return c.svg();
}

std::string draw_rim() {
    Canvas c(760, 322,
             "Where an edge crosses the plane of a rim is a point that moves on a line: a point that meets a circle.");
    // Left: in space. The edge comes down through the plane of the rim.
    const Camera camera(24, 34, {178, 196}, 90);
    const double radius = 1;
    std::vector<Point> circle, sheet;
    for (int i = 0; i < 120; ++i) {
        const double angle = 2 * std::numbers::pi * i / 120;
        circle.push_back(camera({radius * std::cos(angle), 0, radius * std::sin(angle)}));
    }
    for (const dvec3& p : {dvec3(-1.35, 0, 1.35), dvec3(2.1, 0, 1.35), dvec3(2.1, 0, -1.35), dvec3(-1.35, 0, -1.35)}) {
        sheet.push_back(camera(p));
    }
    c.text({200, 34}, "an edge through the plane of the rim", title);
    c.polygon(sheet, {.stroke = colour::faint, .width = 1.2, .fill = "#f4f2ec"});
    c.polygon(circle, {.stroke = colour::shape, .width = 2, .fill = colour::shape_fill, .opacity = 0.85});
    const dvec3 edge(0.35, 1.0, -0.2);
    const dvec3 meet(0.9, 0, 0.43588989), race = unit(dvec3(1, 0, -0.12));
    const dvec3 positions[] = {meet + 0.95 * race, meet + 0.48 * race, meet};
    double strength = 0.25;
    for (const dvec3& p : positions) {
        c.line(camera(p - 0.55 * edge), camera(p + 1.25 * edge),
               {.stroke = colour::ground, .width = 2.2, .opacity = strength});
        c.dot(camera(p), strength < 0.7 ? colour::quiet : colour::touch, 4.5);
        strength += 0.35;
    }
    c.text(camera(positions[2] + 1.25 * edge) + Point{-14, 0}, "e",
           {.size = 16, .fill = colour::ground, .anchor = Anchor::end, .italic = true});

    // Right: seen along the axis.
    const View view{{536, 186}, 96};
    c.text({560, 34}, "the same, seen along the axis", title);
    c.circle(view(0, 0), 96 * radius,
             {.stroke = colour::shape, .width = 2, .fill = colour::shape_fill, .opacity = 0.85});
    const auto flat = [&](const dvec3& p) { return Point{p.x, -p.z}; };
    const Point entry = flat(positions[2]);
    const Point direction = unit(flat(positions[2]) - flat(positions[0]));
    c.arrow(view(flat(positions[0]) - 0.2 * direction), view(entry), {.stroke = colour::motion, .width = 1.8});
    c.line(view(entry), view(entry + 2.2 * direction), {.stroke = colour::motion, .width = 1.3, .dashed = true});
    const double reach = -(entry.x * direction.x + entry.y * direction.y);
    const Point closest = entry + reach * direction;
    c.line(view(0, 0), view(closest), {.stroke = colour::plane, .width = 2});
    c.right_angle(view(closest), view(entry), view(0, 0));
    c.arrow(view(entry), view(0.3 * entry), {.stroke = colour::touch, .width = 2});
    for (const dvec3& p : positions) c.dot(view(flat(p)), &p == &positions[2] ? colour::touch : colour::quiet, 4.5);
    c.dot(view(closest + reach * direction), colour::quiet, 4.5);
    c.dot(view(0, 0), colour::shape, 4.5);
    c.text(view(0.5 * closest) + Point{8, 4}, "w", {.size = 16, .fill = colour::plane, .italic = true});
    c.text(view(0.3 * entry) + Point{4, -10}, "n, from above", {.size = 13.5, .fill = colour::touch});
    c.text(view(flat(positions[0])) + Point{4, -12}, "G", {.size = 16, .fill = colour::motion, .italic = true});
    return c.svg();
}

// The vertex's way against the double cone of the quadratic: one root on the cone, one on its mirror image.
std::string draw_nappe() {
    Canvas c(760, 366,
             "A line against a double cone: of the two roots of the quadratic one may lie on the mirror image below.");
    const View view{{280, 196}, 98};
    const double k = 0.55, height = 1.55;
    const Point cone[] = {view(0, 0), view(k * height, height), view(-k * height, height)};
    const Point mirror[] = {view(0, 0), view(k * 1.3, -1.3), view(-k * 1.3, -1.3)};
    c.polygon(mirror, {.stroke = colour::quiet, .width = 1.3, .dashed = true});
    c.polygon(cone, {.stroke = colour::shape, .width = 2, .fill = colour::shape_fill});
    c.line(view(0, -1.42), view(0, 1.72), {.stroke = colour::quiet, .width = 1.1, .dashed = true});
    // z(t) = z0 + s v
    const Point start{-0.6, -1.22}, along = unit(Point{0.2, 1});
    const auto meets = [&](double sign) {  // z.x = sign k z.y
        return (sign * k * start.y - start.x) / (along.x - sign * k * along.y);
    };
    const double first = meets(1), second = meets(-1);  // on the mirror, on the cone
    const Point low = start + std::min(first, second) * along, high = start + std::max(first, second) * along;
    c.line(view(start), view(start + 2.7 * along), {.stroke = colour::motion, .width = 1.3, .dashed = true});
    c.arrow(view(start), view(high.y > low.y ? high : low), {.stroke = colour::motion, .width = 1.9});
    c.dot(view(start), colour::motion);
    for (const Point& p : {low, high}) {
        const bool on_cone = p.y > 0;
        c.dot(view(p), on_cone ? colour::touch : colour::quiet, 5);
    }
    c.text(view(start) + Point{-14, 6}, "the vertex", {.size = 13.5, .fill = colour::motion, .anchor = Anchor::end});
    c.text(view(0.08, 1.64), "axis", quiet_label);
    c.text(view(0.55 * k, 0.55) + Point{30, 6}, "apex angle: tan = k = R / H", {.size = 14, .fill = colour::shape});
    const Point& real = low.y > 0 ? low : high;

    c.text(view(real) + Point{-14, -8}, "entry", {.size = 14, .fill = colour::touch, .anchor = Anchor::end});
    c.text(view(0.8, -0.42), "the other root is on the mirror image:", {.size = 13.5, .fill = colour::quiet});
    c.text(view(0.8, -0.62), "its plane is judged like any other, and does no harm",
           {.size = 13.5, .fill = colour::quiet});
    return c.svg();
}

std::string draw_hair() {
    Canvas c(
        760, 270,
        "The stop lies on the near side of the true surface, by a hair that is drawn here a billion times too wide.");
    const View view{{380, 150}, 118};
    const Point centre{0, -1.35};
    const double radius = 1.7, hair = 0.22;
    const double from = 0.20 * std::numbers::pi, to = 0.80 * std::numbers::pi;
    std::vector<Point> band = arc(view, centre, radius + hair, from, to);
    const std::vector<Point> inner = arc(view, centre, radius, to, from);
    band.insert(band.end(), inner.begin(), inner.end());
    std::vector<Point> body = arc(view, centre, radius, from, to);
    body.push_back(view(centre.x - radius * std::cos(from), -0.85));
    body.push_back(view(centre.x + radius * std::cos(from), -0.85));
    c.polygon(body, {.stroke = colour::none, .fill = colour::ground_fill});
    c.polygon(band, {.stroke = colour::none, .fill = colour::plane_fill});
    c.polyline(arc(view, centre, radius, from, to), {.stroke = colour::ground, .width = 2.2});
    c.polyline(arc(view, centre, radius + hair, from, to), {.stroke = colour::plane, .width = 1.4, .dashed = true});
    const Point n = unit(Point{-0.42, 1});
    const Point stop = centre + (radius + 0.7 * hair) * n;
    c.arrow(view(stop + Point{-1.75, 0.55}), view(stop), {.stroke = colour::motion, .width = 1.9});
    c.line(view(stop), view(stop + Point{1.4, -0.44}), {.stroke = colour::motion, .width = 1.2, .dashed = true});
    c.dot(view(stop), colour::touch, 5.5);
    c.text({452, 46}, "t*: somewhere in the band,", {.size = 14, .fill = colour::touch});
    c.text({452, 65}, "never below it", {.size = 14, .fill = colour::touch});
    c.text(view(1.62, -0.25), "one hair", {.size = 14, .fill = colour::plane});
    c.text(view(-0.1, -0.45), "M", {.size = 18, .fill = colour::ground, .italic = true});
    return c.svg();
}

}  // namespace

std::span<const Picture> method_pictures() {
    static constexpr Picture all[] = {
        {"method-chord", draw_chord}, {"method-patches", draw_patches}, {"method-prism", draw_prism},
        {"method-rim", draw_rim},     {"method-nappe", draw_nappe},     {"method-hair", draw_hair},
    };
    return all;
}

}  // namespace pictures
