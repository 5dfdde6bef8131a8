#include "view/help.hpp"

#include <imgui.h>

#include "view/theme.hpp"
#include "view/widgets.hpp"

namespace surefoot::view {

bool draw_help(std::span<const HelpPage> pages, std::string_view footer) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float letter = ImGui::GetFontSize();
    ImGui::GetBackgroundDrawList()->AddRectFilled({0, 0}, size, packed(rgb(0x0C1116, 0.5)));
    ImGui::SetNextWindowPos({size.x / 2, size.y / 2}, ImGuiCond_Always, {0.5F, 0.5F});
    ImGui::SetNextWindowSizeConstraints({letter * 30, 0}, {letter * 60, size.y - 40});
    bool stays = true;
    ImGui::Begin("Keys and mouse", &stays,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoMove);
    for (const HelpPage& page : pages) {
        ui::heading(page.title);
        if (ImGui::BeginTable(page.title.data(), 2, ImGuiTableFlags_SizingFixedFit)) {
            ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, letter * 12);
            ImGui::TableSetupColumn("does", ImGuiTableColumnFlags_WidthFixed, letter * 26);
            for (const auto& [keys, does] : page.lines) {
                ImGui::TableNextRow();
                ImGui::TableNextColumn();
                ImGui::TextUnformatted(keys.data(), keys.data() + keys.size());
                ImGui::TableNextColumn();
                ui::note(does);
            }
            ImGui::EndTable();
        }
        ImGui::Spacing();
    }
    ImGui::Separator();
    ui::note(footer);
    if (ui::button("Close")) stays = false;
    ImGui::End();
    return stays;
}

}  // namespace surefoot::view
