/// What the player chose, kept in a file of the user's configuration folder.
#pragma once

#include <string>

#include <surefoot/error.hpp>

#include "platformer/screens/bindings.hpp"
#include "platformer/screens/palette.hpp"

namespace surefoot::platformer {

struct GameSettings {
    double mouse_sensitivity = 1;  ///< [0.1 to 4]
    double pad_sensitivity = 1;    ///< [0.1 to 4]
    bool invert_x = false;
    bool invert_y = false;
    double field_of_view = 60;  ///< of the picture's height [degrees, 45 to 90]
    double volume = 0.8;        ///< of everything [0 to 1]
    double music = 0.6;         ///< [0 to 1]
    double effects = 0.9;       ///< [0 to 1]
    ColourVision colours = ColourVision::usual;
    bool reduced_motion = false;  ///< nothing pulses, shakes or flies in
    double ui_scale = 1;          ///< of everything that is written [0.75 to 1.5]
    bool timer = true;
    bool minimap = true;
    bool full_screen = false;
    int width = 1280;  ///< of a window that is a program of its own [320 to 16384]
    int height = 720;  ///< [240 to 16384]
    Bindings bindings = Bindings::defaults();

    [[nodiscard]] bool operator==(const GameSettings&) const = default;
};

/// Empty if the environment names no folder.
[[nodiscard]] std::string game_settings_path();

/// Settings that are not there are the defaults, and so is whatever is out of range. Fails with `unreadable`, and a
/// sentence for the player, where the file is damaged.
[[nodiscard]] Expected<GameSettings> read_game_settings(const std::string& path);

/// Whoever looks finds the whole old file or the whole new one.
[[nodiscard]] Expected<void> write_game_settings(const GameSettings& settings, const std::string& path);

}  // namespace surefoot::platformer
