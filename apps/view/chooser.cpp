#include "view/chooser.hpp"

#include <algorithm>
#include <imgui.h>
#include <imgui_stdlib.h>
#include <utility>

#include "view/widgets.hpp"

namespace surefoot::view {

void Chooser::open(std::string title, std::vector<std::string> names, Chosen chosen) {
    title_ = std::move(title);
    names_ = std::move(names);
    sought_.clear();
    chosen_ = std::move(chosen);
}

void Chooser::close() {
    names_.clear();
    chosen_ = nullptr;
}

void Chooser::draw() {
    if (!is_open()) return;
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float letter = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSize({std::min(letter * 26, size.x - 40), std::min(letter * 30, size.y - 40)});
    bool stays = true;
    ImGui::Begin((title_ + "###chooser").c_str(), &stays,
                 ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoMove);
    ImGui::SetNextItemWidth(-1);
    ImGui::InputTextWithHint("##sought", "Part of its name", &sought_);
    ui::item("Part of its name");
    ImGui::BeginChild("names", {0, -ImGui::GetFrameHeightWithSpacing() - 4}, false);
    std::string take;
    for (std::size_t i = 0; i < names_.size(); ++i) {
        if (names_[i].find(sought_) == std::string::npos) continue;
        ImGui::PushID(static_cast<int>(i));
        if (ui::row(names_[i].c_str(), false)) take = names_[i];
        ImGui::PopID();
    }
    ImGui::EndChild();
    if (ui::button("Cancel")) stays = false;
    ImGui::End();
    if (take.empty()) {
        if (!stays) close();
        return;
    }
    const Chosen chosen = std::move(chosen_);
    close();
    if (chosen) chosen(take);
}

}  // namespace surefoot::view
