#include "playground/walk/walk.hpp"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <imgui.h>
#include <optional>

#include "playground/walk/fetcher.hpp"
#include "playground/walk/findings.hpp"
#include "playground/walk/level_look.hpp"
#include "playground/walk/on_foot.hpp"
#include "playground/walk/settings_panel.hpp"
#include "playground/walk/tape.hpp"
#include "playground/walk/thrower.hpp"
#include "surface_words.hpp"
#include "view/fly_camera.hpp"
#include "view/orbit_camera.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

using view::dvec2;
using view::Key;

constexpr view::KeyHelp camera_keys[] = {
    {"Drag", "turns around the place in the middle; when flying, looks around"},
    {"Wheel", "goes towards what is under the pointer; when flying, sets the speed"},
    {"Right drag", "moves sideways"},
    {"W A S D, Q E", "fly; Shift hurries"},
    {"G", "on foot: a character walks through the level"},
    {"C", "orbit or fly"},
    {"F", "shows the whole level"},
    {"1  2  3", "look, measure, throw"},
    {"T  K  I", "the tree; edges by kind; triangle ids"},
    {"N", "the next odd spot"},
    {"Control+O", "opens a level"}};

enum class Tool { look, measure, hurl };

/// From where the level is seen.
enum class Seat { orbit, fly, foot };

class Walk final : public Room {
public:
    void enter(Stage& stage) override {
        stage_ = &stage;
        thrower_.timed = !stage.headless;
        std::string level = stage.level;
        std::error_code error;
        if (level.empty() && !stage.settings.recent.empty() &&
            std::filesystem::exists(level_path(stage.settings.recent.front()).file, error))
            level = stage.settings.recent.front();
        if (level.empty()) level = find_in_project("levels/training-ground.glb");
        if (!level.empty()) open(level);
    }

    void leave() override {
        if (on_foot_) on_foot_->release();
    }

    bool event(const view::InputEvent& event) override;
    bool update(double dt) override;
    [[nodiscard]] view::Camera camera() const override {
        return seat_ == Seat::foot ? on_foot_->camera() : seat_ == Seat::fly ? fly_.camera() : orbit_.camera();
    }
    void draw(view::Renderer& renderer) override;
    void ui() override;

    [[nodiscard]] bool hides(const dvec3& place) const override {
        if (!level_) return false;
        const dvec3 eye = camera().eye;
        return mesh().ray_any({eye, eye + (place - eye) * 0.995});
    }
    [[nodiscard]] NavigationGroundPointer ground() const override { return ground_; }
    [[nodiscard]] std::span<const view::KeyHelp> help() const override {
        return seat_ == Seat::foot ? OnFoot::help() : camera_keys;
    }

private:
    [[nodiscard]] const Mesh& mesh() const { return level_->level.mesh; }
    void open(const std::string& path) {
        stage_->level = path;
        stage_->open_level(path, [this](const LevelLoader::Loaded& loaded) { show(loaded); });
    }
    void show(const LevelLoader::Loaded& loaded);
    void take_ground();
    void click(const dvec2& at);
    bool key(const view::KeyPress& press);
    void sit(Seat seat);
    void go_to_place(const dvec3& place);
    [[nodiscard]] std::optional<dvec3> place_under(const dvec2& at) const;
    void level_panel();
    void tool_panel();
    void tools();
    void seat_row();

    Stage* stage_ = nullptr;
    LevelLoader::Loaded level_;
    std::optional<LevelLook> look_;
    std::optional<Findings> findings_;
    Tape tape_;
    Thrower thrower_;
    Fetcher fetcher_;
    view::OrbitCamera orbit_;
    view::FlyCamera fly_;
    std::unique_ptr<OnFoot> on_foot_;  // null for a level where nobody can stand
    NavigationGroundPointer ground_;
    std::uint64_t changes_ = 0;  // of settings, that the ground knows
    Seat seat_ = Seat::orbit;
    Tool tool_ = Tool::look;
    std::optional<dvec2> pressed_at_;  // a left press that may become a click
    std::optional<std::uint32_t> picked_;
};

void Walk::show(const LevelLoader::Loaded& loaded) {
    level_ = loaded;
    look_.emplace(level_);
    findings_.emplace(level_->report);
    tape_.clear();
    thrower_.clear();
    picked_.reset();
    // Near enough to see what it is like, from above a corner.
    const Bounds bounds = mesh().bounds();
    const double size = glm::length(bounds.max - bounds.min);
    orbit_.jump_to({.pivot = (bounds.min + bounds.max) * 0.5 - dvec3(0, 0.08, 0) * size,
                    .yaw = 0.75,
                    .pitch = 0.52,
                    .distance = size * 0.62});
    if (on_foot_) on_foot_->release();
    on_foot_ = std::make_unique<OnFoot>(*stage_, level_);
    if (!on_foot_->has_place()) on_foot_.reset();
    seat_ = on_foot_ ? Seat::foot : Seat::orbit;
    take_ground();
}

/// Who walks on it is the character, or one that cannot find a place.
void Walk::take_ground() {
    auto ground = std::make_shared<NavigationGround>();
    ground->pieces.push_back({mesh()});
    ground->settings = on_foot_ ? on_foot_->walker().settings() : room_settings();
    ground->rules = on_foot_ ? on_foot_->walker().surfaces() : tools::surface_rules(level_->level.surface_names);
    ground->start = on_foot_ ? on_foot_->start() : (mesh().bounds().min + mesh().bounds().max) * 0.5;
    changes_ = on_foot_ ? on_foot_->walker().changes() : 0;
    ground_ = std::move(ground);
}

bool Walk::key(const view::KeyPress& press) {
    if (!press.down || press.repeat) return false;
    if (press.held.control && press.key == Key::o) {
        stage_->browse_for_level([this](const LevelLoader::Loaded& loaded) { show(loaded); });
        return true;
    }
    if (press.held.control || !level_) return false;
    switch (press.key) {
        case Key::g:
            sit(seat_ == Seat::foot ? Seat::orbit : Seat::foot);
            return true;
        case Key::c:
            sit(seat_ == Seat::fly ? Seat::orbit : Seat::fly);
            return true;
        case Key::f:
            sit(Seat::orbit);
            orbit_.frame(mesh().bounds());
            return true;
        case Key::t:
            look_->tree_depth = look_->tree_depth < 0 ? std::min(1, look_->deepest()) : -1;
            return true;
        case Key::k:
            look_->edge_kinds = !look_->edge_kinds;
            return true;
        case Key::i:
            look_->ids = !look_->ids;
            return true;
        case Key::n:
            if (const auto place = findings_->next()) go_to_place(*place);
            return true;
        case Key::digit_1:
            tool_ = Tool::look;
            return true;
        case Key::digit_2:
            tool_ = Tool::measure;
            return true;
        case Key::digit_3:
            tool_ = Tool::hurl;
            return true;
        default:
            return false;
    }
}

bool Walk::event(const view::InputEvent& event) {
    if (const auto* const drop = std::get_if<view::FileDrop>(&event); drop != nullptr && !drop->files.empty()) {
        open(drop->files.front());
        return true;
    }
    if (const auto* const press = std::get_if<view::KeyPress>(&event)) {
        if (key(*press)) return true;
        if (press->down && seat_ == Seat::orbit && level_ &&
            (press->key == Key::w || press->key == Key::a || press->key == Key::s || press->key == Key::d) &&
            !press->held.control)
            sit(Seat::fly);
    }
    if (const auto* const press = std::get_if<view::ButtonPress>(&event);
        press != nullptr && press->button == view::MouseButton::left) {
        // What hardly moved between press and release was a click, the rest a drag of the camera.
        constexpr double hardly = 4;
        if (press->down) {
            pressed_at_ = press->at;
        } else if (pressed_at_ && glm::length(press->at - *pressed_at_) <= hardly) {
            click(press->at);
            pressed_at_.reset();
        }
    }
    std::optional<dvec3> under;
    if (const auto* const move = std::get_if<view::PointerMove>(&event); move != nullptr && tool_ == Tool::measure)
        tape_.hover(place_under(move->at));
    if (const auto* const wheel = std::get_if<view::WheelTurn>(&event)) under = place_under(wheel->at);
    switch (seat_) {
        case Seat::foot:
            return on_foot_->event(event);
        case Seat::fly:
            return fly_.event(event);
        case Seat::orbit:
            break;
    }
    return orbit_.event(event, stage_->display.size(), under);
}

void Walk::click(const dvec2& at) {
    if (!level_ || stage_->navigation.takes_clicks()) return;
    const view::Camera seen = camera();
    const auto hit = view::pick(mesh(), seen, at, stage_->display.size());
    switch (tool_) {
        case Tool::look:
            picked_ = hit ? std::optional(hit->triangle) : std::nullopt;
            break;
        case Tool::measure:
            if (hit) tape_.click(hit->point);
            break;
        case Tool::hurl: {
            const double length = hit ? glm::length(hit->point - seen.eye) * 1.5 + 5 : 200;
            thrower_.throw_at(mesh(), seen.eye, seen.direction(at, stage_->display.size()), length);
            break;
        }
    }
}

std::optional<dvec3> Walk::place_under(const dvec2& at) const {
    if (!level_) return std::nullopt;
    const auto hit = view::pick(mesh(), camera(), at, stage_->display.size());
    return hit && hit->status == HitStatus::ok ? std::optional(hit->point) : std::nullopt;
}

void Walk::sit(Seat seat) {
    if (seat == seat_ || (seat == Seat::foot && !on_foot_)) return;
    const view::Camera now = camera();
    const bool was_on_foot = seat_ == Seat::foot;
    if (was_on_foot) on_foot_->release();
    seat_ = seat;
    if (seat == Seat::fly) {
        fly_.field_of_view = now.field_of_view;
        fly_.place(now.eye, now.forward);
    } else if (seat == Seat::orbit && !was_on_foot) {
        // Around what is in the middle of the picture.
        const auto hit = level_ ? mesh().ray({now.eye, now.eye + now.forward * 1000.0}) : std::nullopt;
        orbit_.take(now, hit ? std::max(glm::length(hit->point - now.eye), 0.5) : 10);
    }
}

void Walk::go_to_place(const dvec3& place) {
    sit(Seat::orbit);
    auto stand = orbit_.goal();
    stand.pivot = place;
    stand.distance = std::min(stand.distance, 4.0);
    stand.pitch = std::max(stand.pitch, 0.35);
    orbit_.go_to(stand);
}

bool Walk::update(double dt) {
    if (const auto news = fetcher_.update()) stage_->toasts.say(*news);
    if (on_foot_ && on_foot_->walker().changes() != changes_) take_ground();
    const bool thrown = thrower_.update(dt);
    const bool moved = seat_ == Seat::foot  ? on_foot_->update(dt)
                       : seat_ == Seat::fly ? fly_.update(dt)
                                            : orbit_.update(dt);
    return thrown || moved || fetcher_.running();
}

void Walk::draw(view::Renderer& renderer) {
    if (!level_) return;
    look_->draw(renderer);
    findings_->draw(renderer, level_->level);
    const view::Camera seen = camera();
    const bool orbits = seat_ == Seat::orbit;
    const double far = orbits ? orbit_.stand().distance : 15;
    look_->draw_ids(renderer, orbits ? orbit_.stand().pivot : seen.eye + seen.forward * (far * 0.5), far * 0.7);
    if (seat_ == Seat::foot) on_foot_->draw(renderer);
    if (picked_) {
        const Triangle t = mesh().triangle(*picked_);
        const dvec3 corners[3] = {t.a, t.b, t.c};
        renderer.triangle(t.a, t.b, t.c, view::with_opacity(view::paint::face, 0.4));
        renderer.polyline(corners, {.colour = view::paint::face, .width = 2.5, .behind = 0.4}, true);
    }
    if (tool_ == Tool::measure) tape_.draw(renderer, {0, 1, 0});
    thrower_.draw(renderer, level_->level);
}

void Walk::ui() {
    if (seat_ == Seat::foot && !on_foot_->shows_panels()) return;
    level_panel();
    if (level_) tool_panel();
    constexpr double beside_panels = 290 + 2 * 14;
    if (seat_ == Seat::foot) {
        const double unit = stage_->display.scale();
        const double side = beside_panels * unit;
        on_foot_->bar(side, stage_->display.size().x - side);
    }
}

void Walk::level_panel() {
    namespace ui = view::ui;
    if (ui::begin("Level", {.width = 290})) {
        if (level_) {
            ImGui::TextUnformatted(std::filesystem::path(level_->level.file).filename().string().c_str());
            ui::note(fmt::format("{} triangles, {} vertices", mesh().triangle_count(), mesh().vertex_count()));
        } else {
            ui::note(
                "Drop a level on the window, or open one: .surefoot .obj .gltf .glb .ply .stl .ac .blend .bsp .pk3");
        }
        if (ui::primary_button("Open ..."))
            stage_->browse_for_level([this](const LevelLoader::Loaded& loaded) { show(loaded); });
        if (!stage_->settings.recent.empty()) {
            ImGui::SameLine();
            ImGui::SetNextItemWidth(-1);
            std::string chosen;
            if (ImGui::BeginCombo("##recent", "Recent", ImGuiComboFlags_HeightLarge)) {
                for (const std::string& path : stage_->settings.recent) {
                    if (ui::row((std::filesystem::path(path).filename().string() + "##" + path).c_str(), false))
                        chosen = path;
                    ui::hint(path);
                }
                ImGui::EndCombo();
            }
            ui::item("Recent");
            if (!chosen.empty()) open(chosen);
        }
        if (fetcher_.offers()) {
            if (ui::button("Fetch OpenArena's maps")) fetcher_.begin();
            ui::hint("113 maps from Debian's packages, 500 MB, into the cache folder; runs levels/fetch.");
        } else if (fetcher_.running()) {
            ui::note("Fetching OpenArena's maps ...");
        }
        if (level_) {
            ImGui::Separator();
            stage_->navigation.ui();
            ImGui::Separator();
            look_->ui();
            if (ui::section("Odd spots"))
                if (const auto place = findings_->ui()) go_to_place(*place);
        }
    }
    ui::end();
}

void Walk::tool_panel() {
    namespace ui = view::ui;
    if (ui::begin("Tools", {.corner = ui::Panel::Corner::upper_right, .width = 290})) {
        seat_row();
        if (seat_ == Seat::foot) on_foot_->panel();
        if (seat_ != Seat::foot || ui::section("What a click does", false)) tools();
    }
    ui::end();
}

void Walk::tools() {
    namespace ui = view::ui;
    if (seat_ != Seat::foot) {
        if (ui::button("Frame (F)")) {
            sit(Seat::orbit);
            orbit_.frame(mesh().bounds());
        }
        if (seat_ == Seat::fly) ui::at_right(fmt::format("{:.1f} m/s", fly_.speed));
    }
    if (ui::radio("Look", tool_ == Tool::look)) tool_ = Tool::look;
    ImGui::SameLine();
    if (ui::radio("Measure", tool_ == Tool::measure)) tool_ = Tool::measure;
    ImGui::SameLine();
    if (ui::radio("Throw", tool_ == Tool::hurl)) tool_ = Tool::hurl;
    if (tool_ == Tool::look) {
        if (picked_) {
            const std::uint32_t id = *picked_;
            ImGui::TextUnformatted(
                fmt::format("Triangle {}\n{}", id, tools::surface_text(level_->level, mesh().surface(id))).c_str());
        } else {
            ui::note("Click a triangle to see which one it is.");
        }
    }
    if (tool_ == Tool::measure) tape_.ui({0, 1, 0});
    if (tool_ == Tool::hurl) thrower_.ui(level_->level);
}

void Walk::seat_row() {
    namespace ui = view::ui;
    if (ui::radio("Orbit", seat_ == Seat::orbit)) sit(Seat::orbit);
    ImGui::SameLine();
    if (ui::radio("Fly (C)", seat_ == Seat::fly)) sit(Seat::fly);
    ImGui::SameLine();
    ImGui::BeginDisabled(!on_foot_);
    if (ui::radio("Foot (G)", seat_ == Seat::foot)) sit(Seat::foot);
    ImGui::EndDisabled();
}

}  // namespace

std::unique_ptr<Room> make_walk() {
    return std::make_unique<Walk>();
}

}  // namespace surefoot::playground
