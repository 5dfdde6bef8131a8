#include "playground/debugger_room/answer_rows.hpp"

#include <fmt/format.h>
#include <imgui.h>

#include "debugger/equation.hpp"
#include "playground/debugger_room/feature_light.hpp"
#include "view/fonts.hpp"
#include "view/theme.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

using debugger::short_text;

std::string with_superscript(std::string text) {
    if (const auto at = text.find("t^2"); at != std::string::npos) text.replace(at, 3, "t\u00B2");
    return text;
}

std::string roots_text(const debugger::Roots& roots) {
    if (roots.count == 0) return "";
    if (roots.count == 1) return fmt::format("t = {}. ", short_text(roots.lower));
    return fmt::format("t = {}, {}. ", short_text(roots.lower), short_text(roots.upper));
}

/// Is this plane a reason for the answer, or against one?
bool bears_on(const debugger::PlaneRow& plane) {
    if (plane.verdict == Verdict::enters || plane.verdict == Verdict::leaves)
        return plane.t && *plane.t >= 0 && *plane.t <= 1;
    return plane.verdict != Verdict::inside;
}

std::string sentence(std::string text) {
    if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    return text;
}

}  // namespace

std::vector<AnswerRow> rows_of(const debugger::MethodTable& table) {
    std::vector<AnswerRow> rows;
    for (std::size_t i = 0; i < table.candidates.size(); ++i) {
        const debugger::Candidate& candidate = table.candidates[i];
        rows.push_back({candidate.name, with_superscript(candidate.equation.text()),
                        roots_text(candidate.roots) + sentence(candidate.why), colour_of(candidate.feature),
                        candidate.kept, table.answer == i});
    }
    return rows;
}

std::vector<AnswerRow> rows_of(const debugger::PlaneTable& table) {
    std::vector<AnswerRow> rows;
    for (const debugger::PlaneRow& plane : table.rows) {
        const Feature feature = plane.proposed_by.starts_with("edge")     ? Feature::edge
                                : plane.proposed_by.starts_with("vertex") ? Feature::vertex
                                                                          : Feature::face;
        rows.push_back({plane.proposed_by,
                        fmt::format("gap {} to {} m", short_text(plane.gap_from), short_text(plane.gap_to)),
                        sentence(plane.why), colour_of(feature), bears_on(plane), plane.answer});
    }
    return rows;
}

std::optional<std::size_t> answer_rows(const std::vector<AnswerRow>& rows, std::optional<std::size_t>& pinned) {
    std::optional<std::size_t> hovered;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 2});
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float letter = ImGui::GetFontSize();
    const float line = ImGui::GetTextLineHeight();
    const float small = letter * 0.88F;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const AnswerRow& row = rows[i];
        ImGui::PushID(static_cast<int>(i));
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x;
        const float wrap = width - 1.2F * letter;
        const ImVec2 became = view::fonts().plain != nullptr
                                  ? view::fonts().plain->CalcTextSizeA(small, 1e9F, wrap, row.became.c_str())
                                  : ImGui::CalcTextSize(row.became.c_str(), nullptr, false, wrap);
        const ImVec2 size(width, line + became.y + 0.3F * letter);
        if (row.answer)
            list.AddRectFilled(corner, {corner.x + size.x, corner.y + size.y},
                               view::packed(view::with_opacity(view::paint::hit, 0.22)), 5);
        if (ImGui::Selectable("##row", pinned == i, ImGuiSelectableFlags_None, size))
            pinned = pinned == i ? std::nullopt : std::optional(i);
        view::ui::item(row.name.c_str());
        if (ImGui::IsItemHovered()) hovered = i;
        ImFont* const plain = ImGui::GetFont();
        list.AddRectFilled({corner.x, corner.y + 2}, {corner.x + 4, corner.y + size.y - 2}, view::packed(row.colour),
                           2);
        const float left = corner.x + 0.7F * letter;
        list.AddText(plain, letter, {left, corner.y}, view::packed(row.colour), row.name.c_str());
        ImFont* const mono = view::fonts().mono != nullptr ? view::fonts().mono : plain;
        list.AddText(mono, letter * 0.95F, {left + 4.6F * letter, corner.y}, view::packed(view::paint::paper),
                     row.asked.c_str());
        const view::Colour quiet = row.answer ? view::paint::hit : row.kept ? view::rgb(0x7FD8C8) : view::rgb(0x94A3AF);
        list.AddText(plain, small, {left, corner.y + line}, view::packed(quiet), row.became.c_str(), nullptr, wrap);
        ImGui::PopID();
    }
    ImGui::PopStyleVar();
    return hovered ? hovered : pinned;
}

}  // namespace surefoot::playground
