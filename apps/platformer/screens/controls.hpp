/// What the hands on keyboard, mouse and gamepad ask for, by the user's bindings.
#pragma once

#include <array>

#include "platformer/screens/bindings.hpp"

namespace surefoot::platformer {

struct GameSettings;

/// For one tick.
struct Asked {
    view::dvec2 move{0, 0};  ///< to the right and forward, at most 1 long
    view::dvec2 turn{0, 0};  ///< of the camera: to the right and up [rad]
    bool jump = false;       ///< held, or pressed and let go since the last tick
    bool dash = false;
    bool crouch = false;
    bool retry = false;  ///< pressed since the last tick
};

class Controls {
public:
    /// Takes what is bound, the sticks and the mouse; true if it was of use.
    bool event(const view::InputEvent& event, const Bindings& bindings);

    /// For a tick of `seconds`.
    [[nodiscard]] Asked take(const GameSettings& settings, double seconds);

    /// Lets go of everything, as when a screen opens.
    void release() { *this = {}; }

private:
    struct Button {
        std::array<bool, Bindings::places> held{};  // by place, so that one of two keys that is let go leaves the other
        bool pressed = false;
        [[nodiscard]] bool is_held() const;
    };
    std::array<Button, action_count> buttons_{};
    view::dvec2 stick_{0, 0};
    view::dvec2 look_{0, 0};
    view::dvec2 pushed_{0, 0};
};

}  // namespace surefoot::platformer
