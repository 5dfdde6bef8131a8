#include "playground/walk/step_overlay.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <imgui.h>
#include <span>

#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

namespace paint = view::paint;

constexpr view::Colour wall_colour = paint::start;
constexpr view::Colour probe_colour = view::rgb(0x9C5BD0);

bool is_plane(StepAct act) {
    return act == StepAct::obeyed || act == StepAct::wall || act == StepAct::seam || act == StepAct::met_neighbour;
}

bool is_touch(StepAct act) {
    return act == StepAct::touch || act == StepAct::obeyed || act == StepAct::passed_over;
}

view::Colour plane_colour(StepAct act) {
    return act == StepAct::wall ? wall_colour : act == StepAct::seam ? paint::vertex : paint::normal;
}

void draw_plane(view::Renderer& renderer, const StepRecord& record) {
    const view::Colour colour = plane_colour(record.act);
    const double size = record.act == StepAct::obeyed ? 0.32 : 0.26;
    renderer.circle(record.point, record.normal, size, {.colour = colour, .width = 2, .behind = 0.6});
    renderer.arrow(record.point, record.point + record.normal * (size * 1.6),
                   {.colour = colour, .width = 2.5, .behind = 0.6}, 12);
    if (record.act == StepAct::obeyed) return;
    renderer.label({.place = record.point + record.normal * (size * 1.6),
                    .text = record.act == StepAct::wall   ? "too steep: a wall"
                            : record.act == StepAct::seam ? "an inner edge: the face's plane"
                                                          : "a neighbour",
                    .behind = 1,
                    .yields = true});
}

void draw_contact(view::Renderer& renderer, const StepRecord& record, const World& world, bool with_name) {
    if (const auto triangle = world.triangle(record.body, record.triangle, 1)) {
        const dvec3 corners[3] = {triangle->a, triangle->b, triangle->c};
        renderer.polyline(corners, {.colour = paint::face, .width = 2, .behind = 0.35}, true);
    }
    renderer.point(record.point, record.act == StepAct::passed_over ? 6 : 11, paint::contact, 0.8);
    if (with_name)
        renderer.label({.place = record.point,
                        .text = fmt::format("triangle {}", record.triangle),
                        .offset = {0, 20},
                        .behind = 0.8,
                        .yields = true});
}

/// Up by the height of a step, ahead by its depth, and down again.
void draw_step_probe(view::Renderer& renderer, const StepRecord& record, double foot, double half_width) {
    const dvec3 up(0, 1, 0);
    const double way_length = glm::length(record.motion);
    const dvec3 ahead = way_length > 0 ? record.motion / way_length : dvec3(0);
    const dvec3 front = record.position - up * foot + ahead * half_width;
    const dvec3 high = front + up * record.value;
    const dvec3 over = high + ahead * record.limit;
    const dvec3 way[4] = {front, high, over, over - up * record.value};
    renderer.polyline(way, {.colour = probe_colour, .width = 2.5, .behind = 0.5});
    renderer.point(over, 8, probe_colour, 0.6);
}

void draw_ledge_probe(view::Renderer& renderer, const StepRecord& record) {
    const dvec3 end = record.position + record.motion * std::clamp(record.value, 0.0, 1.0);
    const bool met = record.value < 1;
    renderer.line(
        record.position, end,
        {.colour = view::with_opacity(probe_colour, met ? 1 : 0.45), .width = met ? 2.5 : 1.5, .behind = 0.5});
    renderer.point(end, met ? 9 : 5, probe_colour, 0.6);
}

/// The direction in which the step wanted to go; zero if it wanted to stay.
dvec3 way_of(const ToldStep& told) {
    dvec3 level = told.input.wish;
    level.y = 0;
    const double length = glm::length(level);
    return length > 0 ? level / length : dvec3(0);
}

double half_width_of(const Shape& shape) {
    if (const auto* const s = std::get_if<Sphere>(&shape)) return s->radius;
    if (const auto* const s = std::get_if<Ellipsoid>(&shape)) return std::max(s->radii.x, s->radii.z);
    if (const auto* const s = std::get_if<Capsule>(&shape)) return s->radius;
    if (const auto* const s = std::get_if<Box>(&shape)) return std::max(s->half_extents.x, s->half_extents.z);
    if (const auto* const s = std::get_if<Cylinder>(&shape)) return s->radius;
    return std::get<Cone>(shape).radius;
}

}  // namespace

std::string label_of(const StepRecord& record) {
    switch (record.act) {
        case StepAct::step_refused:
        case StepAct::ledge_refused: {
            const std::string what = record.act == StepAct::step_refused ? "no step" : "no edge";
            switch (record.rule) {
                case StepRule::step_height:
                    return fmt::format("{}: {:.2f} m high, {:.2f} allowed", what, record.value, record.limit);
                case StepRule::head_room:
                    return fmt::format("{}: room for {:.2f} of {:.2f} m above", what, record.value, record.limit);
                case StepRule::no_advance:
                    return fmt::format("{}: {:.2f} of {:.2f} m ahead", what, record.value, record.limit);
                case StepRule::slope_limit:
                    return what + ": too steep there";
                case StepRule::not_higher:
                    return what + ": it is no higher ahead";
                case StepRule::perch_distance:
                    return fmt::format("{}: an edge {:.2f} m from its axis, {:.2f} allowed", what, record.value,
                                       record.limit);
                case StepRule::steps_off:
                    return "steps are switched off";
                default:
                    return what;
            }
        }
        case StepAct::stepped_up:
            return fmt::format("stepped up {:.2f} m", record.value);
        case StepAct::snapped_down:
            return fmt::format("snapped down {:.2f} m", record.value);
        default:
            return {};
    }
}

void StepOverlay::draw_triangles(view::Renderer& renderer, const Walker& walker) {
    const ToldStep* const told = walker.told();
    if (told == nullptr) return;
    if (told != asked_by_ || !(told->before == asked_before_)) {
        asked_by_ = told;
        asked_before_ = told->before;
        const auto moment = walker.moment();
        asked_ = moment ? moment->triangles : std::vector<CapturedTriangle>();
    }
    for (const CapturedTriangle& one : asked_) {
        const Triangle& t = one.triangle;
        const dvec3 corners[3] = {t.a, t.b, t.c};
        renderer.triangle(t.a, t.b, t.c, view::with_opacity(paint::edge, 0.16));
        renderer.polyline(corners, {.colour = view::with_opacity(paint::edge, 0.8), .width = 1.3, .behind = 0.15},
                          true);
    }
}

void StepOverlay::draw(view::Renderer& renderer, const Walker& walker, const dvec3& position) {
    if (trail) {
        const auto places = walker.trail();
        const std::span<const dvec3> all(places);
        const std::size_t here = walker.looks_at();
        const auto stroke = [](double opacity) {
            return view::Stroke{.colour = view::with_opacity(paint::paper, opacity), .width = 2, .behind = 0.25};
        };
        renderer.polyline(all.first(here + 1), stroke(0.85));
        renderer.polyline(all.subspan(here), stroke(0.4));
        if (const auto& other = walker.what_if(); !other.empty()) {
            renderer.polyline(other, {.colour = paint::accent, .width = 3, .behind = 0.5});
            renderer.label({.place = other.back(), .text = "with the new settings", .behind = 1, .yields = true});
        }
    }
    const CharacterState& state = walker.state();
    if (ground && state.footing != Footing::air) {
        const Volume& body = body_of(walker.settings(), state.form);
        const dvec3 feet = position - dvec3(0, foot_of(body.shape), 0);
        const double degrees = std::acos(std::clamp(state.ground_normal.y, -1.0, 1.0)) * 57.29577951308232;
        const view::Colour colour = state.footing == Footing::steep ? wall_colour : paint::end;
        renderer.arrow(feet, feet + state.ground_normal * 0.8, {.colour = colour, .width = 3, .behind = 0.7}, 13);
        renderer.circle(feet, state.ground_normal, 0.45, {.colour = colour, .width = 2, .behind = 0.5});
        if (degrees > 0.5 && state.footing != Footing::ledge)
            renderer.label({.place = feet,
                            .text = fmt::format("{:.0f} degrees", degrees),
                            .offset = {0, 22},
                            .behind = 0.8,
                            .yields = true});
    }
    if (triangles) draw_triangles(renderer, walker);
    const ToldStep* const told = walker.told();
    if (told == nullptr) return;
    if (velocity) {
        renderer.arrow(position, position + state.velocity * 0.25,
                       {.colour = paint::result, .width = 3, .behind = 0.7});
        renderer.arrow(position, position + told->input.wish * 0.25, {.colour = paint::end, .width = 2, .behind = 0.7});
    }
    std::vector<std::uint32_t> named;  // each triangle once
    const dvec3 ahead = way_of(*told);
    const Volume& body = body_of(walker.settings_of_past(), told->before.form);
    for (const StepRecord& record : told->records) {
        if (contacts && is_touch(record.act)) {
            const bool is_new = record.act != StepAct::passed_over &&
                                std::find(named.begin(), named.end(), record.triangle) == named.end();
            draw_contact(renderer, record, walker.world(), is_new);
            if (is_new) named.push_back(record.triangle);
        }
        if (planes && is_plane(record.act)) draw_plane(renderer, record);
        if (!probes) continue;
        if (record.act == StepAct::step_tried)
            draw_step_probe(renderer, record, foot_of(body.shape), half_width_of(body.shape));
        if (record.act == StepAct::ledge_wall || record.act == StepAct::ledge_edge) draw_ledge_probe(renderer, record);
        if (const std::string text = label_of(record); !text.empty())
            renderer.label({.place = record.position + ahead * 0.5, .text = text, .behind = 1, .yields = true});
    }
}

void StepOverlay::ui() {
    namespace ui = view::ui;
    const float column = ImGui::GetContentRegionAvail().x * 0.5F;
    const auto box = [&](const char* label, bool& value, const char* says, bool is_second = false) {
        if (is_second) ImGui::SameLine(column);
        ui::checkbox(label, value);
        ui::hint(says);
    };
    box("Contacts", contacts, "What the last step touched: points, and the triangles that they are on.");
    box("Planes", planes, "What it obeyed: a circle and a normal each. Red is too steep for feet, pink an inner edge.",
        true);
    box("Probes", probes, "Where a step or an edge was looked for, and what came of it.");
    box("Asked triangles", triangles, "All triangles that the step asked the level for.", true);
    box("Ground", ground, "The normal of what is stood on.");
    box("Velocity", velocity, "Blue is what it has, green what is wished.", true);
    box("Trail", trail,
        "Where it was in the last 20 seconds. Seen from the past, with settings that were changed: in green, where the "
        "same inputs would lead.");
    box("Why", why, "Why it stopped or was slowed last, in words.", true);
}

}  // namespace surefoot::playground
