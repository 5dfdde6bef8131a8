// The pictures of docs/method.md about the question, and about what an answer needs. Times, points, normals and gaps
// are those that the library's own sweep reports.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <surefoot/overlap.hpp>
#include <surefoot/sweep.hpp>
#include <surefoot/trace.hpp>

#include "canvas.hpp"
#include "scene.hpp"
#include "sheets.hpp"

namespace pictures {
namespace {

constexpr Lettering quiet_label{.size = 13.5, .fill = colour::quiet};
constexpr Lettering title{.size = 14, .fill = colour::quiet, .anchor = Anchor::middle};

// Flat pictures are slices at z = 0. A triangle without area is the segment that it is.
surefoot::Triangle segment(Point p, Point q) {
    return {{p.x, p.y, 0}, {q.x, q.y, 0}, {q.x, q.y, 0}};
}
dvec3 in_space(Point p) {
    return {p.x, p.y, 0};
}
Point in_slice(const dvec3& p) {
    return {p.x, p.y};
}

std::string decimals(double value, const char* format = "%.3f") {
    char text[32];
    std::snprintf(text, sizeof(text), format, value);
    return text;
}

surefoot::Hit hit_or_stop(const std::optional<surefoot::Hit>& hit, const char* picture) {
    if (hit) return *hit;
    std::fprintf(stderr, "%s: the sweep meets nothing\n", picture);
    std::exit(1);
}

std::vector<Point> round_points(Point centre, double radius_x, double radius_y) {
    std::vector<Point> points;
    for (int i = 0; i < 96; ++i) {
        const double angle = 2 * std::numbers::pi * i / 96;
        points.push_back({centre.x + radius_x * std::cos(angle), centre.y + radius_y * std::sin(angle)});
    }
    return points;
}

std::string draw_question() {
    Canvas c(760, 330, "A ball that moves against a segment is a point that moves against the thickened segment.");
    const Point p{-1.15, -0.35}, q{1.35, 0.15}, from{-1.05, 1.05}, to{1.0, -0.75};
    const double radius = 0.5;
    const surefoot::Hit hit = hit_or_stop(
        surefoot::sweep(surefoot::Sphere{radius}, {in_space(from), in_space(to)}, segment(p, q)), "question");
    const Point stop = from + hit.t * (to - from);
    const Point touch = in_slice(hit.point), normal = in_slice(hit.normal);

    const View world{{190, 186}, 96};
    c.text({200, 34}, "a shape K against a triangle T", title);
    c.line(world(p), world(q), {.stroke = colour::ground, .width = 4});
    c.circle(world(from), 96 * radius, {.stroke = colour::shape, .width = 1.3, .dashed = true});
    c.circle(world(stop), 96 * radius,
             {.stroke = colour::shape, .width = 1.8, .fill = colour::shape_fill, .opacity = 0.85});
    c.line(world(stop), world(to), {.stroke = colour::motion, .width = 1.3, .dashed = true});
    c.arrow(world(from), world(stop), {.stroke = colour::motion, .width = 1.8});
    c.arrow(world(touch), world(touch + 0.42 * normal), {.stroke = colour::touch, .width = 2});
    c.dot(world(from), colour::motion);
    c.dot(world(stop), colour::motion);
    c.dot(world(touch), colour::touch);
    c.text(world(from) + Point{-6, -10}, "A", {.size = 15, .fill = colour::motion, .anchor = Anchor::end});
    c.text(world(to) + Point{8, 4}, "B", {.size = 15, .fill = colour::motion});
    c.text(world(q) + Point{2, 22}, "T", {.size = 16, .fill = colour::ground, .italic = true});
    c.text(world(stop) + Point{-34, -14}, "K", {.size = 16, .fill = colour::shape, .italic = true});

    const View fat{{562, 186}, 96};
    c.text({562, 34}, "a point against M = T ⊕ −K", title);
    std::vector<Point> around = round_points(p, radius, radius);
    const std::vector<Point> other = round_points(q, radius, radius);
    around.insert(around.end(), other.begin(), other.end());
    c.polygon(fat(hull(around)), {.stroke = colour::ground, .width = 1.8, .fill = colour::ground_fill});
    c.line(fat(p), fat(q), {.stroke = colour::ground, .width = 1.2, .dashed = true});
    const Point along = unit(Point{-normal.y, normal.x});
    c.line(fat(stop - 1.25 * along), fat(stop + 1.25 * along), {.stroke = colour::plane, .width = 1.6});
    c.line(fat(stop), fat(to), {.stroke = colour::motion, .width = 1.3, .dashed = true});
    c.arrow(fat(from), fat(stop), {.stroke = colour::motion, .width = 1.8});
    c.arrow(fat(stop), fat(stop + 0.42 * normal), {.stroke = colour::touch, .width = 2});
    c.dot(fat(from), colour::motion);
    c.dot(fat(stop), colour::touch);
    c.text(fat(from) + Point{-6, -10}, "A", {.size = 15, .fill = colour::motion, .anchor = Anchor::end});
    c.text(fat(to) + Point{8, 4}, "B", {.size = 15, .fill = colour::motion});
    c.text(fat(q) + Point{-8, 36}, "M", {.size = 16, .fill = colour::ground, .italic = true});
    c.text(fat(stop) + Point{8, -42}, "the plane at the touch", {.size = 13.5, .fill = colour::plane});
    c.text({380, 306}, "t* = " + decimals(hit.t, "%.4f"),
           {.size = 15, .fill = colour::touch, .anchor = Anchor::middle, .mono = true});
    return c.svg();
}

// The signed distance between the ball and the triangle, as the static question answers it: a much larger ball at the
// same place overlaps the triangle by its radius less the distance.
double true_gap(const dvec3& centre, double radius, const surefoot::Triangle& triangle) {
    const double large = 64;
    const auto found = surefoot::overlap(surefoot::Sphere{large}, centre, triangle);
    return found ? large - found->depth - radius : 0;
}

std::string draw_gaps() {
    Canvas c(760, 400, "The gap to each candidate plane is a straight line in t; the true gap lies above all of them.");
    const surefoot::Triangle triangle{{-0.9, 0.0, 0.8}, {1.4, -0.35, 0.5}, {0.1, 0.3, -1.2}};
    const surefoot::Motion motion{{-2.3, 1.25, 0.9}, {0.7, -0.2, 0.25}};
    const double radius = 0.5;
    std::array<surefoot::TraceRecord, 64> room;
    surefoot::Trace trace(room);
    const surefoot::Hit hit =
        hit_or_stop(surefoot::sweep(surefoot::Sphere{radius}, motion, triangle, {}, &trace), "gaps");

    const double left = 78, right = 590, zero = 258, metre = 118;
    const auto at = [&](double t, double gap) { return Point{left + (right - left) * t, zero - metre * gap}; };
    const double highest = 1.72, lowest = -0.92;

    for (const surefoot::TraceRecord& record : trace.records()) {
        if (record.verdict == surefoot::Verdict::decided) continue;
        // The part of the line that fits the sheet.
        double begin = 0, end = 1;
        const double slope = record.gap_to - record.gap_from;
        for (const double bound : {highest, lowest}) {
            if (slope == 0) continue;
            const double t = (bound - record.gap_from) / slope;
            const bool cuts_begin = (bound == highest) == (slope < 0);
            if (cuts_begin) begin = std::max(begin, t);
            if (!cuts_begin) end = std::min(end, t);
        }
        if (begin >= end) continue;
        const bool last = record.verdict == surefoot::Verdict::enters && std::abs(record.t - hit.t) < 1e-9;
        c.line(at(begin, record.gap_from + begin * slope), at(end, record.gap_from + end * slope),
               {.stroke = last ? colour::touch : colour::plane, .width = last ? 2.2 : 1.2, .opacity = last ? 1 : 0.55});
    }
    std::vector<Point> curve;
    for (int i = 0; i <= 120; ++i) {
        const double t = i / 120.0;
        const double gap = true_gap(motion.from + t * (motion.to - motion.from), radius, triangle);
        if (gap >= -radius * 0.98) curve.push_back(at(t, gap));
    }
    c.polyline(curve, {.stroke = colour::ink, .width = 2.6});

    c.arrow({left, at(0, lowest).y + 8}, {left, at(0, highest).y - 22}, {.stroke = colour::quiet, .width = 1.3});
    c.arrow({left, zero}, {right + 26, zero}, {.stroke = colour::quiet, .width = 1.3});
    c.text({left - 10, at(0, highest).y - 12}, "gap", {.size = 14, .fill = colour::quiet, .anchor = Anchor::end});
    c.text({left - 10, zero + 5}, "0", {.size = 14, .fill = colour::quiet, .anchor = Anchor::end});
    c.text({right + 34, zero + 5}, "t", {.size = 14, .fill = colour::quiet});
    c.line({right, zero - 4}, {right, zero + 4}, {.stroke = colour::quiet});
    c.text({right, zero + 22}, "1", {.size = 14, .fill = colour::quiet, .anchor = Anchor::middle});
    c.dot(at(hit.t, 0), colour::touch, 5.5);
    c.text(at(hit.t, 0) + Point{10, -12}, "t* = " + decimals(hit.t, "%.4f"),
           {.size = 15, .fill = colour::touch, .mono = true});

    const double key = 612;
    c.line({key, 60}, {key + 26, 60}, {.stroke = colour::ink, .width = 2.6});
    c.text({key + 34, 65}, "the true gap g", quiet_label);
    c.line({key, 88}, {key + 26, 88}, {.stroke = colour::plane, .width = 1.2, .opacity = 0.7});
    c.text({key + 34, 93}, "a candidate", quiet_label);
    c.line({key, 116}, {key + 26, 116}, {.stroke = colour::touch, .width = 2.2});
    c.text({key + 34, 121}, "the last one", quiet_label);
    c.text({key + 34, 139}, "to give way", quiet_label);
    return c.svg();
}

std::string draw_miss() {
    Canvas c(760, 392, "A motion that leaves one side of M before it enters another passes by.");
    const Point p{0.35, -0.1}, q{2.0, -0.55}, half{0.6, 0.45}, from{-1.95, -0.62}, to{0.75, 1.48};
    std::array<surefoot::TraceRecord, 64> room;
    surefoot::Trace trace(room);
    const auto hit = surefoot::sweep(surefoot::Box{{half.x, half.y, 0.3}}, {in_space(from), in_space(to)},
                                     segment(p, q), {}, &trace);
    const surefoot::TraceRecord *enters = nullptr, *leaves = nullptr, *separates = nullptr;
    for (const surefoot::TraceRecord& record : trace.records()) {
        if (record.verdict == surefoot::Verdict::separates) separates = &record;
        if (record.verdict == surefoot::Verdict::enters && (!enters || record.t > enters->t)) enters = &record;
        if (record.verdict == surefoot::Verdict::leaves && (!leaves || record.t < leaves->t)) leaves = &record;
    }
    if (hit || !enters || !leaves || !separates) {
        std::fputs("miss: the sweep should pass by, and say why\n", stderr);
        std::exit(1);
    }
    const View view{{310, 196}, 108};
    std::vector<Point> corners;
    for (const Point end : {p, q}) {
        for (const double x : {-1.0, 1.0}) {
            for (const double y : {-1.0, 1.0}) corners.push_back({end.x + x * half.x, end.y + y * half.y});
        }
    }
    c.polygon(view(hull(corners)), {.stroke = colour::ground, .width = 1.8, .fill = colour::ground_fill});
    c.line(view(p), view(q), {.stroke = colour::ground, .width = 3});
    c.text(view(1.55, -0.72), "M", {.size = 17, .fill = colour::ground, .italic = true});

    const Point corner{p.x - half.x, p.y + half.y};
    c.line(view(corner.x, -1.12), view(corner.x, 1.35), {.stroke = colour::plane, .width = 1.5});
    c.line(view(-2.0, corner.y), view(2.9, corner.y), {.stroke = colour::plane, .width = 1.5});
    const Point onward = unit(to - from);
    c.line(view(corner - 1.6 * onward), view(corner + 1.6 * onward),
           {.stroke = colour::touch, .width = 1.8, .dashed = true});
    c.arrow(view(from), view(to), {.stroke = colour::motion, .width = 2});
    c.dot(view(from), colour::motion);
    const Point at_leave = from + leaves->t * (to - from), at_enter = from + enters->t * (to - from);
    c.dot(view(at_leave), colour::plane, 4.5);
    c.dot(view(at_enter), colour::plane, 4.5);
    c.text(view(at_leave) + Point{-10, -10}, "t = " + decimals(leaves->t),
           {.size = 14, .fill = colour::plane, .anchor = Anchor::end, .mono = true});
    c.text(view(at_enter) + Point{-12, -6}, "t = " + decimals(enters->t),
           {.size = 14, .fill = colour::plane, .anchor = Anchor::end, .mono = true});
    const Point normal = in_slice(separates->normal);
    c.arrow(view(corner), view(corner + 0.4 * normal), {.stroke = colour::touch, .width = 2});
    c.text(view(corner + 1.5 * onward) + Point{14, 8}, "their combination, along the motion",
           {.size = 13.5, .fill = colour::touch});

    const double left = 90, width = 580, y = 352;
    const auto bar = [&](double begin, double end, double height, const char* words, bool before) {
        c.line({left + begin * width, height}, {left + end * width, height}, {.stroke = colour::plane, .width = 5});
        const double x = left + (before ? begin : end) * width;
        c.text({x, height - 9}, words,
               {.size = 13, .fill = colour::plane, .anchor = before ? Anchor::start : Anchor::end});
    };
    bar(0, enters->t, y - 14, "the left side keeps them apart", true);
    bar(leaves->t, 1, y + 8, "", false);
    c.text({left + width, y - 4}, "the upper side keeps them apart",
           {.size = 13, .fill = colour::plane, .anchor = Anchor::end});
    c.text({left - 10, y + 3}, "t = 0", {.size = 13, .fill = colour::quiet, .anchor = Anchor::end});
    c.text({left + width + 10, y + 3}, "1", {.size = 13, .fill = colour::quiet});
    return c.svg();
}

std::string draw_squash() {
    Canvas c(760, 360, "An ellipsoid on a slope in the world, and the ball on another slope in its squashed space.");
    const dvec3 radii{0.42, 0.95, 0.42};
    const Point p{-1.25, -0.85}, q{1.25, 0.05}, from{-0.62, 0.95}, to{0.12, 0.1};
    const surefoot::Hit hit = hit_or_stop(
        surefoot::sweep(surefoot::Ellipsoid{radii}, {in_space(from), in_space(to)}, segment(p, q)), "squash");
    const Point stop = from + hit.t * (to - from);
    const Point normal = in_slice(hit.normal);
    const Point squashed_normal = unit({normal.x * radii.x, normal.y * radii.y});
    const auto squash = [&](Point v) { return Point{v.x / radii.x, v.y / radii.y}; };

    const View world{{190, 212}, 104};
    c.text({200, 34}, "the world", title);
    c.line(world(p), world(q), {.stroke = colour::ground, .width = 4});
    c.ellipse(world(from), 104 * radii.x, 104 * radii.y, 0,
              {.stroke = colour::shape, .width = 1.2, .dashed = true, .opacity = 0.6});
    c.ellipse(world(stop), 104 * radii.x, 104 * radii.y, 0,
              {.stroke = colour::shape, .width = 1.8, .fill = colour::shape_fill, .opacity = 0.85});
    c.arrow(world(from), world(stop), {.stroke = colour::motion, .width = 1.8});
    const Point touch = in_slice(hit.point);
    c.arrow(world(touch), world(touch + 0.75 * squashed_normal),
            {.stroke = colour::quiet, .width = 1.6, .dashed = true});
    c.arrow(world(touch), world(touch + 0.75 * normal), {.stroke = colour::touch, .width = 2.2});
    c.dot(world(touch), colour::touch, 5);
    c.dot(world(stop), colour::motion);
    c.text(world(touch + 0.75 * normal) + Point{-10, -2}, "m / radii",
           {.size = 14, .fill = colour::touch, .anchor = Anchor::end});
    c.text(world(touch + 0.75 * squashed_normal) + Point{12, -2}, "m: wrong here", {.size = 14, .fill = colour::quiet});

    const View ball{{562, 212}, 50};
    c.text({562, 34}, "divided by the radii", title);
    c.line(ball(squash(p)), ball(squash(q)), {.stroke = colour::ground, .width = 4});
    c.circle(ball(squash(from)), 50, {.stroke = colour::shape, .width = 1.2, .dashed = true, .opacity = 0.6});
    c.circle(ball(squash(stop)), 50,
             {.stroke = colour::shape, .width = 1.8, .fill = colour::shape_fill, .opacity = 0.85});
    c.arrow(ball(squash(from)), ball(squash(stop)), {.stroke = colour::motion, .width = 1.8});
    const Point there = squash(touch);
    c.arrow(ball(there), ball(there + 1.7 * squashed_normal), {.stroke = colour::touch, .width = 2.2});
    c.dot(ball(there), colour::touch, 5);
    c.dot(ball(squash(stop)), colour::motion);
    c.text(ball(there + 1.7 * squashed_normal) + Point{10, 0}, "m",
           {.size = 16, .fill = colour::touch, .italic = true});
    c.text({380, 338}, "the same t* = " + decimals(hit.t, "%.4f") + " in both",
           {.size = 14.5, .fill = colour::ink, .anchor = Anchor::middle});
    return c.svg();
}

std::string draw_start() {
    Canvas c(760, 262, "Five motions of a ball that begins in touch with a floor, and what the sweep says to each.");
    const struct {
        const char* words;
        double height;
        Point motion;
    } starts[] = {
        {"towards", 0.5, {0.3, -0.5}},      {"along", 0.5, {0.7, 0}},        {"away", 0.5, {0.35, 0.5}},
        {"sunk, deeper", 0.3, {0.3, -0.5}}, {"sunk, out", 0.3, {0.35, 0.5}},
    };
    const surefoot::Triangle floor{{-8, 0, -8}, {0, 0, 16}, {8, 0, -8}};
    const double width = 146;
    double left = 15;
    for (const auto& start : starts) {
        const dvec3 from(0, start.height, 0);
        const auto hit = surefoot::sweep(surefoot::Sphere{0.5}, {from, from + in_space(start.motion)}, floor);
        const View view{{left + width / 2, 166}, 92};
        c.box(view(-0.68, 0), 92 * 1.36, 16, {.stroke = colour::none, .fill = colour::ground_fill});
        c.line(view(-0.68, 0), view(0.68, 0), {.stroke = colour::ground, .width = 2.4});
        c.circle(view(in_slice(from)), 46,
                 {.stroke = colour::shape, .width = 1.7, .fill = colour::shape_fill, .opacity = 0.8});
        c.arrow(view(in_slice(from)), view(in_slice(from) + start.motion), {.stroke = colour::motion, .width = 2});
        c.dot(view(in_slice(from)), colour::motion);
        if (hit) c.dot(view(in_slice(hit->point)), colour::touch, 5);
        c.text({left + width / 2, 46}, start.words, {.size = 14, .fill = colour::quiet, .anchor = Anchor::middle});
        c.text({left + width / 2, 216}, hit ? "hit, t = " + decimals(hit->t, "%.0f") : "no hit",
               {.size = 15, .fill = hit ? colour::touch : colour::motion, .anchor = Anchor::middle, .bold = true});
        if (hit && hit->started_inside) {
            c.text({left + width / 2, 238}, "started_inside",
                   {.size = 12.5, .fill = colour::quiet, .anchor = Anchor::middle, .mono = true});
        }
        left += width;
    }
    return c.svg();
}

}  // namespace

std::span<const Picture> question_pictures() {
    static constexpr Picture all[] = {
        {"method-question", draw_question}, {"method-gaps", draw_gaps},   {"method-miss", draw_miss},
        {"method-squash", draw_squash},     {"method-start", draw_start},
    };
    return all;
}

}  // namespace pictures
