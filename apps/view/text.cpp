#include "view/text.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <imgui.h>
#include <vector>

#include "view/theme.hpp"

namespace surefoot::view {

namespace {

bool overlap(const Area& a, const Area& b) {
    constexpr double air = 2;
    return a.low.x < b.high.x + air && b.low.x < a.high.x + air && a.low.y < b.high.y + air && b.low.y < a.high.y + air;
}

struct Placed {
    const Label* label;
    double depth;
    double seen;  // opacity
};

}  // namespace

void step_aside(std::span<LabelBox> boxes) {
    constexpr double most = 2.5;  // rows
    std::vector<Area> taken;
    for (const LabelBox& box : boxes)
        if (!box.yields) taken.push_back(box.area);
    for (LabelBox& box : boxes) {
        if (!box.yields) continue;
        const auto moved = [&](double by) { return Area{box.area.low + dvec2(0, by), box.area.high + dvec2(0, by)}; };
        const auto is_clear = [&](double by) {
            return std::none_of(taken.begin(), taken.end(), [&](const Area& t) { return overlap(t, moved(by)); });
        };
        const double row = box.area.size().y;
        for (double by = 0; by <= most * row; by += 2) {
            const double free = is_clear(-by) ? -by : by;
            if (free != by || is_clear(by)) {
                box.area = moved(free);
                break;
            }
        }
        taken.push_back(box.area);
    }
}

void draw_labels(const FrameView& view, std::span<const Label> labels, const Hidden& hidden) {
    const float letter = ImGui::GetFontSize();
    const float pad = std::round(letter * 0.32F);
    std::vector<Placed> placed;
    for (const Label& label : labels) {
        const auto at = view.camera.project(label.place, view.size);
        if (!at) continue;
        const double seen = hidden && hidden(label.place) ? label.behind : 1;
        if (seen > 0) placed.push_back({&label, at->depth, seen});
    }
    std::stable_sort(placed.begin(), placed.end(), [](const Placed& a, const Placed& b) { return a.depth < b.depth; });
    std::vector<LabelBox> boxes;
    for (const Placed& p : placed) {
        const dvec2 at = view.camera.project(p.label->place, view.size)->at + p.label->offset;
        const ImVec2 size = ImGui::CalcTextSize(p.label->text.data(), p.label->text.data() + p.label->text.size());
        const dvec2 low = glm::round(at) - glm::round(dvec2(size.x, size.y) / 2.0) - dvec2(pad, pad * 0.6F);
        boxes.push_back({{low, low + dvec2(size.x + 2 * pad, size.y + 1.2F * pad)}, p.label->yields});
    }
    step_aside(boxes);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    for (std::size_t i = placed.size(); i-- > 0;) {
        const auto& [label, depth, seen] = placed[i];
        const auto place = [](const dvec2& p) { return ImVec2(static_cast<float>(p.x), static_cast<float>(p.y)); };
        const auto fade = [opacity_seen = seen](Colour colour, double opacity) {
            return packed(with_opacity(colour, opacity * opacity_seen * colour.a / 255.0));
        };
        const ImVec2 low = place(boxes[i].area.low);
        list.AddRectFilled(low, place(boxes[i].area.high), fade(paint::ink, 0.78), letter * 0.3F);
        list.AddText({low.x + pad, low.y + pad * 0.6F}, fade(label->colour, 1), label->text.data(),
                     label->text.data() + label->text.size());
    }
}

}  // namespace surefoot::view
