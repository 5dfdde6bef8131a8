#include "playground/debugger_room/room.hpp"

#include <algorithm>
#include <filesystem>
#include <glm/geometric.hpp>
#include <imgui.h>

#include "debugger/question_text.hpp"
#include "playground/debugger_room/answer_panel.hpp"
#include "playground/debugger_room/framing.hpp"
#include "playground/debugger_room/hands.hpp"
#include "playground/debugger_room/investigation.hpp"
#include "playground/debugger_room/lesson_view.hpp"
#include "playground/debugger_room/moment_bar.hpp"
#include "playground/debugger_room/panel_bar.hpp"
#include "playground/debugger_room/panels.hpp"
#include "playground/debugger_room/panels_maths.hpp"
#include "playground/debugger_room/question_panel.hpp"
#include "playground/debugger_room/room_keys.hpp"
#include "playground/debugger_room/scene.hpp"
#include "view/orbit_camera.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

using view::Key;

constexpr double run_seconds = 2.5;     // that the whole motion takes
constexpr double question_width = 300;  // [window units, for usual letters]
constexpr double margin = 14;           // around panels [window units]
constexpr double least_scene = 300;     // beside panels [window units]

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
    [[nodiscard]] std::span<const view::KeyHelp> help() const override { return room_keys; }
    [[nodiscard]] NavigationGroundPointer ground() const override { return has_lesson() ? nullptr : ground_; }

private:
    [[nodiscard]] bool has_lesson() const { return bar_.open() != nullptr && bar_.open()->has_own_scene(); }
    void open_file(const std::string& path);
    void open_dialog();
    void copy();
    void paste();
    [[nodiscard]] std::vector<dvec3> places() const;  ///< that are to be seen
    void frame();
    void show_world(bool at_once = false);
    void ease_to_middle();
    void keep_framed();
    bool key(const view::KeyPress& press);
    [[nodiscard]] Hands::Eye eye() const { return {camera(), stage_->display.size()}; }
    void show(const debugger::SavedStep& step);
    void take_ground();
    void panel_opened();
    void question_window();
    [[nodiscard]] Inquiry& inquiry();
    bool to_camera(const view::InputEvent& event, const std::optional<dvec3>& under = std::nullopt);

    Stage* stage_ = nullptr;
    std::shared_ptr<int> here_ = std::make_shared<int>(0);  // gone when the room is left: callbacks hold it weakly
    Investigation asked_;
    Inquiry inquiry_{asked_.question(), asked_.arena(), asked_.hit()};  // see `inquiry`
    std::uint64_t told_ = 0;                                            // which version the panels know
    PanelBar bar_{make_panels()};
    QuestionPanel question_panel_;
    std::optional<AnswerPanel> answer_panel_;
    Scene scene_;
    view::OrbitCamera orbit_;
    Framing framing_{orbit_};
    bool shows_more_ = false;      // the open panel, than the question
    bool folds_question_ = false;  // for want of room
    bool question_folded_ = false;
    NavigationGroundPointer ground_;  // null for a world that is no level
    std::uint64_t ground_version_ = 0;
    Hands hands_{asked_};
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
        if (kind_of_file(path) == SavedKind::step) {
            const auto step = debugger::open_step(path);
            step ? show(*step) : stage_->toasts.warn(step.error().text);
            return;
        }
        const auto moment = open_moment(path);
        if (!moment) {
            stage_->toasts.warn(moment.error().text);
            return;
        }
        asked_.show(*moment);
        hands_.deselect();
        frame();
        stage_->toasts.say(verdict_text(*moment));
        return;
    }
    stage_->open_level(path, [this, here = std::weak_ptr(here_)](const LevelLoader::Loaded& level) {
        if (here.expired()) return;
        asked_.show(level);
        hands_.deselect();
        frame();
    });
}

/// A saved step, and what is to be told of it.
void Debugger::show(const debugger::SavedStep& step) {
    asked_.show(step);
    inquiry_.t = 1;
    hands_.deselect();
    bar_.show(step_panel_name, inquiry());
    panel_opened();
    framing_.look_along(step.capture.input.wish);
    frame();
    stage_->toasts.say(debugger::verdict_text(step));
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
    const std::string text = stage_->display.clipboard();
    if (saved_kind(text) == SavedKind::step) {
        const auto step = debugger::step_from_text(text, "clipboard");
        step ? show(*step) : stage_->toasts.warn(step.error().text);
        return;
    }
    const auto pasted = debugger::from_line(text, asked_.question());
    if (!pasted) {
        stage_->toasts.warn(pasted.error());
        return;
    }
    asked_.apply(debugger::Replace{*pasted});
    ease_to_middle();
}

std::vector<dvec3> Debugger::places() const {
    std::vector<dvec3> all = has_lesson() ? std::vector<dvec3>() : places_of(asked_);
    const std::vector<dvec3> more = bar_.open() != nullptr ? bar_.open()->scene_places() : std::vector<dvec3>();
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// What panels look at, as it is now.
Inquiry& Debugger::inquiry() {
    inquiry_.is_dragged = asked_.history().is_dragged();
    inquiry_.step = &asked_.step();
    inquiry_.saved_step = asked_.saved_step() ? &*asked_.saved_step() : nullptr;
    return inquiry_;
}

void Debugger::frame() {
    framing_.show(places(), stage_->display.size());
}

/// Shows a world from the side that its question is about.
void Debugger::show_world(bool at_once) {
    auto stand = orbit_.goal();
    const bool faces_away =
        asked_.question().world == debugger::WorldKind::fold || asked_.question().world == debugger::WorldKind::wedge;
    stand.yaw = faces_away ? 2.2 : 0.62;
    stand.pitch = 0.34;
    orbit_.go_to(stand);
    frame();
    if (at_once) orbit_.arrive();
}

void Debugger::ease_to_middle() {
    auto stand = orbit_.goal();
    stand.pivot = asked_.place_at(0.5);
    orbit_.go_to(stand);
    if (!framing_.kept().empty()) framing_.keep(places());  // which are others by now
}

bool Debugger::key(const view::KeyPress& press) {
    if (!press.down) return false;
    if (press.held.control) {
        switch (press.key) {
            case Key::z:
                hands_.let_go();
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
            frame();
            return true;
        case Key::h:
            panels_hidden_ = !panels_hidden_;
            return true;
        case Key::space:
            Clock{inquiry_.t, runs_}.toggle();
            return true;
        case Key::escape:
            // What is open closes first; then the house goes back to the start.
            if (bar_.open() != nullptr) {
                bar_.close();
                panel_opened();
                return true;
            }
            return hands_.deselect();
        default:
            return false;
    }
}

bool Debugger::event(const view::InputEvent& event) {
    if (const auto* const drop = std::get_if<view::FileDrop>(&event); drop != nullptr && !drop->files.empty()) {
        open_file(drop->files.front());
        return true;
    }
    if (const auto* const press = std::get_if<view::KeyPress>(&event)) return key(*press);
    const view::ivec2 size = stage_->display.size();
    if (has_lesson()) return to_camera(event);
    if (const auto* const press = std::get_if<view::ButtonPress>(&event)) {
        const Grasp grasp = hands_.button(*press, eye());
        if (grasp == Grasp::dropped) ease_to_middle();
        if (grasp != Grasp::nothing) return true;
    }
    std::optional<dvec3> under;
    if (const auto* const move = std::get_if<view::PointerMove>(&event)) {
        if (orbit_.is_dragged() && !hands_.hold()) {
            hands_.look_away();
        } else if (hands_.move(*move, eye(), question_panel_.grid)) {
            return true;
        }
    }
    if (const auto* const focus = std::get_if<view::FocusChange>(&event); focus != nullptr && !focus->focused)
        hands_.let_go();
    if (const auto* const wheel = std::get_if<view::WheelTurn>(&event); wheel != nullptr && asked_.mesh())
        if (const auto hit = view::pick(*asked_.mesh(), camera(), wheel->at, size); hit && hit->status == HitStatus::ok)
            under = hit->point;
    return to_camera(event, under);
}

bool Debugger::to_camera(const view::InputEvent& event, const std::optional<dvec3>& under) {
    const view::OrbitCamera::Stand before = orbit_.goal();
    const bool used = orbit_.event(event, stage_->display.size(), under);
    if (!(orbit_.goal() == before)) framing_.keep({});
    return used;
}

bool Debugger::update(double dt) {
    hands_.follow();
    if (told_ != asked_.version()) {
        told_ = asked_.version();
        take_ground();
        hands_.look_away();
        bar_.changed(inquiry());
    }
    if (runs_) {
        inquiry_.t = std::min(inquiry_.t + dt / run_seconds, 1.0);
        runs_ = inquiry_.t < 1;
    }
    const bool moves = bar_.open() != nullptr && bar_.open()->update(dt, inquiry());
    keep_framed();
    return orbit_.update(dt) || moves || runs_;
}

/// A level is walked on by a character as it is by default; its way begins below START.
void Debugger::take_ground() {
    const bool is_level = asked_.mesh() && asked_.question().world == debugger::WorldKind::level;
    if (!is_level) ground_.reset();
    if (!is_level || (ground_ && ground_version_ == asked_.world_version())) return;
    auto ground = std::make_shared<NavigationGround>();
    ground->pieces.push_back({*asked_.mesh()});
    ground->start = asked_.question().motion.from;
    ground_version_ = asked_.world_version();
    ground_ = std::move(ground);
}

/// Until a hand moves the camera: in what the panels leave free, and all of what the open one shows, which may be
/// another course of its lesson, or no squashed world any more.
void Debugger::keep_framed() {
    framing_.update(stage_->display.size());
    const std::vector<dvec3> more = bar_.open() != nullptr ? bar_.open()->scene_places() : std::vector<dvec3>();
    const bool changed = has_lesson() ? framing_.kept() != more : more.empty() == shows_more_;
    shows_more_ = !more.empty();
    if (changed && !framing_.kept().empty()) frame();
}

void Debugger::draw(view::Renderer& renderer) {
    if (!has_lesson()) {
        scene_.draw(renderer, asked_, inquiry_.t);
        if (!panels_hidden_) scene_.draw_grips(renderer, asked_.question(), hands_.selected(), hands_.hovered());
    }
    if (bar_.open() != nullptr) bar_.open()->draw(renderer, inquiry_);
}

bool Debugger::hides(const dvec3& place) const {
    if (has_lesson() || !asked_.mesh()) return false;
    const dvec3 eye = camera().eye;
    return asked_.mesh()->ray_any({eye, eye + (place - eye) * 0.995});
}

/// Another panel is open than before: one with more to show than the question is looked at from where that is seen,
/// and the question from where it was.
void Debugger::panel_opened() {
    const bool shows_more = has_lesson() || (bar_.open() != nullptr && !bar_.open()->scene_places().empty());
    if (!shows_more) return framing_.come_back();
    hands_.let_go();
    auto stand = framing_.depart();
    if (has_lesson()) {
        stand.yaw = lesson_yaw;
        stand.pitch = lesson_pitch;
    }
    orbit_.go_to(stand);
    frame();
}

void Debugger::question_window() {
    namespace ui = view::ui;
    // Where the window is narrow, a panel and the question would cover all there is to see.
    const double letters = ImGui::GetFontSize() / 15.5;
    const bool narrow = stage_->display.size().x - question_width * letters - bar_.width() < least_scene;
    if (const bool folds = narrow && bar_.open() != nullptr; folds != folds_question_) {
        folds_question_ = folds;
        ImGui::SetNextWindowCollapsed(folds);
    }
    question_folded_ = !ui::begin("Question", {.width = question_width});
    if (!question_folded_) {
        const auto wishes = question_panel_.ui(asked_);
        if (wishes.open) open_dialog();
        if (wishes.copy) copy();
        if (wishes.paste) paste();
        if (wishes.framed) {
            hands_.deselect();
            show_world();
        }
        ImGui::Separator();
        if (ui::section("Answer")) answer_panel_->ui(asked_, stage_->display, stage_->toasts);
        look_ui(scene_.look);
        if (ground_) stage_->navigation.ui();
    }
    ui::end();
}

void Debugger::ui() {
    namespace ui = view::ui;
    if (panels_hidden_) return;
    if (!has_lesson()) question_window();
    if (has_lesson()) {
        if (bar_.ui(inquiry(), 0)) panel_opened();
        return;
    }
    // The bar of the moment lies beside an open panel where it has room there, else beneath.
    const double across = stage_->display.size().x;
    const double left = margin + (question_folded_ ? 0 : question_width * ImGui::GetFontSize() / 15.5 + margin);
    const double beside = across - bar_.width() - 2 * margin;
    const bool is_beside = bar_.open() != nullptr && beside - left >= least_scene;
    const double beneath = ImGui::GetFrameHeightWithSpacing() + ImGui::GetTextLineHeightWithSpacing() +
                           2 * ImGui::GetStyle().WindowPadding.y + margin;
    if (bar_.ui(inquiry(), is_beside ? 0 : beneath)) panel_opened();
    moment_bar(asked_, {inquiry_.t, runs_}, left, is_beside ? beside : across - margin);
}

}  // namespace

std::unique_ptr<Room> make_debugger() {
    return std::make_unique<Debugger>();
}

}  // namespace surefoot::playground
