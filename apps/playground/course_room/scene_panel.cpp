#include "playground/course_room/scene_panel.hpp"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

namespace ui = view::ui;

/// A list of which one is chosen; `text` and `says` are asked for each by its number. -1 if none was chosen now.
template <typename Text, typename Says>
int list(const char* label, std::size_t count, std::size_t chosen, const Text& text, const Says& says) {
    int picked = -1;
    ImGui::SetNextItemWidth(-1);
    ImGui::PushID(label);
    const bool open = ImGui::BeginCombo("##list", text(chosen).c_str(), ImGuiComboFlags_HeightLarge);
    ui::item(label);
    if (open) {
        for (std::size_t i = 0; i < count; ++i) {
            if (ui::row(text(i).c_str(), i == chosen)) picked = static_cast<int>(i);
            if (i == chosen && ImGui::IsWindowAppearing()) ImGui::SetScrollHereY();
            const std::string hint = says(i);
            if (!hint.empty()) ui::hint(hint);
        }
        ImGui::EndCombo();
    }
    ImGui::PopID();
    return picked;
}

/// "none", then all but ours that this build has.
const std::vector<course::MoverName>& ghosts() {
    static const auto all = [] {
        std::vector<course::MoverName> names{{"none", "Ours walks alone."}};
        for (const course::MoverName& one : course::movers())
            if (one.name != "ours" && course::make_mover(one.name)) names.push_back(one);
        return names;
    }();
    return all;
}

/// "at most 0.02 m: because", without a space where there is no unit.
std::string bar_text(const course::Bar& bar) {
    return fmt::format("at most {:.3g}{}{}: {}", bar.most, bar.unit.empty() ? "" : " ", bar.unit, bar.reason);
}

}  // namespace

bool ScenePanel::update() {
    for (Measuring& one : measured_)
        if (!one.is_done()) return one.go_on() || true;
    return false;
}

bool ScenePanel::ui(const course::Scenes& scenes, CourseChoice& choice) {
    const CourseChoice before = choice;
    const int scene = list(
        "Scene", scenes.size(), choice.scene, [&](std::size_t i) { return scenes[i].name; },
        [&](std::size_t i) { return scenes[i].title; });
    if (scene >= 0) {
        choice.scene = static_cast<std::size_t>(scene);
        choice.run = 0;
    }
    const course::Scene& now = scenes[choice.scene];
    ui::note(now.title);
    const int run = list(
        "One run", now.runs.size(), choice.run, [&](std::size_t i) { return now.runs[i].name; },
        [](std::size_t) { return std::string(); });
    if (run >= 0) choice.run = static_cast<std::size_t>(run);
    ghost(choice);
    if (choice.scene != before.scene || choice.other != before.other) forget_measures();
    ImGui::Separator();
    bars(scenes[choice.scene], choice);
    return !(choice == before);
}

void ScenePanel::ghost(CourseChoice& choice) {
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < ghosts().size(); ++i)
        if (ghosts()[i].name == choice.other.mover) chosen = i;
    const bool is_program = !choice.other.command.empty();
    ImGui::TextUnformatted("Beside the ghost of");
    const int other = list(
        "Ghost", ghosts().size(), chosen,
        [&](std::size_t i) { return i == chosen && is_program ? "a program" : std::string(ghosts()[i].name); },
        [](std::size_t i) { return std::string(ghosts()[i].about); });
    if (other >= 0)
        choice.other = {.mover = other == 0 ? "" : std::string(ghosts()[static_cast<std::size_t>(other)].name)};
    ui::note(is_program ? choice.other.command : std::string(ghosts()[chosen].about));
    ImGui::SetNextItemWidth(-1);
    bool take = ImGui::InputTextWithHint("##program", "or a program: node my-mover.mjs", &command_,
                                         ImGuiInputTextFlags_EnterReturnsTrue);
    ui::item("Program");
    ui::hint("Started by the shell; it reads and writes the lines of docs/course-protocol.md.");
    take = ui::button("Walk the program") || take;
    if (take && !command_.empty()) choice.other = {.command = command_};
    if (!failure_.empty()) {
        ui::key_colour(view::paint::start, choice.other.name() + " gave up:");
        ImGui::TextWrapped("%s", failure_.c_str());
    }
}

void ScenePanel::bars(const course::Scene& scene, const CourseChoice& choice) {
    if (ui::button("Measure all runs")) {
        measured_.clear();
        measured_.emplace_back(scene, Rival{.mover = "ours"});
        if (!choice.other.is_nobody()) measured_.emplace_back(scene, choice.other);
    }
    ui::hint("Walks every run of this scene with both, and holds the worst of all against each bar.");
    for (const Measuring& one : measured_)
        if (!one.is_done()) ui::note(fmt::format("{}: {} of {} runs", one.mover(), one.runs_done(), scene.runs.size()));
    for (std::size_t i = 0; i < scene.bars.size(); ++i) {
        const course::Bar& bar = scene.bars[i];
        ui::heading(bar.what);
        ui::wrapped(bar_text(bar));
        for (const Measuring& one : measured_) {
            if (!one.is_done() || one.score().marks.size() <= i) continue;
            const course::Mark& mark = one.score().marks[i];
            ui::key_colour(mark.passes() ? view::paint::end : view::paint::start,
                           fmt::format("{}: {:.3g}", one.mover(), mark.worst.value));
            if (!mark.passes()) ui::note("in the run " + mark.worst.where);
        }
    }
    for (const Measuring& one : measured_)
        if (one.is_done() && !one.score().failure.empty())
            ui::key_colour(view::paint::start, fmt::format("{} gave up: {}", one.mover(), one.score().failure));
}

}  // namespace surefoot::playground
