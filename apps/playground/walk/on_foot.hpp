/// The character of the room Walk: hands, body, camera, overlays and panels in one.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "playground/room.hpp"
#include "playground/walk/controls.hpp"
#include "playground/walk/follow_camera.hpp"
#include "playground/walk/keeping.hpp"
#include "playground/walk/stations.hpp"
#include "playground/walk/step_overlay.hpp"
#include "playground/walk/walker.hpp"

namespace surefoot::playground {

class OnFoot {
public:
    OnFoot(Stage& stage, LevelLoader::Loaded level);

    /// Is there a place where it can stand? Otherwise nothing else here may be asked for.
    [[nodiscard]] bool has_place() const { return has_place_; }

    bool event(const view::InputEvent& event);
    bool update(double dt);
    [[nodiscard]] view::Camera camera() const;
    void draw(view::Renderer& renderer);

    /// What belongs into the panel at the right, and the bar at the bottom.
    void panel();
    void bar(double left, double right);

    /// Lets go of all keys and of the pointer: somebody else is listened to from now on.
    void release();

    [[nodiscard]] const Walker& walker() const { return walker_; }

    /// Where one begins.
    [[nodiscard]] const dvec3& start() const { return stations_.front().place; }

    /// Are panels to be seen?
    [[nodiscard]] bool shows_panels() const { return shows_panels_; }

    [[nodiscard]] static std::span<const view::KeyHelp> help();

private:
    bool key(const view::KeyPress& press);
    bool pad(const view::GamepadButton& press);
    bool go_to(std::size_t station);
    void one_step();
    void capture(bool captured);
    [[nodiscard]] dvec3 place() const { return walker_.drawn_position(stage_.waiting); }
    void body_section();

    Stage& stage_;
    LevelLoader::Loaded level_;
    Walker walker_;
    Controls controls_;
    FollowCamera camera_;
    StepOverlay overlay_;
    Keeping keeping_;
    std::vector<Station> stations_;
    std::size_t station_ = 0;
    bool has_place_ = false;
    bool shows_panels_ = true;
    double still_for_ = 0;  // since when nothing changes [s]
};

}  // namespace surefoot::playground
