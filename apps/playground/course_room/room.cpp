#include "playground/course_room/room.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <imgui.h>
#include <stdexcept>

#include "playground/course_room/race.hpp"
#include "playground/course_room/scene_panel.hpp"
#include "view/orbit_camera.hpp"
#include "view/widgets.hpp"

namespace surefoot::playground {
namespace {

using view::Key;

constexpr view::KeyHelp keys[] = {{"Drag, wheel", "turns around our character; goes nearer"},
                                  {"P, Space", "time stands and goes on"},
                                  {"Comma, full stop", "one tick back, one tick on"},
                                  {"N, B", "the next scene, the one before"},
                                  {"R", "from the beginning"}};

constexpr view::Colour ghost_colour = view::rgb(0x8E6BD6);

class CourseRoom final : public Room {
public:
    void enter(Stage& stage) override {
        stage_ = &stage;
        scenes_ = course::all_scenes();
        for (std::size_t i = 0; i < scenes_.size(); ++i)
            if (scenes_[i].name == stage.scene) choice_.scene = i;
        choice_.other = {.command = stage.ghost_command};
        panel_.type_command(stage.ghost_command);
        choose();
    }

    bool event(const view::InputEvent& event) override {
        if (const auto* const press = std::get_if<view::KeyPress>(&event);
            press != nullptr && press->down && key(press->key))
            return true;
        if (const auto* const press = std::get_if<view::ButtonPress>(&event);
            press != nullptr && press->button != view::MouseButton::left)
            return false;  // what is looked at is the character
        if (const auto* const wheel = std::get_if<view::WheelTurn>(&event)) {
            auto stand = orbit_.goal();
            stand.distance *= std::pow(0.86, wheel->by.y);
            orbit_.go_to(stand);
            return true;
        }
        return orbit_.event(event, stage_->display.size());
    }

    bool update(double dt) override {
        const bool measures = panel_.update();
        if (runs_) time_ += dt * speed_;
        if (time_ >= race_->end()) {
            time_ = race_->end();
            runs_ = false;
        }
        follow();
        orbit_.keep_pivot_in(view::ui::uncovered(stage_->display.size()), stage_->display.size());
        const bool turns = orbit_.update(dt);
        return runs_ || turns || measures;
    }

    [[nodiscard]] view::Camera camera() const override { return orbit_.camera(); }
    void draw(view::Renderer& renderer) override;
    void ui() override;
    [[nodiscard]] std::span<const view::KeyHelp> help() const override { return keys; }
    [[nodiscard]] NavigationGroundPointer ground() const override { return ground_; }

private:
    [[nodiscard]] double shown_time() const {
        return std::min(time_ + (runs_ ? stage_->waiting * speed_ : 0), race_->end());
    }
    [[nodiscard]] double height() const {
        const Capsule body = course::capsule_of(race_->run().settings);
        return 2 * (body.radius + body.half_height);
    }

    void choose() {
        race_.emplace(scenes_[choice_.scene].runs[choice_.run], choice_.other);
        panel_.tell_failure(race_->other() ? race_->other()->outing.failure : std::string());
        auto ground = std::make_shared<NavigationGround>();
        ground->settings = race_->run().settings;
        ground->start = race_->run().start;
        models_.clear();
        for (const course::LevelBody& body : race_->run().level->bodies) {
            const auto mesh = Mesh::build({.vertices = body.triangles.vertices, .indices = body.triangles.indices});
            if (!mesh) throw std::runtime_error(mesh.error().text);
            if (!body.path) ground->pieces.push_back({*mesh, body.pose});
            const view::Colour colour = body.path ? view::rgb(0xC9A26B) : view::rgb(0xB9BEC2);
            models_.push_back(view::Model::make(*mesh, [colour](const SourceTriangle&) { return colour; }));
        }
        ground_ = std::move(ground);
        start();
        orbit_.jump_to({.pivot = race_->ours().position_at(time_),
                        .yaw = yaw_behind() + 0.65,
                        .pitch = 0.32,
                        .distance = 4.5 * height()});
    }

    /// From where one looks along the way that ours will have gone.
    [[nodiscard]] double yaw_behind() const {
        const dvec3 way = race_->ours().outing.last().position - race_->ours().outing.spots.front().position;
        return std::hypot(way.x, way.z) > 0.3 * height() ? std::atan2(-way.x, -way.z) : 0;
    }

    void start() {
        time_ = race_->begin();
        runs_ = true;
    }

    void follow() { orbit_.move_by(race_->ours().position_at(time_) - orbit_.goal().pivot); }

    bool key(Key key) {
        const double tick = race_->run().dt();
        switch (key) {
            case Key::p:
            case Key::space:
                toggle();
                return true;
            case Key::comma:
                runs_ = false;
                time_ = std::max(time_ - tick, race_->begin());
                return true;
            case Key::period:
                runs_ = false;
                time_ = std::min(time_ + tick, race_->end());
                return true;
            case Key::n:
            case Key::b:
                choice_.scene = (choice_.scene + (key == Key::n ? 1 : scenes_.size() - 1)) % scenes_.size();
                choice_.run = 0;
                panel_.forget_measures();
                choose();
                return true;
            case Key::r:
                start();
                return true;
            default:
                return false;
        }
    }

    void toggle() {
        if (!runs_ && time_ >= race_->end()) {
            start();
        } else {
            runs_ = !runs_;
        }
    }

    void draw_racer(view::Renderer& renderer, const Racer& racer, view::Colour colour, double opacity) const;
    void time_bar(double left);

    Stage* stage_ = nullptr;
    course::Scenes scenes_;
    CourseChoice choice_;
    std::optional<Race> race_;
    std::vector<std::shared_ptr<view::Model>> models_;
    NavigationGroundPointer ground_;
    ScenePanel panel_;
    view::OrbitCamera orbit_;
    double time_ = 0;
    double speed_ = 1;
    bool runs_ = true;
};

void CourseRoom::draw_racer(view::Renderer& renderer, const Racer& racer, view::Colour colour, double opacity) const {
    const double time = shown_time();
    const dvec3 place = racer.position_at(time);
    const course::Spot& spot = racer.spot_at(time);
    renderer.shape(race_->run().settings.volume, place, {.colour = colour, .opacity = opacity, .outline = 2});
    std::vector<dvec3> trail;
    for (const course::Spot& one : racer.outing.spots) {
        if (one.time > time) break;
        trail.push_back(one.position);
    }
    trail.push_back(place);
    renderer.polyline(trail, {.colour = view::with_opacity(colour, 0.9), .width = 2.5, .behind = 0.35});
    renderer.label({.place = place + dvec3(0, 0.62 * height(), 0),
                    .text = racer.name + (spot.grounded ? "" : ", in the air"),
                    .behind = 1,
                    .yields = true});
}

void CourseRoom::draw(view::Renderer& renderer) {
    const double time = shown_time();
    const auto poses = course::poses_at(*race_->run().level, std::max(time, 0.0));
    const view::ModelLook look{.edges = {.width = 1}};
    for (std::size_t i = 0; i < models_.size(); ++i) {
        view::ModelLook own = look;
        own.moves = static_cast<bool>(race_->run().level->bodies[i].path);
        renderer.model(models_[i], own, poses[i]);
    }
    draw_racer(renderer, race_->ours(), view::paint::hit, 0.85);
    if (!race_->other()) return;
    draw_racer(renderer, *race_->other(), ghost_colour, 0.45);
    const dvec3 ours = race_->ours().position_at(time);
    const dvec3 ghost = race_->other()->position_at(time);
    if (race_->gap_at(time) > 0.02 * height())
        renderer.line(ours, ghost, {.colour = view::paint::start, .width = 2, .behind = 0.8});
}

void CourseRoom::time_bar(double left) {
    namespace ui = view::ui;
    constexpr float margin = 14;
    const auto x = static_cast<float>(left);
    ImGui::SetNextWindowPos({x, ImGui::GetIO().DisplaySize.y - margin}, ImGuiCond_Always, {0, 1});
    ImGui::SetNextWindowSize({std::max(ImGui::GetIO().DisplaySize.x - x - margin, 160.0F), 0}, ImGuiCond_Always);
    if (ImGui::Begin("##time", nullptr,
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                         ImGuiWindowFlags_NoFocusOnAppearing)) {
        ui::covers();
        const course::Spot& spot = race_->ours().spot_at(time_);
        std::string text = fmt::format("{:.2f} s, {:.0f} ticks a second; ours {}", time_, race_->run().rate,
                                       time_ < 0       ? "comes to stand"
                                       : spot.grounded ? "on ground"
                                                       : "in the air");
        if (race_->other()) {
            text += fmt::format("; {} is {:.3f} m away", race_->other()->name, race_->gap_at(time_));
            if (!race_->other()->outing.failure.empty())
                text += fmt::format(", and gave up at {:.2f} s", race_->other()->outing.last().time);
        }
        ui::key_colour(view::paint::hit, text);
        if (ui::button(runs_ ? "Pause##run" : "Run##run")) toggle();
        constexpr std::array<double, 3> speeds{1, 0.25, 0.05};
        constexpr std::array<const char*, 3> names{"1x", "1/4", "1/20"};
        for (std::size_t i = 0; i < speeds.size(); ++i) {
            ImGui::SameLine();
            if (ui::radio(names[i], speed_ == speeds[i])) speed_ = speeds[i];
        }
        ImGui::SameLine();
        ImGui::SetNextItemWidth(-1);
        const double low = race_->begin();
        const double high = race_->end();
        if (ImGui::SliderScalar("##time", ImGuiDataType_Double, &time_, &low, &high, "%.2f s",
                                ImGuiSliderFlags_AlwaysClamp))
            runs_ = false;
        ui::item("Time");
    }
    ImGui::End();
}

void CourseRoom::ui() {
    namespace ui = view::ui;
    constexpr double width = 330;
    if (ui::begin("Course", {.width = width})) {
        stage_->navigation.ui();
        ImGui::Separator();
        if (panel_.ui(scenes_, choice_)) choose();
    }
    ui::end();
    time_bar((width + 2 * 14) * stage_->display.scale());
}

}  // namespace

std::unique_ptr<Room> make_course() {
    return std::make_unique<CourseRoom>();
}

}  // namespace surefoot::playground
