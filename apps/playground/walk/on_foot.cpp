#include "playground/walk/on_foot.hpp"

#include <array>
#include <filesystem>
#include <glm/geometric.hpp>
#include <imgui.h>

#include "playground/walk/settings_panel.hpp"
#include "playground/walk/settings_table.hpp"
#include "playground/walk/time_bar.hpp"
#include "surface_words.hpp"
#include "view/shapes.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

using view::Key;

constexpr view::KeyHelp keys[] = {{"W A S D, Shift", "walk, run; the left stick, and RB"},
                                  {"Space", "jumps, climbs up an edge that it holds; A"},
                                  {"Control, Q", "crouches, lets go of an edge; dashes; B and X"},
                                  {"Drag, Tab", "looks around; Tab keeps the pointer for that; the right stick"},
                                  {"P", "time stands and goes on; Start"},
                                  {"Comma, full stop", "one step back, one step on"},
                                  {"M", "saves the last step"},
                                  {"R", "back to the station"},
                                  {"H", "hides the panels"},
                                  {"G, C", "on foot or not; flies"},
                                  {"F", "leaves the body, and shows the whole level"},
                                  {"1  2  3", "what a click does: look, measure, throw"}};

std::string moments_folder(const Stage& stage) {
    const std::string settings = view::settings_path();
    if (stage.headless || settings.empty()) return {};
    return (std::filesystem::path(settings).parent_path() / "moments").string();
}

view::Colour body_colour(const CharacterState& state) {
    switch (state.footing) {
        case Footing::air:
            return view::paint::result;
        case Footing::steep:
            return view::paint::start;
        case Footing::ledge:
            return view::paint::vertex;
        case Footing::ground:
            break;
    }
    return view::paint::hit;
}

}  // namespace

OnFoot::OnFoot(Stage& stage, LevelLoader::Loaded level)
    : stage_(stage),
      level_(std::move(level)),
      walker_(level_->level.mesh),
      keeping_(moments_folder(stage)),
      stations_(stations_of(level_->level)) {
    walker_.change(room_settings());
    walker_.change(tools::surface_rules(level_->level.surface_names));
    has_place_ = go_to(0) && walker_.state().footing == Footing::ground;
}

std::span<const view::KeyHelp> OnFoot::help() {
    return keys;
}

bool OnFoot::go_to(std::size_t station) {
    station_ = station;
    const Station& there = stations_[station];
    if (!walker_.put(there.place)) return false;
    walker_.paused = false;
    camera_.jump_to(walker_.state().position, yaw_towards(there.look));
    still_for_ = 0;
    return true;
}

void OnFoot::release() {
    controls_.release();
    capture(false);
}

void OnFoot::capture(bool captured) {
    if (stage_.display.is_pointer_captured() != captured) stage_.display.capture_pointer(captured);
}

void OnFoot::one_step() {
    walker_.paused = true;
    walker_.make_tick(controls_.take(camera_.ahead()));
}

bool OnFoot::key(const view::KeyPress& press) {
    if (!press.down) return false;
    // What may be held down, to go on and on.
    if (press.key == Key::comma) {
        step_back(walker_);
        return true;
    }
    if (press.key == Key::period) {
        one_step();
        return true;
    }
    if (press.repeat) return false;
    switch (press.key) {
        case Key::p:
            toggle_pause(walker_);
            return true;
        case Key::m:
            keeping_.save_moment(walker_, stage_.toasts);
            return true;
        case Key::r:
            go_to(station_);
            return true;
        case Key::h:
            shows_panels_ = !shows_panels_;
            return true;
        case Key::tab:
            capture(!stage_.display.is_pointer_captured());
            return true;
        case Key::escape:
            if (!stage_.display.is_pointer_captured()) return false;
            capture(false);
            return true;
        default:
            return false;
    }
}

bool OnFoot::pad(const view::GamepadButton& press) {
    if (!press.down || press.button != view::PadButton::start) return false;
    toggle_pause(walker_);
    return true;
}

bool OnFoot::event(const view::InputEvent& event) {
    still_for_ = 0;
    if (const auto* const press = std::get_if<view::KeyPress>(&event); press != nullptr && key(*press)) return true;
    if (const auto* const press = std::get_if<view::GamepadButton>(&event); press != nullptr && pad(*press))
        return true;
    if (const auto* const focus = std::get_if<view::FocusChange>(&event); focus != nullptr && !focus->focused)
        capture(false);
    if (controls_.event(event)) return true;
    return camera_.event(event, stage_.display.is_pointer_captured());
}

bool OnFoot::update(double dt) {
    constexpr double turn_speed = 2.6;  // of a stick that is all the way to one side [rad/s]
    camera_.turn(controls_.look() * (turn_speed * dt));
    camera_.keep_in(view::ui::uncovered(stage_.display.size()), stage_.display.size(), dt);
    const CharacterState before = walker_.state();
    const bool passes = walker_.pass(dt, [&] { return controls_.take(camera_.ahead()); });
    const bool turns =
        camera_.update(dt, walker_.world(), walker_.state().position) || controls_.look() != view::dvec2(0);
    // What stands still for a while need not be drawn again and again.
    const bool moves = passes && before.position != walker_.state().position;
    still_for_ = moves || turns ? 0 : still_for_ + dt;
    constexpr double patience = 0.5;  // [s]
    return still_for_ < patience;
}

view::Camera OnFoot::camera() const {
    return camera_.camera(walker_.world(), place());
}

void OnFoot::draw(view::Renderer& renderer) {
    const dvec3 position = place();
    const CharacterState& state = walker_.state();
    const Volume& body = body_of(walker_.settings(), state.form);
    const double opacity = camera_.is_inside() ? 0.12 : overlay_.looks_inside() ? 0.42 : 0.9;
    renderer.shape(body, position, {.colour = body_colour(state), .opacity = opacity, .outline = 2});
    overlay_.draw(renderer, walker_, position);
}

void OnFoot::body_section() {
    namespace ui = view::ui;
    CharacterSettings settings = walker_.settings();
    int kind = static_cast<int>(settings.volume.shape.index());
    if (ui::choice("Body", kind, shape_names())) {
        settings.volume.shape = as_large(settings.volume.shape, static_cast<std::size_t>(kind));
        if (settings.crouched)
            settings.crouched->shape = as_large(settings.crouched->shape, static_cast<std::size_t>(kind));
        walker_.change(settings);
    }
    ui::hint("Any of the six; the feet stay where they are. Sizes and everything else are below.");
    int mode = static_cast<int>(controls_.mode);
    constexpr std::array<const char*, 3> modes{"Walks", "Swims", "Flies"};
    if (ui::choice("Mode", mode, modes)) controls_.mode = static_cast<CharacterMode>(mode);
    ui::hint("Swimming and flying, Space goes up and Control down.");
    ui::slider("Walking speed", controls_.walk_speed, 0, 20, "%.1f m/s");
    ui::slider("Running speed", controls_.run_speed, 0, 60, "%.1f m/s");
}

void OnFoot::panel() {
    namespace ui = view::ui;
    if (stations_.size() > 1) {
        ImGui::SetNextItemWidth(-1);
        const bool open = ImGui::BeginCombo("##station", stations_[station_].name.c_str(), ImGuiComboFlags_HeightLarge);
        ui::item("Station");
        if (open) {
            for (std::size_t i = 0; i < stations_.size(); ++i) {
                if (ui::row(stations_[i].name.c_str(), i == station_) && !go_to(i))
                    stage_.toasts.warn("There is no room for this body.");
                ui::hint(stations_[i].try_this);
            }
            ImGui::EndCombo();
        }
    }
    ui::note(stations_[station_].try_this);
    body_section();
    if (ui::section("Show")) overlay_.ui();
    if (ui::section("Keep", false)) keeping_.ui(walker_, level_->level.file, stage_.toasts);
    ImGui::Separator();
    ui::heading("All settings");
    settings_panel(walker_, level_->level, stage_.display, stage_.toasts);
}

void OnFoot::bar(double left, double right) {
    time_bar(walker_, overlay_.why, left, right, [this] { one_step(); });
}

}  // namespace surefoot::playground
