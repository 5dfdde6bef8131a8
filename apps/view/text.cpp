#include "view/text.hpp"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <vector>

#include "view/theme.hpp"

namespace surefoot::view {

void draw_labels(const FrameView& view, std::span<const Label> labels, const Hidden& hidden) {
    struct Placed {
        const Label* label;
        Projected at;
    };
    std::vector<Placed> placed;
    for (const Label& label : labels)
        if (const auto at = view.camera.project(label.place, view.size)) placed.push_back({&label, *at});
    std::stable_sort(placed.begin(), placed.end(),
                     [](const Placed& a, const Placed& b) { return a.at.depth > b.at.depth; });
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float letter = ImGui::GetFontSize();
    const float pad = std::round(letter * 0.32F);
    for (const auto& [label, at] : placed) {
        const double seen = hidden && hidden(label->place) ? label->behind : 1;
        if (seen <= 0) continue;
        const char* const begin = label->text.data();
        const char* const end = begin + label->text.size();
        const ImVec2 size = ImGui::CalcTextSize(begin, end);
        const auto x = static_cast<float>(std::round(at.at.x + label->offset.x));
        const auto y = static_cast<float>(std::round(at.at.y + label->offset.y));
        const ImVec2 low(x - std::round(size.x / 2) - pad, y - std::round(size.y / 2) - pad * 0.6F);
        const ImVec2 high(low.x + size.x + 2 * pad, low.y + size.y + 1.2F * pad);
        const auto fade = [&](Colour colour, double opacity) {
            return packed(with_opacity(colour, opacity * seen * colour.a / 255.0));
        };
        list.AddRectFilled(low, high, fade(paint::ink, 0.78), letter * 0.3F);
        list.AddText({low.x + pad, low.y + pad * 0.6F}, fade(label->colour, 1), begin, end);
    }
}

}  // namespace surefoot::view
