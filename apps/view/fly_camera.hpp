/// A camera without weight: W A S D and Q E move it, a drag looks around, Shift hurries, the wheel sets how fast it is.
#pragma once

#include <array>
#include <optional>

#include "view/camera.hpp"

namespace surefoot::view {

class FlyCamera {
public:
    explicit FlyCamera(const dvec3& up = {0, 1, 0});

    bool event(const InputEvent& event);

    /// Flies on by `dt` seconds; true while it moves.
    bool update(double dt);

    void place(const dvec3& eye, const dvec3& forward);

    [[nodiscard]] Camera camera() const;

    double speed = 6;             ///< [m/s, 0.01 to 1e5]
    double field_of_view = 1.05;  ///< [rad]

private:
    [[nodiscard]] bool held(Key key) const { return keys_[static_cast<std::size_t>(key)]; }

    dvec3 up_;
    dvec3 eye_{0, 2, 0};
    dvec3 velocity_{0, 0, 0};
    double yaw_ = 0;
    double pitch_ = 0;
    std::array<bool, static_cast<std::size_t>(Key::count)> keys_{};
    std::optional<MouseButton> drag_;
};

}  // namespace surefoot::view
