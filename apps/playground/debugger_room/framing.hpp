/// Where the camera stands so that what matters is seen beside the panels. It is kept there while panels open, close
/// and grow and while the window does, until somebody moves the camera by hand.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "view/orbit_camera.hpp"

namespace surefoot::playground {

class Framing {
public:
    explicit Framing(view::OrbitCamera& orbit) : orbit_(&orbit) {}

    /// Goes to see all of these places from where it looks now, and keeps them seen. Requires: at least one.
    void show(std::vector<dvec3> places, const view::ivec2& size);

    /// Keeps them seen, from where the camera was brought by others; none if it was somebody's hand.
    void keep(std::vector<dvec3> places) { kept_ = std::move(places); }
    [[nodiscard]] const std::vector<dvec3>& kept() const { return kept_; }

    /// Goes elsewhere for a while: where it stood before the first of such goings, to begin from.
    [[nodiscard]] view::OrbitCamera::Stand depart();
    /// Back to there, and to what was kept seen; nothing if it never went.
    void come_back();

    /// From behind what goes this way, and a little beside it; from where it is, if that is straight up or down.
    void look_along(const dvec3& way);

    /// Looks at what the panels of the last frame left free; once a tick.
    void update(const view::ivec2& size);

private:
    view::OrbitCamera* orbit_;
    std::vector<dvec3> kept_;
    std::optional<std::pair<view::OrbitCamera::Stand, std::vector<dvec3>>> before_;  // it went, and what was kept
    view::Area part_{{0, 0}, {0, 0}};  // of the picture, in which they are seen
    int age_ = 0;                      // [ticks], up to when panels have found their sizes
};

/// The corners of a box.
void append_corners(std::vector<dvec3>& places, const Bounds& box);

}  // namespace surefoot::playground
