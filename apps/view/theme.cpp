#include "view/theme.hpp"

#include <imgui.h>

namespace surefoot::view {

ImVec4 to_imgui(Colour c) {
    const glm::vec4 v = to_vec4(c);
    return {v.r, v.g, v.b, v.a};
}

std::uint32_t packed(Colour c) {
    return IM_COL32(c.r, c.g, c.b, c.a);
}

void apply_theme(double scale) {
    ImGuiStyle style;
    style.WindowRounding = 9;
    style.ChildRounding = 7;
    style.FrameRounding = 5;
    style.PopupRounding = 7;
    style.GrabRounding = 4;
    style.ScrollbarRounding = 6;
    style.TabRounding = 5;
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.PopupBorderSize = 0;
    style.FrameBorderSize = 0;
    style.WindowPadding = {14, 12};
    style.FramePadding = {9, 5};
    style.ItemSpacing = {9, 7};
    style.ItemInnerSpacing = {7, 5};
    style.CellPadding = {7, 4};
    style.IndentSpacing = 16;
    style.ScrollbarSize = 12;
    style.GrabMinSize = 12;
    style.WindowTitleAlign = {0, 0.5F};
    style.ScaleAllSizes(static_cast<float>(scale));

    const auto set = [&](ImGuiCol which, Colour colour) { style.Colors[which] = to_imgui(colour); };
    const Colour panel = rgb(0x1B242D, 0.93);
    const Colour raised = rgb(0x33424F);
    const Colour hovered = rgb(0x3F5263);
    const Colour active = rgb(0x4A6174);
    set(ImGuiCol_Text, rgb(0xE8EDF1));
    set(ImGuiCol_TextDisabled, rgb(0x94A3AF));
    set(ImGuiCol_WindowBg, panel);
    set(ImGuiCol_ChildBg, rgb(0x151C23, 0.55));
    set(ImGuiCol_PopupBg, rgb(0x1E2831, 0.98));
    set(ImGuiCol_Border, rgb(0x43586A, 0.6));
    set(ImGuiCol_FrameBg, raised);
    set(ImGuiCol_FrameBgHovered, hovered);
    set(ImGuiCol_FrameBgActive, active);
    set(ImGuiCol_TitleBg, rgb(0x161D24, 0.95));
    set(ImGuiCol_TitleBgActive, rgb(0x1A2530, 0.98));
    set(ImGuiCol_TitleBgCollapsed, rgb(0x161D24, 0.8));
    set(ImGuiCol_ScrollbarBg, rgb(0x000000, 0));
    set(ImGuiCol_ScrollbarGrab, hovered);
    set(ImGuiCol_ScrollbarGrabHovered, active);
    set(ImGuiCol_ScrollbarGrabActive, paint::accent);
    set(ImGuiCol_CheckMark, rgb(0x7FD8C8));
    set(ImGuiCol_SliderGrab, paint::accent);
    set(ImGuiCol_SliderGrabActive, rgb(0x7FD8C8));
    set(ImGuiCol_Button, raised);
    set(ImGuiCol_ButtonHovered, hovered);
    set(ImGuiCol_ButtonActive, rgb(0x3C8B80));
    set(ImGuiCol_Header, rgb(0x2F5F5A, 0.85));
    set(ImGuiCol_HeaderHovered, rgb(0x3A736C, 0.9));
    set(ImGuiCol_HeaderActive, rgb(0x458A81));
    set(ImGuiCol_Separator, rgb(0x40505D, 0.7));
    set(ImGuiCol_Tab, raised);
    set(ImGuiCol_TabHovered, rgb(0x3A736C));
    set(ImGuiCol_TabActive, rgb(0x2F5F5A));
    set(ImGuiCol_PlotLines, rgb(0x7FD8C8));
    set(ImGuiCol_TextSelectedBg, rgb(0x3C8B80, 0.6));
    set(ImGuiCol_TableHeaderBg, rgb(0x232E38));
    set(ImGuiCol_TableRowBg, rgb(0x000000, 0));
    set(ImGuiCol_TableRowBgAlt, rgb(0xFFFFFF, 0.03));
    set(ImGuiCol_ModalWindowDimBg, rgb(0x0C1116, 0.55));
    ImGui::GetStyle() = style;
}

}  // namespace surefoot::view
