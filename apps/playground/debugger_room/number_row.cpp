#include "playground/debugger_room/number_row.hpp"

#include <array>
#include <imgui.h>
#include <string>

#include "view/widgets.hpp"

namespace surefoot::playground {

RowNews number_row(const char* label, std::span<double> values, const RowLook& look) {
    RowNews news;
    ImGui::PushID(label);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    view::ui::hint("Drag a number; or double-click it and type.");
    ImGui::SameLine(ImGui::GetFontSize() * 4.6F);
    const float gap = ImGui::GetStyle().ItemInnerSpacing.x * 0.6F;
    const auto count = static_cast<float>(values.size());
    const float width = (ImGui::GetContentRegionAvail().x - gap * (count - 1)) / count;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (i > 0) ImGui::SameLine(0, gap);
        ImGui::PushID(static_cast<int>(i));
        ImGui::SetNextItemWidth(width);
        news.changed |= ImGui::DragScalar("##number", ImGuiDataType_Double, &values[i], static_cast<float>(look.speed),
                                          &look.low, &look.high, look.format, ImGuiSliderFlags_NoRoundToFormat);
        news.begun |= ImGui::IsItemActivated();
        news.ended |= ImGui::IsItemDeactivated();
        view::ui::item((std::string(label) + " " + look.names[i]).c_str());
        ImGui::PopID();
    }
    ImGui::PopID();
    return news;
}

RowNews vector_row(const char* label, dvec3& value, double speed, double low, double high) {
    static constexpr std::array names{"x", "y", "z"};
    return number_row(label, {&value.x, 3}, {.names = names, .speed = speed, .low = low, .high = high});
}

}  // namespace surefoot::playground
