#include "view/widgets.hpp"

#include <algorithm>
#include <imgui.h>
#include <map>
#include <vector>

#include "view/fonts.hpp"
#include "view/theme.hpp"

namespace surefoot::view::ui {
namespace {

struct Items {
    std::map<std::string, dvec2, std::less<>> now;
    std::map<std::string, dvec2, std::less<>> before;
};

Items& items() {
    static Items all;
    return all;
}

/// What panels cover.
struct Covered {
    std::vector<Area> now;
    std::vector<Area> before;
};

Covered& covered() {
    static Covered all;
    return all;
}

/// How many times as large as usual letters are.
float unit() {
    return ImGui::GetFontSize() / 15.5F;
}

void remember(const char* label) {
    const std::string_view text(label);
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    if (!ImGui::IsItemVisible()) return;
    items().now[std::string(text.substr(0, text.find("##")))] = dvec2((low.x + high.x) * 0.5F, (low.y + high.y) * 0.5F);
}

/// The same label, before a widget that takes the rest of the line.
void before(const char* label) {
    const std::string_view text(label);
    const std::string shown(text.substr(0, text.find("##")));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(shown.c_str());
    const float column =
        std::max(ImGui::GetContentRegionAvail().x * 0.42F, ImGui::CalcTextSize(shown.c_str()).x + 10 * unit());
    ImGui::SameLine(ImGui::GetCursorPosX() + column);
    ImGui::SetNextItemWidth(-1);
}

}  // namespace

bool begin(const char* title, const Panel& panel) {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float u = unit();
    const bool right = panel.corner == Panel::Corner::upper_right || panel.corner == Panel::Corner::lower_right;
    const bool low = panel.corner == Panel::Corner::lower_left || panel.corner == Panel::Corner::lower_right;
    const auto x = static_cast<float>(panel.margin.x);
    const auto y = static_cast<float>(panel.margin.y);
    ImGui::SetNextWindowPos({right ? size.x - x : x, low ? size.y - y : y}, ImGuiCond_Always,
                            {right ? 1.0F : 0.0F, low ? 1.0F : 0.0F});
    const float width = std::min(static_cast<float>(panel.width) * u, size.x - 2 * x);
    const float tallest = panel.most_height > 0 ? static_cast<float>(panel.most_height) * u : size.y - 2 * y;
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, std::max(tallest, 40.0F)});
    const bool open =
        ImGui::Begin(title, nullptr,
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                         ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing);
    covers();
    if (open) ImGui::Dummy({width - 2 * ImGui::GetStyle().WindowPadding.x, 0});
    if (open) ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y);
    return open;
}

void end() {
    ImGui::End();
}

bool button(const char* label, double width) {
    const bool pressed = ImGui::Button(label, {static_cast<float>(width) * unit(), 0});
    remember(label);
    return pressed;
}

bool primary_button(const char* label, double width) {
    ImGui::PushStyleColor(ImGuiCol_Button, to_imgui(rgb(0x2F7D73)));
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, to_imgui(rgb(0x379488)));
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, to_imgui(rgb(0x43AA9C)));
    const bool pressed = button(label, width);
    ImGui::PopStyleColor(3);
    return pressed;
}

bool checkbox(const char* label, bool& value) {
    const bool changed = ImGui::Checkbox(label, &value);
    remember(label);
    return changed;
}

bool slider(const char* label, double& value, double low, double high, const char* format, bool logarithmic) {
    before(label);
    ImGui::PushID(label);
    const bool changed = ImGui::SliderScalar("##slider", ImGuiDataType_Double, &value, &low, &high, format,
                                             logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
    ImGui::PopID();
    remember(label);
    return changed;
}

bool number(const char* label, double& value, const char* format) {
    before(label);
    ImGui::PushID(label);
    const bool changed = ImGui::InputDouble("##number", &value, 0, 0, format, ImGuiInputTextFlags_AutoSelectAll);
    ImGui::PopID();
    remember(label);
    return changed;
}

bool choice(const char* label, int& value, std::span<const char* const> names) {
    before(label);
    ImGui::PushID(label);
    bool changed = false;
    const bool open =
        ImGui::BeginCombo("##choice", names[static_cast<std::size_t>(value)], ImGuiComboFlags_HeightLarge);
    remember(label);
    if (open) {
        for (std::size_t i = 0; i < names.size(); ++i) {
            const bool chosen = static_cast<int>(i) == value;
            if (ImGui::Selectable(names[i], chosen) && !chosen) {
                value = static_cast<int>(i);
                changed = true;
            }
            remember(names[i]);
        }
        ImGui::EndCombo();
    }
    ImGui::PopID();
    return changed;
}

bool radio(const char* label, bool chosen) {
    const bool pressed = ImGui::RadioButton(label, chosen);
    remember(label);
    return pressed;
}

bool row(const char* label, bool chosen) {
    const bool pressed = ImGui::Selectable(label, chosen);
    remember(label);
    return pressed;
}

bool section(const char* title, bool open) {
    const bool shown = ImGui::CollapsingHeader(title, open ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
    remember(title);
    return shown;
}

void heading(std::string_view text) {
    ImGui::PushStyleColor(ImGuiCol_Text, to_imgui(rgb(0x8FD6CA)));
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopStyleColor();
}

void wrapped(std::string_view text) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
}

void note(std::string_view text) {
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    wrapped(text);
    ImGui::PopStyleColor();
}

void key_colour(Colour colour, std::string_view text) {
    const float side = ImGui::GetFontSize() * 0.8F;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float down = (ImGui::GetTextLineHeight() - side) * 0.5F + 1;
    ImGui::GetWindowDrawList()->AddRectFilled({at.x, at.y + down}, {at.x + side, at.y + down + side}, packed(colour),
                                              3 * unit());
    ImGui::Dummy({side, ImGui::GetTextLineHeight()});
    ImGui::SameLine();
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
}

void at_right(std::string_view text) {
    const ImVec2 size = ImGui::CalcTextSize(text.data(), text.data() + text.size());
    ImGui::SameLine();
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - size.x);  // of the window, whatever group this is in
    ImGui::TextDisabled("%.*s", static_cast<int>(text.size()), text.data());
}

void hint(std::string_view text) {
    if (!ImGui::IsItemHovered()) return;
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
}

void item(const char* label) {
    remember(label);
}

std::optional<dvec2> find_item(std::string_view label) {
    const Items& all = items();
    if (const auto found = all.now.find(label); found != all.now.end()) return found->second;
    if (const auto found = all.before.find(label); found != all.before.end()) return found->second;
    return std::nullopt;
}

std::string known_items() {
    std::string text;
    const auto& known = items().now.empty() ? items().before : items().now;
    for (const auto& [label, place] : known) text += (text.empty() ? "\"" : ", \"") + label + "\"";
    return text;
}

void covers() {
    const ImVec2 low = ImGui::GetWindowPos();
    const ImVec2 size = ImGui::GetWindowSize();
    covered().now.push_back({{low.x, low.y}, {low.x + size.x, low.y + size.y}});
}

Area uncovered(const ivec2& size) {
    const auto& panels = covered().now.empty() ? covered().before : covered().now;
    // Each side of the largest part is a side of the picture or of a panel, or it could be larger.
    std::vector<double> xs{0, double(size.x)};
    std::vector<double> ys{0, double(size.y)};
    for (const Area& panel : panels) {
        xs.insert(xs.end(), {panel.low.x, panel.high.x});
        ys.insert(ys.end(), {panel.low.y, panel.high.y});
    }
    const auto is_free = [&](const Area& part) {
        return std::none_of(panels.begin(), panels.end(), [&](const Area& panel) {
            return panel.low.x < part.high.x && part.low.x < panel.high.x && panel.low.y < part.high.y &&
                   part.low.y < panel.high.y;
        });
    };
    // What is looked at is about as wide as high, so that a long strip is worth no more than a piece of it.
    const auto worth = [](const dvec2& extent) {
        constexpr double longest = 1.6;
        return std::min(extent.x, longest * extent.y) * std::min(extent.y, longest * extent.x);
    };
    Area largest{{0, 0}, {0, 0}};
    for (const double left : xs)
        for (const double right : xs)
            for (const double top : ys)
                for (const double bottom : ys) {
                    const Area part{{left, top}, {right, bottom}};
                    const dvec2 extent = part.size();
                    if (extent.x > 0 && extent.y > 0 && left >= 0 && top >= 0 && right <= size.x && bottom <= size.y &&
                        worth(extent) > worth(largest.size()) && is_free(part))
                        largest = part;
                }
    return largest.size().x > 0 ? largest : Area{{0, 0}, dvec2(size)};
}

void forget_items() {
    items().before = std::move(items().now);
    items().now.clear();
    covered().before = std::move(covered().now);
    covered().now.clear();
}

}  // namespace surefoot::view::ui
