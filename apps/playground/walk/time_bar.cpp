#include "playground/walk/time_bar.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <imgui.h>

#include "view/theme.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

namespace ui = view::ui;

struct EventWord {
    CharacterEvent event;
    const char* word;
};

constexpr EventWord words[] = {{CharacterEvent::jumped, "jumped"},
                               {CharacterEvent::landed, "landed"},
                               {CharacterEvent::left_ground, "left the ground"},
                               {CharacterEvent::stepped_up, "stepped up"},
                               {CharacterEvent::snapped_down, "snapped down"},
                               {CharacterEvent::blocked, "blocked"},
                               {CharacterEvent::hit_ceiling, "hit the ceiling"},
                               {CharacterEvent::crushed, "crushed"},
                               {CharacterEvent::stuck, "stuck"},
                               {CharacterEvent::recovered, "moved out of what it was in"},
                               {CharacterEvent::overflow, "too much at once"},
                               {CharacterEvent::dashed, "dashed"},
                               {CharacterEvent::climbing, "on a ladder"},
                               {CharacterEvent::no_room, "no room to stand up"},
                               {CharacterEvent::invalid, "invalid settings: it stands still"},
                               {CharacterEvent::grabbed_ledge, "grabbed an edge"},
                               {CharacterEvent::dropped_ledge, "let go of the edge"},
                               {CharacterEvent::climbed_ledge, "climbed up"},
                               {CharacterEvent::vaulted, "vaulted"}};

const char* footing_text(const CharacterState& state) {
    switch (state.footing) {
        case Footing::ground:
            return state.form == CharacterForm::crouched ? "crouched" : "on ground";
        case Footing::steep:
            return "on ground that is too steep";
        case Footing::ledge:
            return state.hold == Hold::climbing ? "climbing" : "hanging";
        case Footing::air:
            break;
    }
    return "in the air";
}

view::Colour footing_colour(Footing footing) {
    return footing == Footing::ground  ? view::paint::end
           : footing == Footing::air   ? view::paint::result
           : footing == Footing::ledge ? view::paint::vertex
                                       : view::paint::start;
}

void why_text(const Walker& walker) {
    const Walker::Stop stop = walker.last_stop();
    if (stop.step == nullptr) {
        ui::note("Nothing has stopped it yet.");
        return;
    }
    const float top = ImGui::GetCursorPosY();
    ui::note(stop.ago < Walker::tick / 2
                 ? std::string("In this step:")
                 : fmt::format("The last time something was in the way, {:.2f} s ago:", stop.ago));
    constexpr std::size_t most = 4;
    const auto sentences = walker.why(*stop.step);
    ImGui::PushTextWrapPos(0);
    for (std::size_t i = 0; i < std::min(sentences.size(), most); ++i)
        ImGui::TextUnformatted(sentences[i].text.c_str());
    ImGui::PopTextWrapPos();
    // As high whatever is told, so that the picture above does not move with every sentence.
    constexpr float lines = 5.5F;
    ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), top + lines * ImGui::GetTextLineHeightWithSpacing()));
}

void past_slider(Walker& walker) {
    ImGui::SetNextItemWidth(-1);
    auto at = static_cast<int>(walker.looks_at());
    const int end = static_cast<int>(walker.ticks());
    const std::string format = at == end ? fmt::format("now, {:.1f} s remembered", end * Walker::tick)
                                         : fmt::format("{:.2f} s ago", (end - at) * Walker::tick);
    ImGui::BeginDisabled(end == 0);
    if (ImGui::SliderInt("##past", &at, 0, std::max(end, 1), format.c_str(), ImGuiSliderFlags_AlwaysClamp))
        walker.look_at(static_cast<std::size_t>(at));
    ImGui::EndDisabled();
    ui::item("Past");
}

void speed_choice(Walker& walker) {
    constexpr std::array<double, 4> speeds{1, 0.5, 0.2, 0.05};
    constexpr std::array<const char*, 4> names{"1x", "1/2", "1/5", "1/20"};
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        ImGui::SameLine();
        if (ui::radio(names[i], walker.speed == speeds[i])) walker.speed = speeds[i];
    }
}

}  // namespace

std::string state_text(const Walker& walker) {
    const CharacterState& state = walker.state();
    std::string text = fmt::format("{}, {:.2f} m/s", footing_text(state), glm::length(state.velocity));
    if (const ToldStep* const told = walker.told()) {
        const char* before = "; ";
        for (const EventWord& one : words) {
            if (!told->result.events.has(one.event)) continue;
            text += before;
            text += one.word;
            before = ", ";
        }
    }
    return text;
}

void toggle_pause(Walker& walker) {
    if (walker.paused) walker.go_on_from_here();
    walker.paused = !walker.paused;
}

void step_back(Walker& walker) {
    walker.paused = true;
    if (walker.looks_at() > 0) walker.look_at(walker.looks_at() - 1);
}

void time_bar(Walker& walker, bool why, double left, double right, const std::function<void()>& step) {
    constexpr float margin = 14;
    const auto x = static_cast<float>(left);
    ImGui::SetNextWindowPos({x, ImGui::GetIO().DisplaySize.y - margin}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowSize({std::max(static_cast<float>(right) - x, 160.0F), 0}, ImGuiCond_Always);
    if (ImGui::Begin("##time", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                         ImGuiWindowFlags_NoFocusOnAppearing)) {
        ui::covers();
        ui::key_colour(footing_colour(walker.state().footing), state_text(walker));
        if (why) why_text(walker);
        if (ui::button(walker.paused ? "Go on##pause" : "Pause##pause")) toggle_pause(walker);
        ui::hint("P. From the past it goes on from there; what came after is forgotten.");
        ImGui::SameLine();
        if (ui::button("<")) step_back(walker);
        ui::hint("One step back (comma).");
        ImGui::SameLine();
        if (ui::button(">")) {
            walker.paused = true;
            step();
        }
        ui::hint("One step (full stop).");
        speed_choice(walker);
        // In a narrow window the slider has a line of its own.
        if (ImGui::GetWindowWidth() > 34 * ImGui::GetFontSize()) ImGui::SameLine();
        past_slider(walker);
    }
    ImGui::End();
}

}  // namespace surefoot::playground
