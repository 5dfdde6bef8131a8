#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <initializer_list>

#include "playground/debugger_room/contest.hpp"
#include "playground/debugger_room/contest_view.hpp"
#include "playground/debugger_room/panels_lessons.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {

namespace {

namespace ui = view::ui;

constexpr double degree = 3.14159265358979323846 / 180;

class SideBySidePanel final : public Panel {
public:
    [[nodiscard]] std::string_view name() const override { return "Side by side"; }
    void changed(const Inquiry& /*inquiry*/) override {}
    bool update(double /*dt*/, Inquiry& /*inquiry*/) override { return contest_.update(); }
    void draw(view::Renderer& renderer, const Inquiry& /*inquiry*/) override { look_.draw(renderer, contest_); }
    void ui(Inquiry& inquiry) override;
    [[nodiscard]] bool has_own_scene() const override { return true; }
    [[nodiscard]] std::vector<dvec3> scene_places() const override { return ContestView::places(contest_); }

private:
    void courses();
    void slope_ui();
    void clock_ui();
    void stairs_ui();
    void ledge_ui();

    Contest contest_;
    ContestView look_;
};

/// A table with a row for each contestant; `cells` gives the texts after its name.
template <typename Cells>
void table(std::initializer_list<const char*> titles, const Cells& cells) {
    if (!ImGui::BeginTable("contestants", static_cast<int>(titles.size()) + 1,
                           ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp | ImGuiTableFlags_PadOuterX))
        return;
    ImGui::TableNextColumn();
    for (const char* title : titles) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", title);
    }
    for (std::size_t i = 0; i < Contest::count; ++i) {
        ImGui::TableNextRow();
        cells(i);
    }
    ImGui::EndTable();
}

void cell(const std::string& text) {
    ImGui::TableNextColumn();
    ImGui::TextUnformatted(text.c_str());
}

void name_cell(const Contest& contest, std::size_t i) {
    ImGui::TableNextColumn();
    ui::key_colour(colour_of_contestant(i), contest.contestant(i).name);
}

std::string millimetres(double metres) {
    return fmt::format("{:.1f}", metres * 1e3);
}

void SideBySidePanel::courses() {
    const struct {
        const char* label;
        Course course;
    } all[] = {{"Slope", Course::slope}, {"Stairs", Course::stairs}, {"Ledge", Course::ledge}};
    for (const auto& [label, course] : all) {
        if (course != Course::slope) ImGui::SameLine();
        if (ui::radio(label, contest_.course() == course)) contest_.choose(course);
    }
}

void SideBySidePanel::ui(Inquiry& /*inquiry*/) {
    courses();
    switch (contest_.course()) {
        case Course::slope:
            slope_ui();
            break;
        case Course::stairs:
            clock_ui();
            stairs_ui();
            break;
        case Course::ledge:
            clock_ui();
            ledge_ui();
            break;
    }
}

void SideBySidePanel::slope_ui() {
    double degrees = contest_.angle() / degree;
    if (ui::slider("Angle", degrees, Contest::flattest / degree, Contest::steepest / degree, "%.1f°"))
        contest_.set_angle(degrees * degree);
    for (const int preset : {10, 30, 45}) {
        if (preset != 10) ImGui::SameLine();
        if (ui::button(fmt::format("{}°", preset).c_str())) contest_.set_angle(preset * degree);
    }
    table({"gap", "− skin", "closed form"}, [&](std::size_t i) {
        const debugger::SlopeReading& reading = contest_.slope(i);
        const double skin = reading.clearance / std::cos(contest_.angle());
        name_cell(contest_, i);
        cell(millimetres(reading.gap));
        cell(millimetres(reading.gap - skin));
        cell(millimetres(reading.expected - skin));
    });
    for (std::size_t i = 1; i < Contest::count; ++i) {  // a box, squarely to the slope, has the cylinder's
        const std::string names = (i == 1 ? contest_.contestant(0).name + ", " : "") + contest_.contestant(i).name;
        ui::note(fmt::format("{}: {}", names, formula_of_contestant(i)));
    }
    ui::note(
        "Millimetres, from the foot straight down; w is half the width, h half the height. The gap is measured by a "
        "ray "
        "where the body came to rest. The skin, 10 mm, is what it is larger by all round when it meets something: "
        "seen along a slope, corners and tips are farther off.");
}

void SideBySidePanel::clock_ui() {
    double speed = contest_.speed();
    if (ui::slider("Speed", speed, Contest::slowest, Contest::fastest, "%.2f m/s")) contest_.set_speed(speed);
    if (contest_.plays() ? ui::primary_button("Pause", 64) : ui::primary_button("Play", 64)) {
        if (contest_.plays()) {
            contest_.pause();
        } else {
            contest_.play();
        }
    }
    ImGui::SameLine();
    if (ui::button("Back")) contest_.step(-1);
    ImGui::SameLine();
    if (ui::button("Step")) contest_.step();
    ImGui::SameLine();
    if (ui::button("Restart")) contest_.restart();
    double tick = contest_.tick();
    if (ui::slider("Tick", tick, 0, contest_.last_tick(), "%.0f")) contest_.go_to(static_cast<int>(tick + 0.5));
}

void SideBySidePanel::stairs_ui() {
    table({"climbed", "axis at"}, [&](std::size_t i) {
        name_cell(contest_, i);
        cell(fmt::format("{:.3f} m", contest_.climbed(i)));
        cell(fmt::format("{:.3f} m", contest_.position(i).x));
    });
    ui::note(
        "Eight stairs of 20 cm begin at 0, and step_up is 40 cm: everybody walks up. The side of the cone meets the "
        "edge "
        "as a slope of 77 degrees, which is a wall; it steps up all the same.");
}

void SideBySidePanel::ledge_ui() {
    bool sunk = contest_.shows_sunk();
    if (ui::checkbox("Each where it has sunk 5 cm", sunk)) contest_.show_sunk(sunk);
    table({"out by", "closed form", "tick"}, [&](std::size_t i) {
        const debugger::LedgeReading& reading = contest_.ledge(i);
        const debugger::Contestant& contestant = contest_.contestant(i);
        name_cell(contest_, i);
        cell(reading.overhang ? millimetres(*reading.overhang) : "never");
        cell(millimetres(debugger::overhang(contestant.shape, Contest::sink)));
        cell(std::to_string(contest_.tick_of(i)));
    });
    ui::note(
        "Millimetres by which the axis is beyond the edge when the foot has sunk 5 cm. The measured one comes later, "
        "by "
        "the skin and by how far it goes on while it falls so far.");
}

}  // namespace

std::unique_ptr<Panel> make_side_by_side_panel() {
    return std::make_unique<SideBySidePanel>();
}

}  // namespace surefoot::playground
