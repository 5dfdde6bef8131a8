/// What the hands on keyboard and gamepad ask of a character.
#pragma once

#include <array>
#include <string_view>

#include <surefoot/character.hpp>

#include "view/input.hpp"

namespace surefoot::playground {

class Controls {
public:
    /// Takes what moves a character and nothing else; true if it was of use.
    bool event(const view::InputEvent& event);

    /// For one tick, with `ahead` as the level direction in which one looks. What was pressed and let go since the last
    /// call counts as held.
    [[nodiscard]] CharacterInput take(const dvec3& ahead);

    /// Lets go of everything.
    void release();

    /// How fast the right stick turns the eye, to the right and down [-1 to 1].
    [[nodiscard]] view::dvec2 look() const;

    double walk_speed = 4;  ///< [m/s]
    double run_speed = 7;   ///< [m/s]
    CharacterMode mode = CharacterMode::walk;

private:
    struct Button {
        bool held = false;
        bool pressed = false;  // since the last tick
        void set(bool down) {
            held = down;
            pressed = pressed || down;
        }
        [[nodiscard]] bool take() {
            const bool is_on = held || pressed;
            pressed = false;
            return is_on;
        }
    };
    enum Use : std::size_t { forth, back, left, right, jump, run, crouch, dash, use_count };

    std::array<Button, use_count> keys_{};
    std::array<Button, use_count> pad_{};
    view::dvec2 stick_{0, 0};
    view::dvec2 look_{0, 0};
};

}  // namespace surefoot::playground
