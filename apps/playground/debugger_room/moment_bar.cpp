#include "playground/debugger_room/moment_bar.hpp"

#include <algorithm>
#include <imgui.h>

#include "playground/debugger_room/answer_panel.hpp"
#include "view/theme.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {

void moment_bar(const Investigation& asked, const Clock& clock, double left, double right) {
    namespace ui = view::ui;
    constexpr float margin = 14;
    const auto x = static_cast<float>(left);
    ImGui::SetNextWindowPos({x, ImGui::GetIO().DisplaySize.y - margin}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowSize({std::max(static_cast<float>(right) - x, 120.0F), 0}, ImGuiCond_Always);
    if (ImGui::Begin("##moment", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                         ImGuiWindowFlags_NoFocusOnAppearing)) {
        ui::covers();
        ImGui::PushTextWrapPos(0);
        ui::key_colour(asked.hit() ? view::paint::hit : view::paint::end, answer_in_a_line(asked));
        ImGui::PopTextWrapPos();
        if (ui::button(clock.runs ? "Stop##run" : "Run##run")) clock.toggle();
        ui::hint("Lets the motion run from START to END (Space).");
        ImGui::SameLine();
        ImGui::BeginDisabled(!asked.hit());
        if (ui::button("To HIT")) clock.t = asked.hit() ? asked.hit()->t : 1;
        ImGui::EndDisabled();
        ImGui::SameLine();
        ImGui::SetNextItemWidth(-1);
        const double low = 0;
        const double high = 1;
        if (ImGui::SliderScalar("##t", ImGuiDataType_Double, &clock.t, &low, &high, "t = %.4f",
                                ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat))
            clock.runs = false;
        ui::item("Moment t");
    }
    ImGui::End();
}

}  // namespace surefoot::playground
