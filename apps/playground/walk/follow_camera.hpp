/// A camera behind a character: a drag turns it, the wheel sets how far away it is, and no wall comes between, for a
/// ball is swept from the character to the eye.
#pragma once

#include <optional>

#include <surefoot/world.hpp>

#include "view/camera.hpp"

namespace surefoot::playground {

class FollowCamera {
public:
    /// Takes drags and the wheel; every move of the pointer while it is `captured`.
    bool event(const view::InputEvent& event, bool captured);

    /// Turns by so much, as a stick does: to the right and down [rad].
    void turn(const view::dvec2& by);

    /// Eases on by `dt` seconds; `middle` is where the body is. True while it moves.
    bool update(double dt, const World& world, const dvec3& middle);

    /// Is there at once, looking along `yaw`.
    void jump_to(const dvec3& middle, double yaw);

    /// The eye of a body that is drawn at `middle`.
    [[nodiscard]] view::Camera camera(const World& world, const dvec3& middle) const;

    /// The body is seen in the middle of a part of the picture, gently.
    void keep_in(const view::Area& part, const view::ivec2& size, double dt);

    /// The level direction in which one looks.
    [[nodiscard]] dvec3 ahead() const;

    [[nodiscard]] double yaw() const { return yaw_; }
    [[nodiscard]] bool is_dragged() const { return drag_.has_value(); }

    /// So near that the body would hide everything.
    [[nodiscard]] bool is_inside() const { return free_ < 0.7; }

private:
    [[nodiscard]] dvec3 outward() const;
    [[nodiscard]] double free_way(const World& world, const dvec3& middle) const;

    double yaw_ = 0;  // as an orbit camera's
    double pitch_ = 0.3;
    double distance_ = 5;  // that is wished [m]
    double free_ = 5;      // and that there is room for [m]
    double height_ = 0;    // of what is looked at: stairs do not shake it
    double lag_ = 0;       // how far that is below the body
    view::dvec2 lens_shift_{0, 0};
    std::optional<view::MouseButton> drag_;
};

/// The yaw at which a camera looks along a level direction.
[[nodiscard]] double yaw_towards(const dvec3& direction);

}  // namespace surefoot::playground
