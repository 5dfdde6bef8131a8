#include "playground/walk/tape.hpp"

#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <imgui.h>
#include <numbers>

#include "view/fonts.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {

Measured measure(const dvec3& from, const dvec3& to, const dvec3& up) {
    const dvec3 way = to - from;
    Measured measured;
    measured.distance = glm::length(way);
    measured.height = glm::dot(way, up);
    measured.flat = glm::length(way - up * measured.height);
    measured.slope_deg = std::atan2(measured.height, measured.flat) * 180 / std::numbers::pi;
    return measured;
}

void Tape::click(const dvec3& place) {
    if (from_ && !to_) {
        to_ = place;
    } else {
        from_ = place;
        to_.reset();
    }
}

void Tape::draw(view::Renderer& renderer, const dvec3& up) const {
    constexpr view::Colour tape = view::rgb(0xFFD43B);
    if (over_ && !(from_ && to_)) renderer.point(*over_, 9, view::with_opacity(tape, 0.7));
    if (!from_) return;
    renderer.point(*from_, 10, tape);
    if (!end()) return;
    const dvec3 to = *end();
    const Measured m = measure(*from_, to, up);
    // The corner of the right angle between the way across and the way up.
    const dvec3 corner = to - up * m.height;
    renderer.line(*from_, corner, {.colour = view::rgb(0x495057), .width = 1.5, .behind = 0.4});
    renderer.line(corner, to, {.colour = view::rgb(0x495057), .width = 1.5, .behind = 0.4});
    renderer.line(*from_, to, {.colour = tape, .width = 3, .behind = 0.5});
    renderer.point(to, 10, tape);
    renderer.label({.place = (*from_ + to) * 0.5,
                    .text = fmt::format("{:.3f} m", m.distance),
                    .colour = tape,
                    .offset = {0, -18},
                    .behind = 1});
    if (std::abs(m.height) > 1e-3)
        renderer.label(
            {.place = (corner + to) * 0.5, .text = fmt::format("{:+.3f} m", m.height), .offset = {44, 0}, .behind = 1});
}

void Tape::ui(const dvec3& up) const {
    if (!from_ || !end()) {
        view::ui::note(from_ ? "Click where it ends." : "Click where it begins.");
        return;
    }
    const Measured m = measure(*from_, *end(), up);
    ImGui::PushFont(view::fonts().mono);
    const std::string text =
        fmt::format("distance {:10.4f} m\nacross   {:10.4f} m\nheight   {:+10.4f} m\nslope    {:+10.2f} deg",
                    m.distance, m.flat, m.height, m.slope_deg);
    ImGui::TextUnformatted(text.c_str());
    ImGui::PopFont();
}

}  // namespace surefoot::playground
