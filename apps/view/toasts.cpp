#include "view/toasts.hpp"

#include <algorithm>
#include <imgui.h>

#include "view/colour.hpp"
#include "view/theme.hpp"
#include "view/widgets.hpp"

namespace surefoot::view {
namespace {

constexpr std::size_t most = 4;

}  // namespace

void Toasts::say(std::string text, Kind kind) {
    // Long enough to be read.
    const double life = std::clamp(2.5 + 0.05 * double(text.size()), 3.0, 10.0);
    toasts_.push_back({std::move(text), kind, 0, life});
    if (toasts_.size() > most) toasts_.erase(toasts_.begin());
}

bool Toasts::update(double dt) {
    for (Toast& toast : toasts_) toast.age += dt;
    std::erase_if(toasts_, [](const Toast& toast) { return toast.age > toast.life; });
    return !toasts_.empty();
}

void Toasts::draw(double free) const {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const float letter = ImGui::GetFontSize();
    // At the bottom of what panels leave free: what a toast lies on, nobody can press.
    const Area part = ui::uncovered(ivec2(static_cast<int>(size.x), static_cast<int>(size.y)));
    const auto middle = static_cast<float>(part.middle().x);
    float bottom = static_cast<float>(std::min(double(part.high.y), size.y - free)) - letter;
    ImDrawList& list = *ImGui::GetForegroundDrawList();
    for (auto toast = toasts_.rbegin(); toast != toasts_.rend(); ++toast) {
        const char* const begin = toast->text.data();
        const char* const end = begin + toast->text.size();
        const float wrap = std::min(std::max(static_cast<float>(part.size().x) * 0.85F, letter * 16), letter * 48);
        const ImVec2 text = ImGui::CalcTextSize(begin, end, false, wrap);
        const double opacity = std::clamp(std::min(toast->age / 0.15, (toast->life - toast->age) / 0.4), 0.0, 1.0);
        const float pad = letter * 0.75F;
        const ImVec2 low(middle - text.x / 2 - pad, bottom - text.y - 1.4F * pad);
        const ImVec2 high(middle + text.x / 2 + pad, bottom);
        const Colour mark = toast->kind == Kind::warning ? paint::hit : paint::accent;
        list.AddRectFilled(low, high, packed(with_opacity(rgb(0x1B242D), 0.95 * opacity)), letter * 0.5F);
        list.AddRectFilled({low.x, low.y + letter * 0.4F}, {low.x + letter * 0.22F, high.y - letter * 0.4F},
                           packed(with_opacity(mark, opacity)), letter * 0.1F);
        list.AddText(nullptr, 0, {low.x + pad, low.y + 0.7F * pad}, packed(with_opacity(paint::paper, opacity)), begin,
                     end, wrap);
        bottom = low.y - letter * 0.5F;
    }
}

std::vector<std::string> Toasts::texts() const {
    std::vector<std::string> all;
    for (const Toast& toast : toasts_) all.push_back(toast.text);
    return all;
}

}  // namespace surefoot::view
