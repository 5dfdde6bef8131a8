#include "playground/debugger_room/question_panel.hpp"

#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <glm/gtc/quaternion.hpp>
#include <glm/trigonometric.hpp>
#include <imgui.h>

#include "debugger/worlds.hpp"
#include "playground/debugger_room/number_row.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

namespace ui = view::ui;
using debugger::Question;
using debugger::WorldKind;

constexpr std::array shape_names{"Sphere", "Ellipsoid", "Capsule", "Box", "Cylinder", "Cone"};
constexpr std::array world_names{"One triangle", "Fold", "Acute wedge", "Own triangles", "Level"};
constexpr double least_size = 1e-3;  // that a drag makes [m]
constexpr double most_size = 1e4;

void tell(Investigation& asked, const RowNews& news, const debugger::Edit& edit) {
    if (news.begun) asked.begin_drag();
    if (news.changed) asked.apply(edit);
    if (news.ended) asked.end_drag();
}

RowNews size_row(const char* label, double& value, double least = least_size) {
    static constexpr std::array names{""};
    return number_row(label, {&value, 1}, {.names = names, .speed = 0.005, .low = least, .high = most_size});
}

/// Rows for the sizes of each shape; true if one has changed.
struct SizeRows {
    RowNews news{};

    void add(const RowNews& row) {
        news.begun |= row.begun;
        news.changed |= row.changed;
        news.ended |= row.ended;
    }
    void operator()(Sphere& s) { add(size_row("Radius", s.radius)); }
    void operator()(Ellipsoid& s) { add(vector_row("Radii", s.radii, 0.005, least_size, most_size)); }
    void operator()(Capsule& s) {
        add(size_row("Radius", s.radius));
        add(size_row("Straight/2", s.half_height, 0));
        ui::hint("Half of the straight part between the two half balls.");
    }
    void operator()(Box& s) { add(vector_row("Half", s.half_extents, 0.005, least_size, most_size)); }
    void operator()(Cylinder& s) {
        add(size_row("Radius", s.radius));
        add(size_row("Height/2", s.half_height));
    }
    void operator()(Cone& s) {
        add(size_row("Radius", s.radius));
        add(size_row("Height", s.height));
    }
};

}  // namespace

void QuestionPanel::shape_rows(Investigation& asked) {
    int shape = static_cast<int>(asked.question().shape);
    if (ui::choice("Shape", shape, shape_names))
        asked.apply(debugger::ChooseShape{static_cast<debugger::ShapeName>(shape)});
    Shape sized = asked.question().volume().shape;
    SizeRows rows;
    std::visit(rows, sized);
    tell(asked, rows.news, debugger::Resize{sized});
}

void QuestionPanel::turn_row(Investigation& asked) {
    const dquat& now = asked.question().orientation;
    if (!(turned_ == now)) {
        turned_ = now;
        angles_ = glm::degrees(glm::eulerAngles(glm::normalize(now)));
    }
    const RowNews news = vector_row("Turn", angles_, 0.5);
    ui::hint("Degrees about x, then y, then z. Kept as a quaternion.");
    if (news.changed) turned_ = dquat(glm::radians(angles_));
    tell(asked, news, debugger::Turn{turned_});
}

void QuestionPanel::place_rows(Investigation& asked) {
    dvec3 start = asked.question().motion.from;
    const RowNews start_news = vector_row("START", start, 0.01);
    tell(asked, start_news, debugger::MoveStart{start});
    dvec3 end = asked.question().motion.to;
    const RowNews end_news = vector_row("END", end, 0.01);
    tell(asked, end_news, debugger::MoveEnd{end});
    constexpr std::size_t most_typed = 4;
    const std::size_t count = asked.question().triangles.size();
    if (count == 0 || count > most_typed || !ui::section("Corners", false)) return;
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            dvec3 place = debugger::corners_of(asked.question().triangles[i])[corner];
            const std::string label = count == 1 ? std::string{"abc"[corner]} : fmt::format("{} {}", i, "abc"[corner]);
            const RowNews news = vector_row(label.c_str(), place, 0.01);
            tell(asked, news, debugger::MoveCorner{.triangle = i, .corner = corner, .to = place});
        }
    }
}

QuestionPanel::Wishes QuestionPanel::ui(Investigation& asked) {
    Wishes wishes;
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {6, 3});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 5});
    int world = static_cast<int>(asked.question().world);
    if (ui::choice("World", world, world_names)) {
        const auto chosen = static_cast<WorldKind>(world);
        if (chosen == WorldKind::own || chosen == WorldKind::level) {
            wishes.open = true;
        } else {
            asked.choose_world(chosen);
            wishes.framed = true;
        }
    }
    if (asked.level())
        ui::note(fmt::format("{}: {} triangles", std::filesystem::path(asked.question().level).filename().string(),
                             asked.level()->level.mesh.triangle_count()));
    shape_rows(asked);
    turn_row(asked);
    place_rows(asked);
    bool one_sided = asked.question().one_sided;
    if (ui::checkbox("One-sided", one_sided)) asked.apply(debugger::ChooseSides{one_sided});
    ui::hint("Triangles stop only what comes from their front, from where their corners go counter-clockwise.");
    ImGui::SameLine();
    ui::note("Shift snaps to");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    const double least = 0.001;
    const double most = 1000;
    ImGui::DragScalar("##grid", ImGuiDataType_Double, &grid, 0.005F, &least, &most, "%.4g m");
    ui::item("Grid");
    ImGui::PopStyleVar(2);
    for (const debugger::Remark& remark : debugger::remarks(asked.question())) {
        ImGui::PushTextWrapPos(0);
        if (remark.refused)
            ImGui::TextColored({0.96F, 0.62F, 0.45F, 1}, "%s", remark.text.c_str());
        else
            ImGui::TextDisabled("%s", remark.text.c_str());
        ImGui::PopTextWrapPos();
    }
    const auto label_of = [](const char* what, const std::string& title) {
        return title.empty() ? std::string(what) : fmt::format("{}: {}", what, title);
    };
    const auto step = [](const char* what, const std::string& label, bool any) {
        ImGui::BeginDisabled(!any);
        const bool pressed = ImGui::Button((label + "##" + what).c_str());
        ImGui::EndDisabled();
        ui::item(what);
        return pressed;
    };
    const std::string undo_title = asked.history().undo_title();
    const std::string redo_title = asked.history().redo_title();
    const std::string undo = label_of("Undo", undo_title);
    const std::string redo = label_of("Redo", redo_title);
    const ImGuiStyle& style = ImGui::GetStyle();
    const float both = ImGui::CalcTextSize((undo + redo).c_str()).x + 4 * style.FramePadding.x + style.ItemSpacing.x;
    const bool in_a_line = both <= ImGui::GetContentRegionAvail().x;
    if (step("Undo", undo, !undo_title.empty())) asked.undo();
    if (in_a_line) ImGui::SameLine();
    if (step("Redo", redo, !redo_title.empty())) asked.redo();
    if (ui::button("Open ...")) wishes.open = true;
    ui::hint("A level, or a saved moment. Dropping the file on the window does the same.");
    ImGui::SameLine();
    wishes.copy = ui::button("Copy");
    ui::hint("The question, as the line of JSON that the command line reads.");
    ImGui::SameLine();
    wishes.paste = ui::button("Paste");
    return wishes;
}

}  // namespace surefoot::playground
