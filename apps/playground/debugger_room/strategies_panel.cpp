// Strategies: one motion, looked at in its end, at samples, and solved for its first touch.
#include <algorithm>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <imgui.h>
#include <vector>

#include "debugger/equation.hpp"
#include "debugger/strategies.hpp"
#include "playground/debugger_room/panels_maths.hpp"
#include "playground/debugger_room/sample_path.hpp"
#include "playground/debugger_room/subjects.hpp"
#include "text.hpp"
#include "view/theme.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

namespace paint = view::paint;
namespace ui = view::ui;
using debugger::short_text;

constexpr std::size_t most_outlines = 48;  // more are drawn as points

class StrategiesPanel final : public Panel {
public:
    [[nodiscard]] std::string_view name() const override { return "Strategies"; }
    void changed(const Inquiry& inquiry) override;
    void draw(view::Renderer& renderer, const Inquiry& inquiry) override;
    void ui(Inquiry& inquiry) override;

private:
    void look_again(const Inquiry& inquiry);
    void pace_ui(const Inquiry& inquiry);
    void way_ui(double t) const;
    static void finding_ui(const char* title, view::Colour colour, const debugger::Finding& finding);

    std::optional<std::string> refusal_;
    double length_ = 0;
    std::vector<debugger::TouchingPart> parts_;
    debugger::Finding at_end_;
    debugger::Finding at_samples_;
    debugger::Finding solved_;
    std::vector<Sample> samples_;
    debugger::Tunnelling tunnelling_;
    Pace pace_;
};

void StrategiesPanel::changed(const Inquiry& inquiry) {
    refusal_ = why_no_answer(inquiry);
    samples_.clear();
    if (refusal_) return;
    const auto& q = inquiry.question;
    length_ = glm::length(q.motion.to - q.motion.from);
    parts_ = debugger::touching_parts(inquiry.arena, q.volume(), q.motion, q.one_sided);
    at_end_ = debugger::look_at_end(inquiry.arena, q.volume(), q.motion, q.one_sided);
    solved_ = debugger::solve(inquiry.arena, q.volume(), q.motion, q.one_sided);
    look_again(inquiry);
}

void StrategiesPanel::look_again(const Inquiry& inquiry) {
    const auto& q = inquiry.question;
    at_samples_ = debugger::look_at_samples(inquiry.arena, q.volume(), q.motion, pace_.step(), q.one_sided);
    samples_ = samples_along(inquiry.arena, q.volume(), q.motion, pace_.step(), q.one_sided);
    tunnelling_ = debugger::tunnelling(parts_, length_, pace_.speed);
}

void StrategiesPanel::draw(view::Renderer& renderer, const Inquiry& inquiry) {
    const Volume volume = inquiry.question.volume();
    const bool outlines = samples_.size() <= most_outlines;
    bool found = false;
    for (const Sample& sample : samples_) {
        const view::Colour colour = sample.touches ? paint::start : paint::ink;
        const double opacity = sample.looked ? 0.9 : 0.35;
        const bool first = sample.touches && !found;
        found = found || sample.touches;
        const bool at_end = sample.position == inquiry.question.motion.to;  // the room draws END itself
        if (first || (outlines && !at_end))
            renderer.shape(volume, sample.position,
                           {.colour = view::with_opacity(colour, opacity),
                            .opacity = sample.touches ? 0.16 : 0.04,
                            .outline = sample.touches ? 2.0 : 1.2,
                            .casts_shadow = false});
        renderer.point(sample.position, first ? 9 : 6, view::with_opacity(colour, opacity));
    }
}

void StrategiesPanel::ui(Inquiry& inquiry) {
    if (refusal_) {
        ui::note(*refusal_);
        return;
    }
    finding_ui("Static", paint::end, at_end_);
    finding_ui("Iterative", paint::paper, at_samples_);
    finding_ui("Analytic", paint::hit, solved_);
    ImGui::Separator();
    pace_ui(inquiry);
    way_ui(inquiry.t);
    ui::wrapped(tunnelling_.text);
    if (tunnelling_.begins_above)
        ui::note(fmt::format("A step of up to {} m misses nothing.", short_text(*tunnelling_.begins_above)));
    if (tunnelling_.always_above)
        ui::note(fmt::format("One above {} m misses it always; between, it is luck.",
                             short_text(*tunnelling_.always_above)));
}

void StrategiesPanel::finding_ui(const char* title, view::Colour colour, const debugger::Finding& finding) {
    ui::key_colour(colour, title);
    ui::at_right(finding.looks == 1 ? "1 question" : tools::grouped(finding.looks) + " questions");
    ImGui::Indent();
    ImGui::PushStyleColor(ImGuiCol_Text, view::to_imgui(finding.missed ? view::rgb(0xF08A80) : paint::paper));
    ui::wrapped(finding.text);
    ImGui::PopStyleColor();
    ImGui::Unindent();
}

void StrategiesPanel::pace_ui(const Inquiry& inquiry) {
    constexpr double lowest_rate = 0.5;
    constexpr double highest_rate = 240;
    bool turned = ui::slider("Speed [m/s]", pace_.speed, 0.5, 100, "%.1f", true);
    turned = ui::slider("Frames a second", pace_.rate, lowest_rate, highest_rate, "%.2f", true) || turned;
    double step = pace_.step();
    if (ui::slider("Step [m]", step, pace_.speed / highest_rate, pace_.speed / lowest_rate, "%.3f", true)) {
        pace_.set_step(step);
        turned = true;
    }
    if (turned) look_again(inquiry);
}

/// The motion as a line: where it is in touch, and where samples fall.
void StrategiesPanel::way_ui(double t) const {
    const float letter = ImGui::GetFontSize();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    ImGui::Dummy({width, 2.9F * letter});
    if (!(length_ > 0)) return;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float left = corner.x + 5;
    const float right = corner.x + width - 5;
    const float top = corner.y + 4;
    const float bottom = top + 1.2F * letter;
    const auto x = [&](double along) { return left + static_cast<float>(along / length_) * (right - left); };
    list.AddRectFilled({left, top}, {right, bottom}, view::packed(view::rgb(0x10161C, 0.7)), 3);
    for (const debugger::TouchingPart& part : parts_)
        list.AddRectFilled({x(part.begin), top}, {std::max(x(part.end), x(part.begin) + 2), bottom},
                           view::packed(view::with_opacity(paint::hit, 0.55)));
    for (const Sample& sample : samples_)
        list.AddLine(
            {x(sample.along), top - 3}, {x(sample.along), bottom + 3},
            view::packed(view::with_opacity(sample.touches ? paint::start : paint::paper, sample.looked ? 0.95 : 0.4)),
            sample.touches ? 3.0F : 1.6F);
    list.AddTriangleFilled({x(t * length_) - 4, top - 5}, {x(t * length_) + 4, top - 5}, {x(t * length_), top + 2},
                           view::packed(paint::accent));
    const view::Colour quiet = view::rgb(0x94A3AF);
    list.AddText({left, bottom + 4}, view::packed(quiet), "START");
    const std::string end = fmt::format("END, {} m", short_text(length_));
    list.AddText({right - ImGui::CalcTextSize(end.c_str()).x, bottom + 4}, view::packed(quiet), end.c_str());
    if (parts_.empty()) return;
    const std::string touch = "in touch";
    const float half = ImGui::CalcTextSize(touch.c_str()).x / 2;
    const float middle = (x(parts_.front().begin) + x(parts_.front().end)) / 2;
    list.AddText({std::clamp(middle - half, left + 3.6F * letter, right - 7.5F * letter - 2 * half), bottom + 4},
                 view::packed(paint::hit), touch.c_str());
}

}  // namespace

std::unique_ptr<Panel> make_strategies_panel() {
    return std::make_unique<StrategiesPanel>();
}

}  // namespace surefoot::playground
