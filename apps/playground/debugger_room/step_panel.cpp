// A step: why it went as it did, line by line, and how it would go with other settings.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <imgui.h>
#include <optional>

#include "character_words.hpp"
#include "debugger/step_study.hpp"
#include "debugger/step_words.hpp"
#include "debugger/support.hpp"
#include "playground/debugger_room/panels_maths.hpp"
#include "playground/feature_mark.hpp"
#include "playground/step_look.hpp"
#include "text.hpp"
#include "view/fonts.hpp"
#include "view/shapes.hpp"
#include "view/theme.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

namespace ui = view::ui;
namespace paint = view::paint;
using debugger::StepStudy;

constexpr view::Colour ghost = paint::vertex;  // of the step with other settings

/// From the reference point to the middle of the body.
dvec3 middle_of(const Volume& volume) {
    const Bounds box = debugger::bounds_of(volume, {0, 0, 0});
    return (box.min + box.max) * 0.5;
}

Neighbour body_of(const debugger::MadeStep& step, const CharacterState& state) {
    CharacterInput input = step.order.input;
    input.up = debugger::up_of(input);
    return neighbour_of(step.order.settings, input, state);
}

class StepPanel final : public Panel {
public:
    [[nodiscard]] std::string_view name() const override { return step_panel_name; }
    void enter(Stage& stage) override { stage_ = &stage; }
    void changed(const Inquiry& inquiry) override;
    void draw(view::Renderer& renderer, const Inquiry& inquiry) override;
    void ui(Inquiry& inquiry) override;

private:
    void about_ui(const Inquiry& inquiry);
    void why_ui() const;
    void story_ui();
    void settings_ui();
    void look_ui();
    void draw_ghost(view::Renderer& renderer) const;
    [[nodiscard]] const std::vector<StepRecord>& records() const { return study_->recorded().records; }
    [[nodiscard]] std::size_t decisive() const;

    Stage* stage_ = nullptr;
    std::optional<StepStudy> study_;
    std::vector<int> depths_;  // of the story's lines
    std::size_t line_ = 0;     // of the story, that is looked at
    bool shows_all_ = true;
    StepLook look_;
};

void StepPanel::changed(const Inquiry& inquiry) {
    study_.reset();
    if (inquiry.saved_step != nullptr)
        study_.emplace(inquiry.saved_step->capture);
    else if (inquiry.step != nullptr)
        study_.emplace(inquiry.arena, *inquiry.step);
    if (!study_) return;
    const debugger::MadeStep& step = study_->recorded();
    depths_ = debugger::depths_of(step.records);
    line_ = decisive();
    if (step.result.events.has(CharacterEvent::invalid)) return;  // there is no body to speak of
    const Neighbour body = body_of(step, step.order.before);
    const double reach = view::reach_of(body.volume.shape);
    look_.middle = middle_of(body.volume);
    look_.up = debugger::up_of(step.order.input);
    look_.size = 0.6 * reach;
    look_.from = step.order.before.position;
    // A tick is a hundredth of a second, and its way is as short: it is drawn about as long as the body is tall.
    double longest = 0;
    for (const StepRecord& record : step.records)
        if (part_of(record.act) == StepPart::way) longest = std::max(longest, glm::length(record.motion));
    look_.stretch = longest > 0 ? std::clamp(std::floor(reach / longest), 1.0, 100.0) : 1;
}

/// The line that the first sentence is about.
std::size_t StepPanel::decisive() const {
    const StepRecord& about = study_->why().front().about;
    const auto same = [&](const StepRecord& record) { return std::memcmp(&record, &about, sizeof about) == 0; };
    const auto found = std::find_if(records().begin(), records().end(), same);
    return found == records().end() ? 0 : static_cast<std::size_t>(found - records().begin());
}

void StepPanel::draw_ghost(view::Renderer& renderer) const {
    const debugger::MadeStep& again = study_->again();
    const dvec3& place = again.result.state.position;
    if (!study_->is_edited() || again.result.events.has(CharacterEvent::invalid)) return;
    const Neighbour body = body_of(again, again.result.state);
    renderer.shape(body.volume, place, {.colour = ghost, .opacity = 0.16, .outline = 2.2, .casts_shadow = false});
    const Bounds box = debugger::bounds_of(body.volume, place);
    renderer.label({.place = {place.x, box.max.y, place.z},
                    .text = "EDITED",
                    .colour = view::mixed(ghost, paint::paper, 0.5),
                    .offset = {0, -15},
                    .behind = 0.8,
                    .yields = true});
    const dvec3 from = look_.from + look_.middle;
    if (place != look_.from)
        renderer.arrow(from, from + (place - look_.from) * look_.stretch,
                       {.colour = ghost, .width = 2.5, .behind = 0.5});
}

void StepPanel::draw(view::Renderer& renderer, const Inquiry& /*inquiry*/) {
    if (!study_) return;
    if (shows_all_) draw_story(renderer, records(), look_);
    if (line_ < records().size()) {
        const StepRecord& record = records()[line_];
        if (const auto triangle = study_->triangle_of(record))
            draw_feature(renderer, *triangle, Hit{.point = record.point, .feature = record.feature});
        draw_record(renderer, record, look_);
    }
    draw_ghost(renderer);
}

void StepPanel::about_ui(const Inquiry& inquiry) {
    const debugger::MadeStep& step = study_->recorded();
    const CharacterState& before = step.order.before;
    if (inquiry.saved_step != nullptr) {
        const debugger::SavedStep& saved = *inquiry.saved_step;
        ui::heading(std::filesystem::path(saved.file).filename().string());
        if (!saved.capture.note.empty()) ui::wrapped(saved.capture.note);
        ImGui::PushTextWrapPos(0);
        if (saved.differs.empty())
            ui::key_colour(paint::end, "Made again: the same, to the last bit.");
        else
            ui::key_colour(paint::start, debugger::verdict_text(saved));
        ImGui::PopTextWrapPos();
        ui::note(fmt::format("A tick of {:.4g} ms, {}, at {:.3g} m/s; it wishes for {:.3g} m/s{}. {}",
                             1e3 * step.order.dt, tools::footing_text(before.footing), glm::length(before.velocity),
                             glm::length(step.order.input.wish), step.order.input.jump ? ", and jump is held" : "",
                             saved.remark));
    } else {
        ui::heading("RESULT, as one step");
        ui::note(
            "A character that flies, whose wish for one second is END - START, and which has that velocity already.");
        if (inquiry.question.one_sided) ui::note("A step knows no one-sided triangles: it meets both sides.");
    }
}

void StepPanel::why_ui() const {
    for (const StepSentence& sentence : study_->why()) ui::wrapped("- " + sentence.text);
    ui::note("Events: " + tools::events_text(study_->recorded().result.events) + ".");
}

void StepPanel::story_ui() {
    if (records().empty()) {
        ui::note("Nothing was recorded.");
        return;
    }
    const std::size_t last = records().size() - 1;
    line_ = std::min(line_, last);
    if (ui::button("<##line", 30) && line_ > 0) --line_;
    ui::item("Line before");
    ImGui::SameLine();
    if (ui::button(">##line", 30) && line_ < last) ++line_;
    ui::item("Next line");
    ImGui::SameLine();
    if (ui::button("Copy this step")) {
        stage_->display.set_clipboard(capture_text(study_->capture()));
        stage_->toasts.say("The step is in the clipboard, as the file that `surefoot replay` reads.");
    }
    ui::hint("With its settings and the triangles near it: paste it here again, or into a file.");
    ui::at_right(fmt::format("{} of {}", line_ + 1, last + 1));
    double line = double(line_) + 1;
    if (last > 0 && ui::slider("Line", line, 1, double(last) + 1, "%.0f"))
        line_ = static_cast<std::size_t>(std::lround(line)) - 1;
    // The lines around the one that is looked at.
    constexpr std::size_t rows = 9;
    const std::size_t first =
        std::min(line_ > rows / 2 ? line_ - rows / 2 : 0, records().size() > rows ? records().size() - rows : 0);
    for (std::size_t i = first; i < std::min(first + rows, records().size()); ++i) {
        const StepRecord& record = records()[i];
        const std::string title = fmt::format("{:>3} {:{}}{}", i + 1, "", 4 * depths_[i], debugger::title_of(record));
        ImGui::PushStyleColor(ImGuiCol_Text, view::to_imgui(view::mixed(colour_of(record.act), paint::paper, 0.35)));
        if (ui::row(title.c_str(), i == line_)) line_ = i;
        ImGui::PopStyleColor();
    }
    ImGui::Spacing();
    const StepRecord& record = records()[line_];
    ui::wrapped(debugger::meaning_of(record));
    ImGui::PushFont(view::fonts().mono);
    ImGui::TextUnformatted(debugger::numbers_of(record).c_str());
    ImGui::PopFont();
}

void StepPanel::settings_ui() {
    const auto turn = [&](const debugger::Dial& dial) {
        double value = study_->value(dial);
        if (ui::slider(dial.label, value, dial.low, dial.high, dial.format, dial.logarithmic)) study_->set(dial, value);
        ui::hint(dial.hint);
    };
    if (!study_->is_edited())
        ui::note("Turn one: the step is made again at once.");
    else if (ui::button("As they were"))
        study_->reset();
    constexpr std::size_t usual = 6;
    for (const debugger::Dial& dial : debugger::dials().first(usual)) turn(dial);
    if (ui::section("More settings", false)) {
        for (const debugger::Dial& dial : debugger::dials().subspan(usual)) turn(dial);
        double grip = study_->grip();
        if (ui::slider("Grip", grip, 0, 2, "%.2f")) study_->set_grip(grip);
        ui::hint("Of the surface that carried it when the tick began: 1 is firm ground, 0.05 is ice.");
        bool stops = study_->response() == Response::stop;
        if (ui::checkbox("Stops at what it meets", stops))
            study_->set_response(stops ? Response::stop : Response::slide);
    }
    if (!study_->is_edited()) return;
    ui::key_colour(ghost, "With these settings:");
    ui::wrapped(study_->difference());
    for (const StepSentence& sentence : study_->why_again()) ui::wrapped("- " + sentence.text);
}

void StepPanel::look_ui() {
    ui::checkbox("All of the story", shows_all_);
    ImGui::SameLine(ImGui::GetFontSize() * 11);
    ui::checkbox("Planes", look_.planes);
    ui::slider("Stretch", look_.stretch, 1, 100, "ways drawn %.0f times as long", true);
}

void StepPanel::ui(Inquiry& inquiry) {
    if (!study_) {
        ui::note("There is no step here.");
        return;
    }
    about_ui(inquiry);
    if (ui::section("Why did it stop?")) why_ui();
    if (ui::section("Its story")) story_ui();
    if (ui::section("Other settings")) settings_ui();
    if (ui::section("Drawn", false)) look_ui();
}

}  // namespace

std::unique_ptr<Panel> make_step_panel() {
    return std::make_unique<StepPanel>();
}

}  // namespace surefoot::playground
