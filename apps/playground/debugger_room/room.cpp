#include "playground/debugger_room/room.hpp"

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>
#include <imgui.h>

#include "debugger/question_text.hpp"
#include "playground/debugger_room/answer_panel.hpp"
#include "playground/debugger_room/investigation.hpp"
#include "playground/debugger_room/panel_bar.hpp"
#include "playground/debugger_room/panels.hpp"
#include "playground/debugger_room/question_panel.hpp"
#include "playground/debugger_room/scene.hpp"
#include "view/orbit_camera.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

using view::dvec2;
using view::Key;

constexpr view::KeyHelp keys[] = {{"Drag START or END", "moves it in the plane that faces you"},
                                  {"Drag a corner", "moves it, and all corners that are at its place"},
                                  {"Click one of them", "shows arrows, each along an axis, and handles on its box"},
                                  {"Drag a handle", "moves in the plane of that face of the box"},
                                  {"Shift", "snaps to the grid while dragging"},
                                  {"Drag elsewhere", "turns the camera; right drag moves it, the wheel zooms"},
                                  {"F", "shows all of it"},
                                  {"Control+Z", "undo; with Shift redo"},
                                  {"Control+C  Control+V", "copy and paste of the question as JSON"},
                                  {"Control+S", "saves this moment"},
                                  {"Control+O", "opens a level or a saved moment"},
                                  {"Space", "lets the motion run"},
                                  {"H", "hides the panels"}};

constexpr double run_seconds = 2.5;  // that the whole motion takes

class Debugger final : public Room {
public:
    void enter(Stage& stage) override;
    void leave() override { here_.reset(); }
    bool event(const view::InputEvent& event) override;
    bool update(double dt) override;
    [[nodiscard]] view::Camera camera() const override { return orbit_.camera(); }
    void draw(view::Renderer& renderer) override;
    void ui() override;
    [[nodiscard]] bool hides(const dvec3& place) const override;
    [[nodiscard]] std::span<const view::KeyHelp> help() const override { return keys; }

private:
    [[nodiscard]] bool has_lesson() const { return bar_.open() != nullptr && bar_.open()->has_own_scene(); }
    void open_file(const std::string& path);
    void open_dialog();
    void copy();
    void paste();
    void frame();
    void show_world(bool at_once = false);
    void ease_to_middle();
    bool key(const view::KeyPress& press);
    bool button(const view::ButtonPress& press);
    void drag_to(const dvec2& at, bool snaps);
    void panel_opened();
    void moment_bar();
    void question_window();

    Stage* stage_ = nullptr;
    std::shared_ptr<int> here_ = std::make_shared<int>(0);  // gone when the room is left: callbacks hold it weakly
    Investigation asked_;
    Inquiry inquiry_{asked_.question(), asked_.arena(), asked_.hit()};
    std::uint64_t told_ = 0;  // which version the panels know
    PanelBar bar_{make_panels()};
    QuestionPanel question_panel_;
    std::optional<AnswerPanel> answer_panel_;
    Scene scene_;
    view::OrbitCamera orbit_;
    std::optional<view::OrbitCamera::Stand> before_lesson_;
    std::optional<Target> selected_;
    std::optional<Grip> hovered_;
    std::optional<Drag> drag_;
    std::optional<dvec2> pressed_at_;  // a press on nothing, which may become a click
    bool runs_ = false;
    bool panels_hidden_ = false;
};

void Debugger::enter(Stage& stage) {
    stage_ = &stage;
    const std::string settings = view::settings_path();
    answer_panel_.emplace(stage.headless || settings.empty()
                              ? std::string()
                              : (std::filesystem::path(settings).parent_path() / "moments").string());
    bar_.enter(stage);
    show_world(true);
    if (!stage.level.empty()) open_file(stage.level);
}

void Debugger::open_file(const std::string& path) {
    if (path.ends_with(".json")) {
        const auto moment = open_moment(path);
        if (!moment) {
            stage_->toasts.warn(moment.error().text);
            return;
        }
        asked_.show(*moment);
        selected_.reset();
        frame();
        stage_->toasts.say(verdict_text(*moment));
        return;
    }
    stage_->open_level(path, [this, here = std::weak_ptr(here_)](const LevelLoader::Loaded& level) {
        if (here.expired()) return;
        asked_.show(level);
        selected_.reset();
        frame();
    });
}

void Debugger::open_dialog() {
    stage_->browser.open(
        "Open a level or a saved moment",
        {".json", ".surefoot", ".obj", ".gltf", ".glb", ".ply", ".stl", ".ac", ".blend", ".bsp", ".pk3"},
        [this, here = std::weak_ptr(here_)](const std::string& path) {
            if (!here.expired()) open_file(path);
        });
}

void Debugger::copy() {
    const debugger::Question& question = asked_.question();
    stage_->display.set_clipboard(debugger::to_line(question));
    stage_->toasts.say(
        question.triangles.size() > debugger::most_triangles
            ? "The question is in the clipboard; with so many triangles only a saved moment is read back."
            : "The question is in the clipboard.");
}

void Debugger::paste() {
    const auto pasted = debugger::from_line(stage_->display.clipboard(), asked_.question());
    if (!pasted) {
        stage_->toasts.warn(pasted.error());
        return;
    }
    asked_.apply(debugger::Replace{*pasted});
    ease_to_middle();
}

void Debugger::frame() {
    orbit_.frame(extent_of(asked_));
    auto stand = orbit_.goal();
    // The ball around the corners of a box is wider than what is in it. In a level the motion's own ends are those
    // corners.
    stand.distance *= asked_.level() ? 1.2 : 0.88;
    orbit_.go_to(stand);
}

/// Shows a world from the side that its question is about.
void Debugger::show_world(bool at_once) {
    frame();
    auto stand = orbit_.goal();
    const bool faces_away =
        asked_.question().world == debugger::WorldKind::fold || asked_.question().world == debugger::WorldKind::wedge;
    stand.yaw = faces_away ? 2.2 : 0.62;
    stand.pitch = 0.34;
    orbit_.go_to(stand);
    if (at_once) orbit_.jump_to(stand);
}

void Debugger::ease_to_middle() {
    auto stand = orbit_.goal();
    stand.pivot = asked_.place_at(0.5);
    orbit_.go_to(stand);
}

bool Debugger::key(const view::KeyPress& press) {
    if (!press.down) return false;
    if (press.held.control) {
        switch (press.key) {
            case Key::z:
                drag_.reset();
                press.held.shift ? asked_.redo() : asked_.undo();
                return true;
            case Key::c:
                copy();
                return true;
            case Key::v:
                paste();
                return true;
            case Key::s:
                answer_panel_->save(asked_, stage_->toasts);
                return true;
            case Key::o:
                open_dialog();
                return true;
            default:
                return false;
        }
    }
    if (press.repeat) return false;
    switch (press.key) {
        case Key::f:
            has_lesson() ? panel_opened() : frame();
            return true;
        case Key::h:
            panels_hidden_ = !panels_hidden_;
            return true;
        case Key::space:
            runs_ = !runs_;
            if (runs_ && inquiry_.t >= 1) inquiry_.t = 0;
            return true;
        case Key::escape:
            // What is open closes first; then the house goes back to the start.
            if (bar_.open() != nullptr) {
                bar_.close();
                panel_opened();
                return true;
            }
            if (!selected_) return false;
            selected_.reset();
            return true;
        default:
            return false;
    }
}

bool Debugger::button(const view::ButtonPress& press) {
    if (press.button != view::MouseButton::left) return false;
    const view::ivec2 size = stage_->display.size();
    if (press.down) {
        const auto grips = grips_of(asked_.question(), selected_, camera(), size);
        const auto grabbed = grab(grips, camera(), press.at, size);
        if (!grabbed) {
            pressed_at_ = press.at;
            return false;
        }
        selected_ = grabbed->grip.target;
        hovered_ = grabbed->grip;
        drag_.emplace(*grabbed, asked_.question());
        asked_.begin_drag();
        return true;
    }
    if (drag_) {
        drag_.reset();
        asked_.end_drag();
        ease_to_middle();
        return true;
    }
    // What hardly moved between press and release was a click: on nothing, it lets go of what is selected.
    constexpr double hardly = 4;
    if (pressed_at_ && glm::length(press.at - *pressed_at_) <= hardly) selected_.reset();
    pressed_at_.reset();
    return false;
}

void Debugger::drag_to(const dvec2& at, bool snaps) {
    const auto place = drag_->to(camera(), at, stage_->display.size(), snaps ? question_panel_.grid : 0);
    if (place) asked_.apply(moved_to(drag_->grip().target, *place));
}

bool Debugger::event(const view::InputEvent& event) {
    if (const auto* const drop = std::get_if<view::FileDrop>(&event); drop != nullptr && !drop->files.empty()) {
        open_file(drop->files.front());
        return true;
    }
    if (const auto* const press = std::get_if<view::KeyPress>(&event)) return key(*press);
    const view::ivec2 size = stage_->display.size();
    if (has_lesson()) return orbit_.event(event, size);
    if (const auto* const press = std::get_if<view::ButtonPress>(&event); press != nullptr && button(*press))
        return true;
    std::optional<dvec3> under;
    if (const auto* const move = std::get_if<view::PointerMove>(&event)) {
        if (drag_) {
            drag_to(move->at, move->held.shift);
            return true;
        }
        const auto grabbed = orbit_.is_dragged() ? std::nullopt
                                                 : grab(grips_of(asked_.question(), selected_, camera(), size),
                                                        camera(), move->at, size);
        hovered_ = grabbed ? std::optional(grabbed->grip) : std::nullopt;
    }
    if (const auto* const focus = std::get_if<view::FocusChange>(&event);
        focus != nullptr && !focus->focused && drag_) {
        drag_.reset();
        asked_.end_drag();
    }
    if (const auto* const wheel = std::get_if<view::WheelTurn>(&event); wheel != nullptr && asked_.mesh())
        if (const auto hit = view::pick(*asked_.mesh(), camera(), wheel->at, size); hit && hit->status == HitStatus::ok)
            under = hit->point;
    return orbit_.event(event, size, under);
}

bool Debugger::update(double dt) {
    if (selected_ && selected_->kind == Target::Kind::corner &&
        selected_->triangle >= asked_.question().triangles.size())
        selected_.reset();
    inquiry_.is_dragged = asked_.history().is_dragged();
    if (told_ != asked_.version()) {
        told_ = asked_.version();
        hovered_.reset();
        bar_.changed(inquiry_);
    }
    if (runs_) {
        inquiry_.t = std::min(inquiry_.t + dt / run_seconds, 1.0);
        runs_ = inquiry_.t < 1;
    }
    const bool moves = bar_.open() != nullptr && bar_.open()->update(dt, inquiry_);
    return orbit_.update(dt) || moves || runs_;
}

void Debugger::draw(view::Renderer& renderer) {
    if (!has_lesson()) {
        scene_.draw(renderer, asked_, inquiry_.t);
        if (!panels_hidden_) scene_.draw_grips(renderer, asked_.question(), selected_, hovered_);
    }
    if (bar_.open() != nullptr) bar_.open()->draw(renderer, inquiry_);
}

bool Debugger::hides(const dvec3& place) const {
    if (has_lesson() || !asked_.mesh()) return false;
    const dvec3 eye = camera().eye;
    return asked_.mesh()->ray_any({eye, eye + (place - eye) * 0.995});
}

/// Another panel is open than before: one with more to show than the question is looked at from where it wants to be,
/// and the question from where it was.
void Debugger::panel_opened() {
    const Panel* const panel = bar_.open();
    const auto seen = panel != nullptr ? panel->scene_frame() : std::nullopt;
    if (seen || has_lesson()) {
        if (!before_lesson_) before_lesson_ = orbit_.goal();
        drag_.reset();
        if (seen) {
            // Of the cube in a ball of that radius; beside the question's own panel there is room for half of that.
            const dvec3 half(seen->second * (has_lesson() ? 0.577 : 0.3));
            orbit_.frame({seen->first - half, seen->first + half});
        }
    } else if (before_lesson_) {
        orbit_.go_to(*before_lesson_);
        before_lesson_.reset();
    }
}

void Debugger::moment_bar() {
    namespace ui = view::ui;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float unit = ImGui::GetFontSize() / 15.5F;
    const float left = 300 * unit + 28;
    ImGui::SetNextWindowPos({left, screen.y - 14}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowSize({std::max(screen.x - left - 14, 120.0F), 0}, ImGuiCond_Always);
    if (ImGui::Begin("##moment", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                         ImGuiWindowFlags_NoFocusOnAppearing)) {
        ui::key_colour(asked_.hit() ? view::paint::hit : view::paint::end, answer_in_a_line(asked_));
        if (ui::button(runs_ ? "Stop##run" : "Run##run")) {
            runs_ = !runs_;
            if (runs_ && inquiry_.t >= 1) inquiry_.t = 0;
        }
        ui::hint("Lets the motion run from START to END (Space).");
        ImGui::SameLine();
        ImGui::BeginDisabled(!asked_.hit());
        if (ui::button("To HIT")) inquiry_.t = asked_.hit() ? asked_.hit()->t : 1;
        ImGui::EndDisabled();
        ImGui::SameLine();
        ImGui::SetNextItemWidth(-1);
        const double low = 0;
        const double high = 1;
        if (ImGui::SliderScalar("##t", ImGuiDataType_Double, &inquiry_.t, &low, &high, "t = %.4f",
                                ImGuiSliderFlags_AlwaysClamp | ImGuiSliderFlags_NoRoundToFormat))
            runs_ = false;
        ui::item("Moment t");
    }
    ImGui::End();
}

void Debugger::question_window() {
    namespace ui = view::ui;
    if (ui::begin("Question", {.width = 300})) {
        const auto wishes = question_panel_.ui(asked_);
        if (wishes.open) open_dialog();
        if (wishes.copy) copy();
        if (wishes.paste) paste();
        if (wishes.framed) {
            selected_.reset();
            show_world();
        }
        ImGui::Separator();
        if (ui::section("Answer")) answer_panel_->ui(asked_, stage_->display, stage_->toasts);
        look_ui(scene_.look);
    }
    ui::end();
}

void Debugger::ui() {
    namespace ui = view::ui;
    if (panels_hidden_) return;
    if (!has_lesson()) question_window();
    const double bar_height = ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing() +
                              2 * ImGui::GetStyle().WindowPadding.y + 14;
    if (bar_.ui(inquiry_, bar_height)) panel_opened();
    if (!has_lesson()) moment_bar();
}

}  // namespace

std::unique_ptr<Room> make_debugger() {
    return std::make_unique<Debugger>();
}

}  // namespace surefoot::playground
