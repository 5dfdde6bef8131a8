#include "playground/walk/findings.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include "view/widgets.hpp"

namespace surefoot::playground {

using view::rgb;

Findings::Findings(const CookReport& r)
    : groups_{{"T-junctions", "corners that lie on an open edge of another triangle, where cracks begin", rgb(0xF06595),
               r.t_junctions, true},
              {"Degenerate", "triangles without area; they block as the segment or point that they are", rgb(0xFAB005),
               r.degenerate, true},
              {"Flipped", "neighbours that face opposite ways", rgb(0xBE4BDB), r.flipped_edges, true},
              {"Non-manifold", "sides that more than two triangles share", rgb(0x15AABF), r.non_manifold_edges, true},
              {"Open edges", "sides without a neighbour: fine for a ground's border", rgb(0x868E96), r.open_edges,
               false}} {}

void Findings::draw(view::Renderer& renderer, const tools::Level& level) const {
    if (!shown) return;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        const Group& group = groups_[g];
        if (!group.shown) continue;
        for (std::size_t i = 0; i < group.finding.places.size(); ++i) {
            const Finding::Place& place = group.finding.places[i];
            const bool chosen = any_chosen_ && g == chosen_group_ && i == chosen_;
            renderer.point(place.point, chosen ? 16 : 11, view::with_opacity(view::paint::ink, 0.85), 0.25);
            renderer.point(place.point, chosen ? 11 : 7, group.colour, 0.45);
            if (!chosen) continue;
            const Triangle t = level.mesh.triangle(place.triangle);
            const dvec3 corners[3] = {t.a, t.b, t.c};
            renderer.polyline(corners, {.colour = group.colour, .width = 3, .behind = 0.4}, true);
            renderer.label({.place = place.point,
                            .text = fmt::format("{}, triangle {}", group.name, place.triangle),
                            .colour = group.colour,
                            .offset = {0, -26},
                            .behind = 1});
        }
    }
}

std::optional<dvec3> Findings::next() {
    for (std::size_t tries = 0; tries <= groups_.size(); ++tries) {
        const auto& places = groups_[chosen_group_].finding.places;
        const std::size_t following = any_chosen_ ? chosen_ + 1 : 0;
        if (groups_[chosen_group_].shown && following < places.size()) {
            chosen_ = following;
            any_chosen_ = true;
            return places[chosen_].point;
        }
        chosen_group_ = (chosen_group_ + 1) % groups_.size();
        any_chosen_ = false;
    }
    return std::nullopt;
}

std::optional<dvec3> Findings::ui() {
    namespace ui = view::ui;
    std::optional<dvec3> go;
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        Group& group = groups_[g];
        ImGui::PushID(static_cast<int>(g));
        ImGui::BeginDisabled(group.finding.count == 0);
        ui::checkbox(group.name, group.shown);
        ImGui::EndDisabled();
        ui::hint(group.meaning);
        ImGui::SameLine(ImGui::GetContentRegionMax().x - ImGui::GetFontSize() * 4.5F);
        ui::key_colour(group.colour, "");
        ui::at_right(std::to_string(group.finding.count));
        ImGui::PopID();
    }
    ui::checkbox("Marks", shown);
    ImGui::SameLine();
    if (ui::button("Next spot (N)")) go = next();
    if (ImGui::BeginCombo(
            "##places",
            any_chosen_ ? fmt::format("{} {}", groups_[chosen_group_].name, chosen_ + 1).c_str() : "Choose a spot",
            ImGuiComboFlags_HeightLarge)) {
        for (std::size_t g = 0; g < groups_.size(); ++g) {
            for (std::size_t i = 0; i < groups_[g].finding.places.size(); ++i) {
                const Finding::Place& place = groups_[g].finding.places[i];
                const std::string label = fmt::format("{} {}: triangle {}", groups_[g].name, i + 1, place.triangle);
                if (!ui::row(label.c_str(), any_chosen_ && g == chosen_group_ && i == chosen_)) continue;
                chosen_group_ = g;
                chosen_ = i;
                any_chosen_ = true;
                groups_[g].shown = true;
                go = place.point;
            }
        }
        ImGui::EndCombo();
    }
    ui::item("Spots");
    return go;
}

}  // namespace surefoot::playground
