#include "playground/debugger_room/contest_view.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <tuple>
#include <vector>

#include "playground/debugger_room/framing.hpp"
#include "playground/debugger_room/lesson_view.hpp"
#include "playground/debugger_room/scenery.hpp"

namespace surefoot::playground {

namespace {

using view::rgb;
namespace paint = view::paint;

constexpr double half_wedge = 0.75;    // of a slope, along x [m]
constexpr double wedge_spacing = 1.9;  // [m]
constexpr double half_lane = 0.53;     // [m]
constexpr double plinth = 0.22;        // under the lowest point of a course [m]
constexpr double half_height = 0.9;    // of a contestant [m]

constexpr view::Colour ground = rgb(0xC6C0B2);
constexpr view::Colour ground_side = rgb(0x9AA3AA);

/// Beside each other, as seen from where one usually stands.
dvec3 lane(Course course, std::size_t i) {
    const double rank = double(i) - 2;
    if (course == Course::slope) return rightwards * (rank * wedge_spacing);
    // Stairs are longer than high, and go away to the left.
    return dvec3(0.7, 0, -1.15) * rank + (course == Course::stairs ? rightwards * 1.3 : dvec3(0));
}

/// Courses that rise do so away from where one usually stands.
bool turned(Course course) {
    return course != Course::ledge;
}

double lowest(const Contest& contest) {
    switch (contest.course()) {
        case Course::slope:
            return -half_wedge * std::tan(contest.angle()) - plinth;
        case Course::stairs:
            return -plinth;
        case Course::ledge:
            break;
    }
    return -3 - plinth;
}

std::vector<dvec3> profile(const Contest& contest) {
    switch (contest.course()) {
        case Course::slope: {
            const double rise = half_wedge * std::tan(contest.angle());
            return {{-half_wedge, -rise, 0}, {half_wedge, rise, 0}};
        }
        case Course::stairs: {
            const debugger::Stairs stairs;
            std::vector<dvec3> top{{-2.2, 0, 0}, {0, 0, 0}};
            for (int k = 0; k < stairs.count; ++k) {
                const double run = k + 1 == stairs.count ? 5.2 : stairs.run;
                top.push_back(top.back() + dvec3(0, stairs.rise, 0));
                top.push_back(top.back() + dvec3(run, 0, 0));
            }
            return top;
        }
        case Course::ledge:
            break;
    }
    return {{-1.7, 0, 0}, {0, 0, 0}, {0, -3, 0}, {2.6, -3, 0}};
}

/// A measured length: a bar with a stroke across either end, on a darker one that sets it off.
void draw_measure(view::Renderer& renderer, const dvec3& from, const dvec3& to, const dvec3& across) {
    for (const auto& [colour, wider] : {std::pair(paint::ink, 3.0), std::pair(paint::contact, 0.0)}) {
        renderer.line(from, to, {.colour = colour, .width = 4 + wider, .behind = 1});
        for (const dvec3& end : {from, to})
            renderer.line(end - across, end + across, {.colour = colour, .width = 2 + wider, .behind = 1});
    }
}

/// Are wedges so far apart on the picture that labels with words do not run into each other?
bool has_room_for_words(const view::FrameView& view) {
    constexpr double widest = 116;  // of such a label, in window units
    const auto one = view.camera.project(lane(Course::slope, 2), view.size);
    const auto next = view.camera.project(lane(Course::slope, 3), view.size);
    return one && next && std::abs(next->at.x - one->at.x) >= widest;
}

void draw_slope_reading(view::Renderer& renderer, const Contest& contest, std::size_t i) {
    const debugger::SlopeReading& reading = contest.slope(i);
    const dvec3 foot = ContestView::placed(contest, i, contest.foot(i));
    draw_measure(renderer, foot, foot - dvec3(0, reading.gap, 0), rightwards * 0.1);
    const double skin = reading.clearance / std::cos(contest.angle());
    const double form = reading.expected - skin;
    std::string text =
        fmt::format("gap {:.1f} mm\nform {:.1f}\nskin {:.1f}", reading.gap * 1e3, form * 1e3, skin * 1e3);
    if (!has_room_for_words(renderer.view()))
        text = fmt::format("{:.1f}\n{:.1f}\n{:.1f}", reading.gap * 1e3, form * 1e3, skin * 1e3);
    const double y = -half_wedge * std::tan(contest.angle()) - plinth;
    renderer.label({.place = lane(Course::slope, i) + dvec3(0, y, half_lane),
                    .text = text,
                    .colour = paint::contact,
                    .offset = {0, 42}});
}

void draw_overhang(view::Renderer& renderer, const Contest& contest, std::size_t i) {
    const dvec3 foot = contest.foot(i);
    if (foot.x <= 0) return;
    const dvec3 edge(0, foot.y, 0);
    const auto place = [&](const dvec3& p) { return ContestView::placed(contest, i, p); };
    draw_measure(renderer, place(edge), place(foot), {0, 0.08, 0});
    if (contest.shows_sunk() && has_room_for_words(renderer.view()))  // else the table tells
        renderer.label({.place = place({foot.x, foot.y, half_lane}),
                        .text = fmt::format("{:.0f} mm", foot.x * 1e3),
                        .colour = paint::contact,
                        .offset = {30, 22}});
}

}  // namespace

view::Colour colour_of_contestant(std::size_t i) {
    static constexpr view::Colour all[] = {rgb(0x5B9BD5), rgb(0xE59A3C), rgb(0xD9688F), rgb(0x4FAE7B), rgb(0x9680D6)};
    return all[i % Contest::count];
}

const char* formula_of_contestant(std::size_t i) {
    static constexpr const char* all[] = {"w tan α", "w tan α", "max(0, w tan α − 2h)", "√(w² tan² α + h²) − h",
                                          "w / cos α − w"};
    return all[i % Contest::count];
}

dvec3 ContestView::placed(const Contest& contest, std::size_t i, const dvec3& place) {
    const Course course = contest.course();
    dvec3 local = place;
    // On a slope it does not matter where along it a shape came to rest: all are shown in the middle of their wedges.
    if (course == Course::slope) {
        const dvec3 rest = contest.position(i);
        local -= dvec3(rest.x, rest.x * std::tan(contest.angle()), 0);
    }
    return (turned(course) ? half_turned(local) : local) + lane(course, i);
}

std::vector<dvec3> ContestView::places(const Contest& contest) {
    const Course course = contest.course();
    // A slope is turned by a hand on a slider, and the camera does not follow every degree.
    constexpr double usual = 0.7;  // how far a wedge reaches below its middle, with what is written there [m]
    double low = -usual;
    double high = usual;
    double left = -half_wedge;
    double right = half_wedge;
    if (course != Course::slope) {
        low = high = 0;
        for (const dvec3& p : profile(contest)) {
            low = std::min(low, p.y - plinth);
            high = std::max(high, p.y);
            left = std::min(left, p.x);
            right = std::max(right, p.x);
        }
    }
    std::vector<dvec3> corners;
    for (const std::size_t i : {std::size_t{0}, Contest::count - 1}) {
        Bounds around{{left, low, -half_lane}, {right, high + 2 * half_height, half_lane}};
        if (turned(course)) std::tie(around.min.x, around.max.x) = std::pair(-right, -left);
        const dvec3 offset = lane(course, i);
        append_corners(corners, {around.min + offset, around.max + offset});
    }
    return corners;
}

void ContestView::build(const Contest& contest) {
    built_course_ = contest.course();
    built_angle_ = contest.angle();
    const std::vector<dvec3> top = profile(contest);
    Scenery scenery;
    for (std::size_t i = 0; i < Contest::count; ++i)
        scenery.add({.top = top,
                     .base = lowest(contest),
                     .half = half_lane,
                     .offset = lane(contest.course(), i),
                     .turned = turned(contest.course()),
                     .colour = view::mixed(ground, colour_of_contestant(i), 0.10),
                     .side = view::mixed(ground_side, colour_of_contestant(i), 0.18)});
    model_ = scenery.model();
}

void ContestView::draw(view::Renderer& renderer, const Contest& contest) {
    if (!model_ || built_course_ != contest.course() || built_angle_ != contest.angle()) build(contest);
    view::EdgeLook edges{.width = 1.2};
    edges.kinds[static_cast<std::size_t>(EdgeKind::flat)] = view::with_opacity(paint::ink, 0);
    renderer.model(model_, {.edges = edges});
    // Where names would run into each other, every other one stands higher.
    const bool staggered = contest.course() == Course::stairs || !has_room_for_words(renderer.view());
    for (std::size_t i = 0; i < Contest::count; ++i) {
        const view::Colour colour = colour_of_contestant(i);
        const auto place = [&](const dvec3& p) { return placed(contest, i, p); };
        renderer.shape(contest.contestant(i).shape, place(contest.position(i)),
                       {.colour = colour, .opacity = 0.72, .outline = 2, .behind = 0.25});
        renderer.label({.place = place(contest.foot(i) + dvec3(0, 2 * half_height, 0)),
                        .text = contest.contestant(i).name,
                        .colour = view::mixed(colour, paint::paper, 0.45),
                        .offset = {0, staggered && i % 2 == 1 ? -42 : -18}});
        if (contest.course() == Course::slope) draw_slope_reading(renderer, contest, i);
        if (contest.course() == Course::ledge) draw_overhang(renderer, contest, i);
        std::vector<dvec3> prints = contest.footprints(i);
        for (dvec3& print : prints) print = place(print);
        if (prints.size() > 1)
            renderer.polyline(prints, {.colour = view::mixed(colour, paint::ink, 0.15), .width = 3, .behind = 0.45});
    }
}

}  // namespace surefoot::playground
