#include "playground/navigation/paint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace surefoot::playground::navigation_paint {
namespace {

using view::Colour;
using view::rgb;
using view::with_opacity;

constexpr double fill_lift = 0.03;  // above the ground, so that it does not fight with it [m]
constexpr double line_lift = 0.05;
constexpr double path_lift = 0.09;
constexpr Colour gone = rgb(0x868E96);

// Beyond this the sides of polygons are a mush, and they are many on a large level.
constexpr double side_distance = 70;  // [m]

void fill(view::Renderer& renderer, const DrapedPolygon& polygon, const dvec3& lift, Colour colour) {
    for (const auto& t : polygon.triangles) renderer.triangle(t[0] + lift, t[1] + lift, t[2] + lift, colour);
}

/// Strokes across a polygon, all over the mesh in the same lines.
void hatch(view::Renderer& renderer, const NavigationOutline& outline, const dvec3& up) {
    constexpr double spacing = 0.3;  // [m]
    const view::Across level = view::across(up);
    const dvec3 along = glm::normalize(level.first + level.second);
    std::array<double, 6> at{};
    double low = INFINITY;
    double high = -INFINITY;
    for (std::uint32_t i = 0; i < outline.corners; ++i) {
        at[i] = glm::dot(outline.corner[i], along);
        low = std::min(low, at[i]);
        high = std::max(high, at[i]);
    }
    constexpr double most = 400;
    if (!(high - low < most * spacing)) return;
    for (double line = std::ceil(low / spacing) * spacing; line < high; line += spacing) {
        std::array<dvec3, 2> ends{};
        std::size_t found = 0;
        for (std::uint32_t i = 0; i < outline.corners && found < 2; ++i) {
            const std::uint32_t k = (i + 1) % outline.corners;
            if ((at[i] < line) == (at[k] < line)) continue;
            ends[found++] =
                outline.corner[i] + (outline.corner[k] - outline.corner[i]) * ((line - at[i]) / (at[k] - at[i]));
        }
        if (found == 2)
            renderer.line(ends[0] + up * line_lift, ends[1] + up * line_lift,
                          {.colour = with_opacity(gone, 0.9), .width = 1, .behind = 0});
    }
}

std::vector<dvec3> lifted(const std::vector<dvec3>& line, const dvec3& by) {
    std::vector<dvec3> up;
    up.reserve(line.size());
    for (const dvec3& place : line) up.push_back(place + by);
    return up;
}

}  // namespace

Colour area_colour(std::uint32_t area) {
    constexpr std::array<Colour, 4> colours{rgb(0x20C0A8), rgb(0xA5D8FF), rgb(0xE599F7), rgb(0xFFA94D)};
    return colours[area % colours.size()];
}

Colour link_colour(NavigationLinkKind kind) {
    switch (kind) {
        case NavigationLinkKind::drop:
            return rgb(0x1C7ED6);
        case NavigationLinkKind::jump:
            return rgb(0xFF922B);
        case NavigationLinkKind::step_up:
            return rgb(0x94D82D);
        case NavigationLinkKind::ladder:
            break;
    }
    return rgb(0xDA77F2);
}

void mesh(view::Renderer& renderer, const NavigationScene& scene) {
    const dvec3& up = scene.up();
    const dvec3 eye = renderer.view().camera.eye;
    const auto areas = scene.mesh.areas();
    for (std::size_t k = 0; k < scene.outlines.size(); ++k) {
        const NavigationOutline& outline = scene.outlines[k];
        const DrapedPolygon& draped = scene.draped[k];
        const bool shut = outline.area < areas.size() && areas[outline.area].closed;
        const Colour own = outline.taken_out ? gone : shut ? view::paint::start : area_colour(outline.area);
        fill(renderer, draped, up * fill_lift, with_opacity(own, outline.taken_out ? 0.5 : 0.3));
        if (glm::length(outline.corner[0] - eye) > side_distance) continue;
        if (outline.taken_out || shut) hatch(renderer, outline, up);
        for (std::uint32_t i = 0; i < outline.corners; ++i) {
            const NavigationPolygon beside = outline.beside[i];
            if (beside && beside.id < outline.polygon.id) continue;  // the other one draws it
            const std::vector<dvec3> side = lifted(draped.sides[i], up * line_lift);
            const Colour dark = view::mixed(own, view::paint::ink, 0.45);
            if (beside) {
                renderer.polyline(side, {.colour = with_opacity(dark, 0.55), .width = 1, .behind = 0});
            } else {
                renderer.polyline(side, {.colour = with_opacity(dark, 0.95), .width = 2.2, .behind = 0.08});
            }
        }
    }
}

void portals(view::Renderer& renderer, const NavigationScene& scene, const NavigationPath& path) {
    const dvec3 lift = scene.up() * path_lift;
    for (const NavigationPortal& p : path.portals) {
        renderer.line(p.left + lift, p.right + lift, {.colour = portal, .width = 3, .behind = 0.15});
        renderer.point(p.left + lift, 6, view::paint::start, 0.15);
        renderer.point(p.right + lift, 6, view::paint::end, 0.15);
    }
}

void raw_path(view::Renderer& renderer, const NavigationScene& scene, const NavigationWay& way) {
    const dvec3 lift = scene.up() * path_lift;
    renderer.polyline(lifted(way.raw_line(), lift), {.colour = raw, .width = 2, .behind = 0.2});
    for (const dvec3& middle : way.path()->midpoints) renderer.point(middle + lift, 7, raw, 0.2);
}

void pulled_path(view::Renderer& renderer, const NavigationScene& scene, const NavigationWay& way) {
    const dvec3 lift = scene.up() * path_lift;
    const std::vector<dvec3> line = lifted(way.pulled_line(), lift);
    renderer.polyline(line, {.colour = view::paint::ink, .width = 6.5, .behind = 0.1});
    renderer.polyline(line, {.colour = pulled, .width = 4, .behind = 0.45});
    for (const NavigationCorner& corner : way.path()->corners) {
        renderer.point(corner.position + lift, 12, view::paint::ink, 0.2);
        renderer.point(corner.position + lift, 8, pulled, 0.5);
    }
}

void links(view::Renderer& renderer, const NavigationScene& scene) {
    const dvec3 lift = scene.up() * line_lift;
    for (const LinkArc& arc : scene.arcs) {
        const Colour colour = link_colour(arc.kind);
        const std::vector<dvec3> line = lifted(arc.places, lift);
        renderer.polyline(line, {.colour = colour, .width = 2.5, .behind = 0.25});
        renderer.point(line.front(), 7, colour, 0.25);
        // The arrow's head points the way that the last strides went.
        constexpr double head = 0.5;  // [m]
        std::size_t before = line.size() - 1;
        while (before > 0 && glm::length(line[before] - line.back()) < head) --before;
        if (before + 1 < line.size())
            renderer.arrow(line[before], line.back(), {.colour = colour, .width = 2.5, .behind = 0.25}, 12);
    }
}

void search(view::Renderer& renderer, const NavigationScene& scene, std::span<const NavigationSearchNode> nodes,
            const NavigationSearchNode* looked_at) {
    const dvec3& up = scene.up();
    for (const NavigationSearchNode& node : nodes) {
        const Colour colour = node.open ? open_node : closed_node;
        if (const DrapedPolygon* const polygon = scene.draped_of(node.polygon))
            fill(renderer, *polygon, up * line_lift, with_opacity(colour, 0.55));
        renderer.point(node.position + up * path_lift, 6, view::mixed(colour, view::paint::ink, 0.3), 0.1);
    }
    if (looked_at == nullptr) return;
    if (const DrapedPolygon* const polygon = scene.draped_of(looked_at->polygon))
        for (const std::vector<dvec3>& side : polygon->sides)
            renderer.polyline(lifted(side, up * path_lift), {.colour = closed_node, .width = 4, .behind = 0.5});
    renderer.label(
        {.place = looked_at->position + up * 0.5,
         .text = fmt::format("{:.1f} m to here, {:.1f} m in all at least", looked_at->cost, looked_at->estimate),
         .behind = 1,
         .yields = true});
}

void start(view::Renderer& renderer, const NavigationScene& scene, const dvec3& feet) {
    const dvec3& up = scene.up();
    const double radius = scene.mesh.agent().radius;
    renderer.circle(feet + up * path_lift, up, radius, {.colour = view::paint::start, .width = 4, .behind = 0.5});
    renderer.point(feet + up * path_lift, 9, view::paint::start, 0.5);
    renderer.label({.place = feet + up * 0.3, .text = "start", .behind = 0.6, .yields = true});
}

void target(view::Renderer& renderer, const NavigationTarget& target, bool is_hovered, bool is_reached) {
    const Colour colour = is_reached ? view::paint::end : gone;
    renderer.shape(
        target.shape(), target.middle(),
        {.colour = colour, .opacity = is_hovered ? 0.85 : 0.6, .outline = is_hovered ? 4.0 : 2.5, .behind = 0.6});
    renderer.label({.place = target.middle() + dvec3(0, target.shape().radii.y * 1.25, 0),
                    .text = is_reached ? "target" : "target, off the mesh",
                    .behind = 1,
                    .yields = true});
}

void runners(view::Renderer& renderer, const NavigationScene& scene, const NavigationRunners& runners, double waiting) {
    for (std::size_t i = 0; i < runners.size(); ++i) {
        const NavigationFollower& follower = runners.follower(i);
        const dvec3 place = runners.drawn_position(i, waiting);
        const NavigationFollowStatus status = follower.status();
        const Colour colour = status == NavigationFollowStatus::arrived   ? view::paint::end
                              : status == NavigationFollowStatus::gave_up ? view::paint::start
                                                                          : view::paint::hit;
        renderer.shape(scene.settings.volume, place, {.colour = colour, .opacity = 0.85, .outline = 2});
        if (status != NavigationFollowStatus::following) continue;
        const dvec3 feet = place - scene.up() * (scene.mesh.agent().feet - path_lift);
        renderer.line(feet, follower.heading_for() + scene.up() * path_lift,
                      {.colour = with_opacity(colour, 0.9), .width = 1.5, .behind = 0.2});
    }
}

}  // namespace surefoot::playground::navigation_paint
