#include "playground/debugger_room/scene.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>

#include "debugger/support.hpp"
#include "playground/debugger_room/framing.hpp"
#include "playground/feature_mark.hpp"
#include "view/shapes.hpp"

namespace surefoot::playground {
namespace {

using debugger::Question;
using view::dvec2;
using view::Renderer;
using view::rgb;
namespace paint = view::paint;

constexpr view::Colour first_ground = rgb(0xB9B4A6);
constexpr view::Colour second_ground = rgb(0xA3ADB0);
constexpr std::array axis_colours{rgb(0xD6584C), rgb(0x63A84E), rgb(0x4A86D8)};
// From this share of the way on, two places count as different moments.
constexpr double same_moment = 1e-6;

enum class Side { above, below, right };

/// A label beside a shape, clear of its outline.
void name(Renderer& renderer, const Volume& volume, const dvec3& place, const std::string& text, view::Colour colour,
          Side side) {
    const Bounds box = debugger::bounds_of(volume, place);
    const dvec3 middle = (box.min + box.max) * 0.5;
    view::Label label{.place = middle,
                      .text = text,
                      .colour = view::mixed(colour, paint::paper, 0.55),
                      .behind = 0.8,
                      .yields = true};
    if (side == Side::right) {
        constexpr double letter = 8;  // about as wide as one is, in window units
        const view::Camera& camera = renderer.view().camera;
        const double depth = std::max(glm::dot(middle - camera.eye, camera.forward), camera.nearest);
        const double reach = glm::length(box.max - middle) / camera.unit_at(depth, renderer.view().size);
        label.offset = dvec2(std::min(reach, 200.0) + letter * double(text.size()) / 2, 0);
    } else {
        label.place.y = side == Side::above ? box.max.y : box.min.y;
        label.offset = dvec2(0, side == Side::above ? -15 : 15);
    }
    renderer.label(label);
}

void draw_contact(Renderer& renderer, const Investigation& asked) {
    const Hit& hit = *asked.hit();
    draw_feature(renderer, asked.triangle_hit(), hit);
    const double length = std::max(view::reach_of(asked.question().volume().shape) * 0.9, 1e-6);
    renderer.arrow(hit.point, hit.point + hit.normal * length, {.colour = paint::normal, .width = 3, .behind = 0.5},
                   14);
    renderer.point(hit.point, 11, paint::contact, 0.8);
}

void draw_way(Renderer& renderer, const dvec3& from, const dvec3& to, view::Colour colour) {
    if (glm::length(to - from) > 0) renderer.arrow(from, to, {.colour = colour, .width = 2.5, .behind = 0.35}, 14);
}

/// The part of the way that was not gone, in dashes.
void draw_rest(Renderer& renderer, const dvec3& from, const dvec3& to) {
    constexpr int dashes = 24;
    for (int i = 0; i < dashes; ++i)
        renderer.line(from + (to - from) * (double(i) / dashes), from + (to - from) * ((i + 0.5) / dashes),
                      {.colour = view::with_opacity(paint::end, 0.6), .width = 1.5, .behind = 0.2});
}

/// By their corners if there is one, else by their numbers; of a saved step those that its sentences name.
void name_triangles(Renderer& renderer, const Investigation& asked) {
    const Question& question = asked.question();
    const auto& saved = asked.saved_step();
    constexpr std::size_t most_named = 12;
    const auto say = [&](const dvec3& place, std::string text, const dvec2& offset) {
        renderer.label({.place = place, .text = std::move(text), .offset = offset, .behind = 0.5, .yields = true});
    };
    if (question.triangles.size() == 1 && !saved) {
        const char* names[] = {"a", "b", "c"};
        for (std::size_t i = 0; i < 3; ++i) say(debugger::corners_of(question.triangles[0])[i], names[i], dvec2(0, 17));
    } else if (question.triangles.size() <= most_named) {
        for (std::size_t i = 0; i < question.triangles.size(); ++i) {
            const Triangle& t = question.triangles[i];
            say((t.a + t.b + t.c) / 3.0, std::to_string(saved ? saved->capture.triangles[i].id : i), dvec2(0, 0));
        }
    }
}

}  // namespace

void Scene::draw_world(Renderer& renderer, const Investigation& asked) {
    if (model_is_ != asked.world_version()) {
        model_is_ = asked.world_version();
        model_ = nullptr;
        const auto& level = asked.level();
        if (asked.mesh())
            model_ = view::Model::make(*asked.mesh(), [&](const SourceTriangle& t) {
                if (level) return view::colour_of_surface(t.surface, tools::surface_name(level->level, t.surface));
                return t.id % 2 == 0 ? first_ground : second_ground;
            });
    }
    if (!model_) return;
    view::ModelLook model_look;
    const bool few = !asked.level();
    if (few || renderer.effects.fine_edges) model_look.edges.width = few ? 1.6 : 1;
    renderer.model(model_, model_look);
}

void Scene::draw(Renderer& renderer, const Investigation& asked, double t) {
    draw_world(renderer, asked);
    const Question& question = asked.question();
    if (look.labels) name_triangles(renderer, asked);
    const Volume volume = question.volume();
    const Motion& way = question.motion;
    const dvec3 middle = gizmo_middle({.kind = Target::Kind::start}, question) - way.from;
    if (!is_valid(volume)) {
        if (look.ways) draw_way(renderer, way.from, way.to, paint::start);
        return;
    }
    const auto& hit = asked.hit();
    const bool touches = asked.touches();
    if (look.contact && touches) draw_contact(renderer, asked);
    if (look.start) {
        renderer.shape(volume, way.from, {.colour = paint::start, .opacity = 0.30});
        if (look.labels) name(renderer, volume, way.from, "START", paint::start, Side::above);
    }
    if (look.end) {
        renderer.shape(volume, way.to, {.colour = paint::end, .opacity = 0.24, .casts_shadow = false});
        if (look.labels) name(renderer, volume, way.to, "END", paint::end, Side::below);
    }
    const dvec3 stop = hit ? asked.place_at(hit->t) : way.to;
    const dvec3& rest = asked.result();
    const bool slides =
        asked.saved_step() ? rest != way.from : hit && glm::length(rest - stop) > 1e-3 * view::reach_of(volume.shape);
    if (look.hit && hit) {
        renderer.shape(volume, stop, {.colour = paint::hit, .opacity = 0.46, .outline = 2.4});
        if (look.labels) name(renderer, volume, stop, fmt::format("HIT  t = {:.4f}", hit->t), paint::hit, Side::above);
    }
    if (look.result && slides) {
        renderer.shape(volume, rest, {.colour = paint::result, .opacity = 0.2, .outline = 1.6, .casts_shadow = false});
        if (look.labels) name(renderer, volume, rest, "RESULT", paint::result, Side::below);
    }
    if (look.ways) {
        draw_way(renderer, way.from + middle, stop + middle, hit ? paint::hit : paint::end);
        if (hit) draw_rest(renderer, stop + middle, way.to + middle);
        if (slides) draw_way(renderer, stop + middle, rest + middle, paint::result);
    }
    const auto is_shown = [&](double moment) { return std::abs(moment - t) < same_moment; };
    if (is_shown(0) || is_shown(1) || (hit && is_shown(hit->t))) return;
    renderer.shape(volume, asked.place_at(t),
                   {.colour = paint::paper, .opacity = 0.05, .outline = 1.6, .casts_shadow = false});
    if (look.labels) name(renderer, volume, asked.place_at(t), fmt::format("t = {:.4f}", t), paint::paper, Side::right);
}

void Scene::draw_grips(Renderer& renderer, const Question& question, const std::optional<Target>& selected,
                       const std::optional<Grip>& hovered) const {
    const view::FrameView& view = renderer.view();
    for (const Grip& grip : grips_of(question, selected, view.camera, view.size)) {
        const bool lit = hovered && hovered->is_same(grip);
        switch (grip.kind) {
            case Grip::Kind::body:
                if (lit) {
                    const auto colour = grip.target.kind == Target::Kind::start ? paint::start : paint::end;
                    renderer.shape(grip.volume, grip.place,
                                   {.colour = colour, .opacity = 0.12, .outline = 3.5, .casts_shadow = false});
                }
                break;
            case Grip::Kind::corner:
                renderer.point(grip.handle, lit ? 15 : 10, lit ? paint::contact : paint::paper, 0.5);
                renderer.point(grip.handle, lit ? 9 : 6, paint::ink, 0.4);
                break;
            case Grip::Kind::face:
                renderer.point(grip.handle, lit ? 15 : 10, lit ? paint::contact : paint::paper, 0.6);
                renderer.point(grip.handle, lit ? 10 : 7, axis_colours[static_cast<std::size_t>(grip.axis)], 0.6);
                break;
            case Grip::Kind::arrow:
                renderer.arrow(gizmo_middle(grip.target, question), grip.handle,
                               {.colour = lit ? paint::contact : axis_colours[static_cast<std::size_t>(grip.axis)],
                                .width = lit ? 5.0 : 3.5,
                                .behind = 0.7},
                               18);
                break;
        }
    }
    if (selected && selected->kind != Target::Kind::corner && is_valid(question.volume()))
        renderer.box(box_around(*selected, question),
                     {.colour = view::with_opacity(paint::paper, 0.55), .width = 1.2, .behind = 0.3});
}

std::vector<dvec3> places_of(const Investigation& asked) {
    const Question& question = asked.question();
    // Of a shape that is none, the places are all that can be seen.
    const Volume volume = is_valid(question.volume()) ? question.volume() : Volume(Sphere{1});
    std::vector<dvec3> places;
    for (const dvec3& end : {question.motion.from, question.motion.to})
        append_corners(places, debugger::bounds_of(volume, end));
    if (asked.level()) {
        // Some of what lies around the motion has to be seen, too.
        constexpr double wider = 1.25;
        const dvec3 middle = (question.motion.from + question.motion.to) * 0.5;
        for (dvec3& place : places) place = middle + (place - middle) * wider;
        return places;
    }
    if (asked.touches() || asked.saved_step()) append_corners(places, debugger::bounds_of(volume, asked.result()));
    constexpr std::size_t few = 64;
    if (question.triangles.size() <= few)
        for (const Triangle& triangle : question.triangles)
            for (const dvec3& corner : debugger::corners_of(triangle)) places.push_back(corner);
    return places;
}

}  // namespace surefoot::playground
