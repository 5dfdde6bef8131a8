/// A camera around a place: a drag turns it, the wheel goes towards what is under the pointer, a right drag moves the
/// place. It eases from where it is to where it should be.
#pragma once

#include <optional>
#include <span>

#include "view/camera.hpp"

namespace surefoot::view {

class OrbitCamera {
public:
    struct Stand {
        dvec3 pivot{0, 0, 0};
        double yaw = 0.7;      ///< about up [rad]
        double pitch = 0.5;    ///< how high the eye stands [rad, -1.55 to 1.55]
        double distance = 10;  ///< [m, 1e-4 to 1e7]

        friend bool operator==(const Stand&, const Stand&) = default;
    };

    explicit OrbitCamera(const dvec3& up = {0, 1, 0});

    /// Takes drags, the wheel and nothing else; true if it was of use. `under` is what the pointer is over, if that is
    /// known: the wheel goes there.
    bool event(const InputEvent& event, const ivec2& size, const std::optional<dvec3>& under = std::nullopt);

    /// Eases on by `dt` seconds; true while it moves.
    bool update(double dt);

    /// Goes to look at all of this, from where it looks now.
    void frame(const Bounds& bounds);

    /// Goes to where all of these places are seen within a part of the picture, as near as that can be had, and keeps
    /// the pivot in the middle of that part from now on. Requires: at least one place, and a part with some room.
    void frame(std::span<const dvec3> places, const Area& part, const ivec2& size);

    /// From now on the pivot is seen in the middle of a part of the picture.
    void keep_pivot_in(const Area& part, const ivec2& size);

    /// Goes there, or is there at once.
    void go_to(const Stand& stand);
    void jump_to(const Stand& stand);

    /// Goes along with what it looks at, at once, whatever else it is on its way to.
    void move_by(const dvec3& by);

    /// Is at once where it was on its way to.
    void arrive();

    /// Looks as `camera` does, at once, around a place `distance` in front of it.
    void take(const Camera& camera, double distance);

    void set_up(const dvec3& up);

    [[nodiscard]] const Stand& stand() const { return now_; }
    [[nodiscard]] const Stand& goal() const { return goal_; }
    [[nodiscard]] Camera camera() const;
    [[nodiscard]] bool is_dragged() const { return drag_.has_value(); }

    double field_of_view = 0.87;  ///< [rad]

private:
    [[nodiscard]] dvec3 outward(const Stand& stand) const;

    dvec3 up_;
    Stand now_;
    Stand goal_;
    dvec2 lens_shift_{0, 0};
    dvec2 lens_goal_{0, 0};
    std::optional<MouseButton> drag_;
};

}  // namespace surefoot::view
