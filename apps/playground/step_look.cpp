#include "playground/step_look.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "view/shapes.hpp"

namespace surefoot::playground {
namespace {

using view::Colour;
using view::Renderer;
namespace paint = view::paint;

constexpr Colour refused = view::rgb(0xE0483E);
constexpr Colour probe = view::rgb(0xB48CE0);

/// How a record is drawn: one that is looked at stands out, and the others are quiet.
struct Loudness {
    double width;    // of lines
    double fill;     // of planes
    double opacity;  // of all
    double point;
};
constexpr Loudness quiet{1.6, 0.06, 0.6, 7};
constexpr Loudness lit{4, 0.24, 1, 13};

void arrow(Renderer& renderer, const dvec3& from, const dvec3& to, Colour colour, const Loudness& loud) {
    if (glm::length(to - from) > 0)
        renderer.arrow(from, to,
                       {.colour = view::with_opacity(colour, loud.opacity), .width = loud.width, .behind = 0.5}, 12);
}

void normal(Renderer& renderer, const StepRecord& record, double length, Colour colour, const Loudness& loud) {
    renderer.point(record.point, loud.point, view::with_opacity(paint::contact, loud.opacity), 0.6);
    arrow(renderer, record.point, record.point + record.normal * length, colour, loud);
}

void plane(Renderer& renderer, const StepRecord& record, double half, Colour colour, const Loudness& loud) {
    if (!(glm::length(record.normal) > 0.5)) return;
    const auto [u, v] = view::across(record.normal);
    const dvec3& middle = record.point;
    const std::array<dvec3, 4> corners{middle + (u + v) * half, middle + (u - v) * half, middle - (u + v) * half,
                                       middle - (u - v) * half};
    renderer.triangle(corners[0], corners[1], corners[2], view::with_opacity(colour, loud.fill));
    renderer.triangle(corners[0], corners[2], corners[3], view::with_opacity(colour, loud.fill));
    renderer.polyline(
        corners, {.colour = view::with_opacity(colour, loud.opacity), .width = loud.width * 0.5, .behind = 0.4}, true);
}

bool is_obeyed(StepAct act) {
    return act == StepAct::obeyed || act == StepAct::wall || act == StepAct::met_neighbour || act == StepAct::seam ||
           act == StepAct::gave_up_rising;
}

/// Up by the height that is tried, and ahead; what was found, where something was.
void draw_probe(Renderer& renderer, const StepRecord& record, const StepLook& look, const Loudness& loud) {
    const Colour colour = colour_of(record.act);
    const dvec3 from = record.position + look.middle;
    switch (record.act) {
        case StepAct::step_tried: {
            const double way = glm::length(record.motion);
            const dvec3 ahead = way > 0 ? record.motion * std::max(1.0, record.limit / way) : record.motion;
            const dvec3 top = from + look.up * record.value;
            arrow(renderer, from, top, colour, loud);
            arrow(renderer, top, top + ahead, colour, loud);
            break;
        }
        case StepAct::stepped_up:
            arrow(renderer, from, from + look.up * record.value, colour, loud);
            arrow(renderer, from + look.up * record.value, from + look.up * record.value + record.motion, colour, loud);
            break;
        case StepAct::ledge_wall:
        case StepAct::ledge_edge: {
            // It is told where the touch was; where nothing was met the point is where the probe began.
            const bool met = record.value < 1;
            const dvec3 begin = met ? record.point - record.motion * record.value : record.point;
            arrow(renderer, begin, begin + record.motion * record.value, colour, loud);
            break;
        }
        default:
            break;
    }
    if (glm::length(record.normal) > 0.5 && record.act != StepAct::changed_form && record.act != StepAct::form_refused)
        normal(renderer, record, 0.5 * look.size, colour, loud);
}

void draw_one(Renderer& renderer, const StepRecord& record, const StepLook& look, const Loudness& loud,
              bool has_plane) {
    const Colour colour = colour_of(record.act);
    switch (part_of(record.act)) {
        case StepPart::way: {
            const auto stretched = [&](const dvec3& p) {
                return look.from + (p - look.from) * look.stretch + look.middle;
            };
            arrow(renderer, stretched(record.position), stretched(record.position + record.motion), colour, loud);
            break;
        }
        case StepPart::contact:
            normal(renderer, record, 0.8 * look.size, colour, loud);
            if (has_plane && is_obeyed(record.act)) plane(renderer, record, look.size, colour, loud);
            break;
        case StepPart::probe:
            draw_probe(renderer, record, look, loud);
            break;
        case StepPart::ground:
            if (!(glm::length(record.normal) > 0.5)) break;
            normal(renderer, record, 0.6 * look.size, colour, loud);
            if (has_plane) plane(renderer, record, 0.5 * look.size, colour, loud);
            break;
    }
}

bool is_shown(StepPart part, const StepLook& look) {
    switch (part) {
        case StepPart::way:
            return look.ways;
        case StepPart::contact:
            return look.contacts || look.planes;
        case StepPart::probe:
            return look.probes;
        case StepPart::ground:
            break;
    }
    return look.ground;
}

}  // namespace

StepPart part_of(StepAct act) {
    switch (act) {
        case StepAct::carried:
        case StepAct::recovered:
        case StepAct::wants:
        case StepAct::pass:
        case StepAct::rested:
        case StepAct::jumped:
        case StepAct::jump_refused:
        case StepAct::crushed:
        case StepAct::stuck:
        case StepAct::parted:
            return StepPart::way;
        case StepAct::touch:
        case StepAct::obeyed:
        case StepAct::passed_over:
        case StepAct::seam:
        case StepAct::wall:
        case StepAct::gave_up_rising:
        case StepAct::overflow:
        case StepAct::met_neighbour:
            return StepPart::contact;
        case StepAct::step_tried:
        case StepAct::step_refused:
        case StepAct::stepped_up:
        case StepAct::changed_form:
        case StepAct::form_refused:
        case StepAct::ledge_wall:
        case StepAct::ledge_edge:
        case StepAct::ledge_refused:
            return StepPart::probe;
        case StepAct::ground:
        case StepAct::no_ground:
        case StepAct::snapped_down:
        case StepAct::landed:
        case StepAct::left_ground:
            break;
    }
    return StepPart::ground;
}

Colour colour_of(StepAct act) {
    switch (act) {
        case StepAct::wants:
            return paint::end;
        case StepAct::pass:
            return paint::result;
        case StepAct::touch:
        case StepAct::passed_over:
            return paint::normal;
        case StepAct::obeyed:
        case StepAct::met_neighbour:
            return paint::hit;
        case StepAct::seam:
            return paint::vertex;
        case StepAct::ground:
        case StepAct::landed:
        case StepAct::snapped_down:
        case StepAct::stepped_up:
            return paint::accent;
        case StepAct::carried:
        case StepAct::recovered:
        case StepAct::parted:
        case StepAct::jumped:
            return paint::contact;
        case StepAct::step_tried:
        case StepAct::changed_form:
        case StepAct::ledge_wall:
        case StepAct::ledge_edge:
            return probe;
        default:
            break;
    }
    return refused;
}

void draw_story(Renderer& renderer, std::span<const StepRecord> records, const StepLook& look) {
    for (const StepRecord& record : records)
        if (is_shown(part_of(record.act), look)) draw_one(renderer, record, look, quiet, look.planes);
}

void draw_record(Renderer& renderer, const StepRecord& record, const StepLook& look) {
    draw_one(renderer, record, look, lit, true);
}

}  // namespace surefoot::playground
