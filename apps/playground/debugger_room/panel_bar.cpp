#include "playground/debugger_room/panel_bar.hpp"

#include <algorithm>
#include <imgui.h>
#include <string>
#include <utility>

#include "view/theme.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {

namespace ui = view::ui;

PanelBar::PanelBar(std::vector<std::unique_ptr<Panel>> panels) {
    for (auto& panel : panels) panels_.push_back({std::move(panel)});
}

void PanelBar::enter(Stage& stage) {
    for (const Entry& entry : panels_) entry.panel->enter(stage);
}

void PanelBar::changed(const Inquiry& inquiry) {
    for (Entry& entry : panels_) entry.knows = false;
    if (open_ < 0) return;
    Entry& shown = panels_[static_cast<std::size_t>(open_)];
    shown.panel->changed(inquiry);
    shown.knows = true;
}

void PanelBar::toggle(int index, const Inquiry& inquiry) {
    open_ = open_ == index ? -1 : index;
    if (open_ < 0) return;
    Entry& shown = panels_[static_cast<std::size_t>(open_)];
    if (!std::exchange(shown.knows, true)) shown.panel->changed(inquiry);
}

void PanelBar::show(std::string_view name, const Inquiry& inquiry) {
    for (std::size_t i = 0; i < panels_.size(); ++i)
        if (panels_[i].panel->name() == name && open_ != static_cast<int>(i)) toggle(static_cast<int>(i), inquiry);
}

double PanelBar::width() const {
    constexpr double usual = 430;  // for usual letters
    constexpr double most = 0.46;  // of the window
    return std::min(usual * ImGui::GetFontSize() / 15.5, most * ImGui::GetIO().DisplaySize.x);
}

bool PanelBar::ui(Inquiry& inquiry, double below) {
    if (panels_.empty()) return false;
    const int before = open_;
    constexpr double margin = 14;
    // The limit is in units of letters, and what is kept free in units of the window.
    const double letters = ImGui::GetFontSize() / 15.5;
    const double high = (ImGui::GetIO().DisplaySize.y - 2 * margin - below) / letters;
    if (ui::begin("Panels",
                  {.corner = ui::Panel::Corner::upper_right, .width = width() / letters, .most_height = high})) {
        // So narrow that all names find room in a line of usual width.
        const ImGuiStyle& style = ImGui::GetStyle();
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {4, style.FramePadding.y});
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {4, style.ItemSpacing.y});
        const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
        for (std::size_t i = 0; i < panels_.size(); ++i) {
            const std::string name(panels_[i].panel->name());
            if (i > 0) {
                // Toggles that find no room in a line begin the next one.
                const float wide = ImGui::CalcTextSize(name.c_str()).x + 2 * style.FramePadding.x;
                if (ImGui::GetItemRectMax().x + style.ItemSpacing.x + wide < right) ImGui::SameLine();
            }
            const bool on = static_cast<int>(i) == open_;
            if (on) ImGui::PushStyleColor(ImGuiCol_Button, view::to_imgui(view::rgb(0x2F7D73)));
            if (ui::button(name.c_str())) toggle(static_cast<int>(i), inquiry);
            if (on) ImGui::PopStyleColor();
        }
        ImGui::PopStyleVar(2);
        if (Panel* const panel = open()) {
            ImGui::Separator();
            panel->ui(inquiry);
        }
    }
    ui::end();
    return open_ != before;
}

}  // namespace surefoot::playground
