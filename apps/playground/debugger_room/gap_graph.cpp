#include "playground/debugger_room/gap_graph.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <string>

#include "debugger/equation.hpp"
#include "playground/debugger_room/graph_frame.hpp"
#include "view/theme.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

using debugger::short_text;
using view::dvec2;
namespace paint = view::paint;

ImVec2 place(const dvec2& p) {
    return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

/// Letters on the graph; `anchor` is which part of them is at the place, {0, 0} the upper left.
void write(ImDrawList& list, const dvec2& at, const dvec2& anchor, view::Colour colour, const std::string& text) {
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    list.AddText({static_cast<float>(at.x - anchor.x * size.x), static_cast<float>(at.y - anchor.y * size.y)},
                 view::packed(colour), text.c_str());
}

constexpr view::Colour quiet = view::rgb(0x94A3AF);

void axes(ImDrawList& list, const GraphFrame& frame) {
    for (const double g : round_marks(frame.least, frame.most, 6)) {
        const dvec2 at = frame.at(0, g);
        list.AddLine(place(at), place(frame.at(1, g)),
                     view::packed(g == 0 ? view::with_opacity(paint::paper, 0.75) : view::rgb(0xFFFFFF, 0.07)),
                     g == 0 ? 1.5F : 1.0F);
        const double half = ImGui::GetFontSize() * 0.4;  // clear of the words above and below
        if (at.y - half > frame.low.y && at.y + half < frame.high.y)
            write(list, at - dvec2(6, 0), {1, 0.5}, g == 0 ? paint::paper : quiet, fmt::format("{:g}", g));
    }
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const dvec2 at(frame.at(t, 0).x, frame.high.y);
        list.AddLine(place({at.x, frame.low.y}), place(at), view::packed(view::rgb(0xFFFFFF, 0.07)));
        write(list, at + dvec2(0, 3), {t == 1 ? 1.0 : 0.5, 0}, quiet, t == 1 ? "t = 1" : fmt::format("{:g}", t));
    }
}

/// A line down the graph, dashed if it is not to be held.
void moment(ImDrawList& list, const GraphFrame& frame, double t, view::Colour colour, bool dashed) {
    const double x = frame.at(t, 0).x;
    const double dash = dashed ? 4 : frame.high.y - frame.low.y;
    for (double y = frame.low.y; y < frame.high.y; y += 2 * dash)
        list.AddLine(place({x, y}), place({x, std::min(y + dash, frame.high.y)}), view::packed(colour), 1.5F);
}

}  // namespace

void gap_graph(const debugger::GapCurve& curve, double& t) {
    const float letter = ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const ImVec2 size(std::max(ImGui::GetContentRegionAvail().x, 8 * letter), 9.6F * letter);
    ImGui::InvisibleButton("##graph", size);
    view::ui::item("Graph of g(t)");
    const double line = letter;
    const GraphFrame frame = frame_of(curve.samples, dvec2(corner.x + 2.6 * line, corner.y + 1.5 * line),
                                      dvec2(corner.x + size.x - 0.6 * line, corner.y + size.y - 1.4 * line));
    if (ImGui::IsItemActive()) t = frame.t_at(ImGui::GetIO().MousePos.x);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(place(frame.low), place(frame.high), view::packed(view::rgb(0x10161C, 0.6)), 4);
    axes(list, frame);
    if (curve.t_star) moment(list, frame, *curve.t_star, paint::hit, true);
    moment(list, frame, t, view::with_opacity(paint::accent, 0.9), false);
    for (std::size_t i = 1; i < curve.samples.size(); ++i) {
        const auto& [t0, g0] = curve.samples[i - 1];
        const auto& [t1, g1] = curve.samples[i];
        list.AddLine(place(frame.at(t0, g0)), place(frame.at(t1, g1)),
                     view::packed((g0 + g1) * 0.5 < 0 ? paint::start : paint::face), 2);
    }
    if (curve.t_star)
        list.AddCircleFilled(place(frame.at(*curve.t_star, curve.g_at_t_star)), 4.5F, view::packed(paint::hit));
    const double g = t == curve.t_star ? curve.g_at_t_star : curve_at(curve.samples, t);
    list.AddCircleFilled(place(frame.at(t, g)), 5, view::packed(paint::paper));
    list.AddCircleFilled(place(frame.at(t, g)), 3.5F, view::packed(paint::accent));
    // Words have the line above the plot to themselves.
    const bool metres = curve.space == debugger::GapSpace::world;
    write(list, {corner.x, corner.y}, {0, 0}, paint::paper, metres ? "g [m]" : "g [radii]");
    write(list, {corner.x + 0.44 * size.x, corner.y}, {0.5, 0}, paint::hit,
          curve.t_star ? "t* = " + short_text(*curve.t_star) : "no hit");
    write(list, {frame.high.x, corner.y}, {1, 0}, view::rgb(0x7FD8C8),
          fmt::format("g({:.3f}) = {}", t, short_text(std::abs(g) < 1e-9 ? 0 : g)));
}

}  // namespace surefoot::playground
