// The widgets of the navigation overlay.
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <imgui.h>

#include "playground/navigation/overlay.hpp"
#include "playground/navigation/paint.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {

namespace ui = view::ui;
namespace paint = navigation_paint;

void NavigationOverlay::ui() {
    ui::checkbox("Navigation (F2)", shown);
    ui::hint("The ground on which this character can walk, and ways over it.");
    if (!shown) return;
    if (!ground_) {
        ui::note("There is no ground here.");
    } else if (!here_ && !failure_.empty()) {
        ui::key_colour(view::paint::start, "There is no navigation mesh:");
        ImGui::TextWrapped("%s", failure_.c_str());
    } else if (!here_) {
        const auto share = static_cast<float>(maker_.share());
        ImGui::ProgressBar(share, {-1, 0}, fmt::format("building the mesh, {:.0f} %", share * 100).c_str());
    } else {
        const NavigationReport report = here_->scene->mesh.report();
        const std::string took = at_once_ ? std::string() : fmt::format(", {:.2f} s", report.seconds);
        ui::note(fmt::format("{} polygons, {:.0f} m2{}", report.polygons, report.area, took));
        look_ui();
        link_ui();
        area_ui();
        ui::note(here_->way.words());
        search_ui();
        runner_ui();
        if (!failure_.empty()) ui::key_colour(view::paint::start, failure_);
    }
}

void NavigationOverlay::look_ui() {
    const auto pair = [](const char* first, bool& a, const char* second, bool& b) {
        ui::checkbox(first, a);
        ImGui::SameLine(ImGui::GetFontSize() * 8);
        ui::checkbox(second, b);
    };
    pair("Mesh", look.mesh, "Portals", look.portals);
    pair("Raw path", look.raw, "Pulled path", look.pulled);
}

/// They take long to find, so they are looked for when somebody wants them.
void NavigationOverlay::link_ui() {
    const std::vector<LinkArc>& arcs = here_->scene->arcs;
    ui::checkbox("Links", look.links);
    ui::hint("Drops, jumps and steps that a simulated character was seen to do, and the way its feet went.");
    if (here_->link_search.is_busy()) {
        const auto share = static_cast<float>(here_->link_search.share());
        ImGui::ProgressBar(share, {-1, 0}, fmt::format("trying links, {:.0f} %", share * 100).c_str());
    } else if (arcs.empty()) {
        ImGui::SameLine(ImGui::GetFontSize() * 8);
        if (ui::button("Look for links")) here_->link_search.begin(*here_->scene, at_once_);
    }
    constexpr std::array<const char*, 4> kinds{"drops", "jumps", "steps up", "ladders"};
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        const auto kind = static_cast<NavigationLinkKind>(i);
        const auto count =
            std::count_if(arcs.begin(), arcs.end(), [&](const LinkArc& arc) { return arc.kind == kind; });
        if (count > 0) ui::key_colour(paint::link_colour(kind), fmt::format("{} {}", count, kinds[i]));
    }
}

/// Ground that differs: what it costs, and whether anybody may go there.
void NavigationOverlay::area_ui() {
    NavigationMesh& mesh = here_->scene->mesh;
    bool is_there = false;
    for (const NavigationOutline& outline : here_->scene->outlines)
        is_there = is_there || outline.area == slippery_area;
    if (!is_there) return;
    const NavigationArea area = mesh.areas()[slippery_area];
    bool shut = area.closed;
    double cost = area.cost;
    ui::key_colour(paint::area_colour(slippery_area), "slippery ground");
    ImGui::SameLine();
    ImGui::BeginDisabled(here_->link_search.is_busy());  // which looks at the mesh
    const bool changed = ui::checkbox("Shut", shut);
    ui::hint("No way goes over it then.");
    const bool costs = ui::slider("Its cost", cost, 1, 10, "%.1f");
    ui::hint("A metre on it is as long as so many elsewhere.");
    ImGui::EndDisabled();
    if (!changed && !costs) return;
    mesh.set_area(slippery_area, shut, cost);
    here_->runners.look_again();
    plan();
}

void NavigationOverlay::search_ui() {
    ui::checkbox("Search", look.search);
    ui::hint("How A* finds the way: polygons that wait, and those that it is done with.");
    if (!look.search) {
        plays_ = false;
        return;
    }
    ImGui::SameLine();
    const auto last = static_cast<double>(here_->way.rounds());
    if (ui::button(plays_ ? "Stop##search" : "Play##search")) {
        plays_ = !plays_;
        if (round_ >= last) round_ = 0;
    }
    if (ui::slider("Round", round_, 0, last, "%.0f")) plays_ = false;
    std::size_t open = 0;
    const auto& nodes = here_->way.nodes_after(static_cast<std::size_t>(round_));
    for (const NavigationSearchNode& node : nodes) open += node.open ? 1 : 0;
    ui::key_colour(paint::open_node, fmt::format("{} wait", open));
    ImGui::SameLine();
    ui::key_colour(paint::closed_node, fmt::format("{} done with", nodes.size() - open));
}

void NavigationOverlay::runner_ui() {
    ui::checkbox("A click puts the target", clicks_);
    ui::hint(
        "With Shift the start; with Control it takes a polygon out, or puts it back. Drag the target at any time.");
    ui::slider("Runners", runners_wanted_, 0, 20, "%.0f");
    if (here_->runners.size() == 0) return;
    if (ui::button("Scatter")) here_->runners.scatter(start_);
    ui::hint("Everybody begins somewhere else, the first at the start.");
    ui::note(here_->runners.words());
}

}  // namespace surefoot::playground
