#include "playground/walk/thrower.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <imgui.h>

#include "playground/feature_mark.hpp"
#include "view/fonts.hpp"
#include "view/shapes.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

constexpr std::array<const char*, 6> kinds{"Ellipsoid", "Sphere", "Capsule", "Box", "Cylinder", "Cone"};
constexpr std::array<view::Colour, 6> colours{view::rgb(0xF2912B), view::rgb(0xE0483E), view::rgb(0xE9C13B),
                                              view::rgb(0x3FA65A), view::rgb(0x2FA3B5), view::rgb(0x5B78D0)};
constexpr std::size_t most_throws = 24;
constexpr double flight_speed = 28;  // of what is shown [m/s]

const char* word_for(Feature feature) {
    return feature == Feature::face ? "face" : feature == Feature::edge ? "edge" : "vertex";
}

}  // namespace

dvec3 Thrower::Throw::position() const {
    const double end = hit ? hit->t : 1;
    const double share = flight > 0 ? std::min(age / flight, 1.0) : 1;
    return motion.from + (motion.to - motion.from) * (end * share);
}

Shape Thrower::shape() const {
    switch (kind_) {
        case 0:
            return Ellipsoid{{wide_, high_, wide_}};
        case 1:
            return Sphere{wide_};
        case 2:
            return Capsule{wide_, std::max(high_ - wide_, 0.0)};
        case 3:
            return Box{{wide_, high_, wide_}};
        case 4:
            return Cylinder{wide_, high_};
        default:
            return Cone{wide_, 2 * high_};
    }
}

void Thrower::throw_at(const Mesh& mesh, const dvec3& from, const dvec3& direction, double length) {
    Throw thrown;
    thrown.volume = shape();
    thrown.colour = colours[static_cast<std::size_t>(kind_)];
    // The middle of the shape flies along the line of sight.
    const dvec3 begin = from - view::middle_of(thrown.volume.shape);
    thrown.motion = {begin, begin + direction * length};
    const auto start = std::chrono::steady_clock::now();
    thrown.hit = mesh.sweep(thrown.volume, thrown.motion);
    thrown.microseconds = std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();
    static_cast<void>(mesh.sweep(thrown.volume, thrown.motion, {.work = &thrown.work}));
    thrown.flight = std::min(length * (thrown.hit ? thrown.hit->t : 1) / flight_speed, 1.2);
    throws_.push_back(thrown);
    if (throws_.size() > most_throws) throws_.erase(throws_.begin());
}

bool Thrower::update(double dt) {
    bool flying = false;
    for (Throw& t : throws_) {
        flying = flying || !t.landed();
        t.age += dt;
    }
    std::erase_if(throws_, [](const Throw& t) { return !t.hit && t.landed(); });
    return flying;
}

void Thrower::draw(view::Renderer& renderer, const tools::Level& level) const {
    for (const Throw& t : throws_) {
        const bool last = &t == &throws_.back();
        renderer.shape(t.volume, t.position(),
                       {.colour = t.colour, .opacity = last ? 0.5 : 0.32, .outline = last ? 2.0 : 1.5});
        const dvec3 middle = view::middle_of(t.volume.shape);
        renderer.line(t.motion.from + middle, t.position() + middle,
                      {.colour = view::with_opacity(t.colour, last ? 0.8 : 0.3), .width = 1.5, .behind = 0.15});
        if (!t.landed() || !t.hit || t.hit->status != HitStatus::ok) continue;
        if (last) draw_feature(renderer, level.mesh.triangle(t.hit->triangle), *t.hit);
        const double length = std::clamp(view::reach_of(t.volume.shape) * 0.9, 0.1, 3.0);
        renderer.arrow(t.hit->point, t.hit->point + t.hit->normal * length,
                       {.colour = view::paint::normal, .width = last ? 3.0 : 2.0, .behind = 0.6}, last ? 15 : 11);
        renderer.point(t.hit->point, last ? 11 : 7, view::paint::contact, 0.8);
        if (last)
            renderer.label({.place = t.hit->point,
                            .text = fmt::format("{} of triangle {}", word_for(t.hit->feature), t.hit->triangle),
                            .offset = {0, 24},
                            .behind = 1});
    }
}

void Thrower::ui(const tools::Level& level) {
    namespace ui = view::ui;
    ui::choice("Shape", kind_, kinds);
    ui::slider(kind_ == 1 ? "Radius" : "Half width", wide_, 0.05, 3, "%.2f m", true);
    if (kind_ != 1) ui::slider("Half height", high_, 0.05, 3, "%.2f m", true);
    if (throws_.empty()) {
        ui::note("Click a spot: the shape sweeps there from the camera and stays where it stops.");
        return;
    }
    const Throw& t = throws_.back();
    if (!t.hit) {
        ui::note("Nothing was met.");
    } else {
        const Hit& h = *t.hit;
        ImGui::PushFont(view::fonts().mono);
        std::string text = fmt::format(
            "t        {:.9f}\nafter    {:.4f} m\nfeature  {}\ntriangle {}\nsurface  {}\nnormal   {:+.3f} {:+.3f} "
            "{:+.3f}",
            h.t, h.t * glm::length(t.motion.to - t.motion.from), word_for(h.feature), h.triangle,
            tools::surface_text(level, h.surface), h.normal.x, h.normal.y, h.normal.z);
        text += fmt::format("\nopened   {} boxes\ntested   {} triangles", t.work.nodes, t.work.triangles);
        if (timed) text += fmt::format("\ntook     {:.1f} us", t.microseconds);
        if (h.started_inside) text += "\nstarted inside";
        ImGui::TextUnformatted(text.c_str());
        ImGui::PopFont();
    }
    if (ui::button("Clear")) clear();
}

}  // namespace surefoot::playground
