/// What the user chose, kept in a file of the user's configuration folder.
#pragma once

#include <string>
#include <vector>

#include <surefoot/error.hpp>

namespace surefoot::view {

struct Settings {
    int version = 1;
    bool full_screen = false;
    int width = 1280;                 ///< of the window [320 to 16384]
    int height = 720;                 ///< [240 to 16384]
    std::string preset;               ///< "full", "software", or empty: as the graphics card says
    double field_of_view = 60;        ///< when flying [degrees, 20 to 120]
    std::vector<std::string> recent;  ///< levels, the last one first; at most `most_recent`

    static constexpr std::size_t most_recent = 8;

    /// Puts a level at the front.
    void remember_level(const std::string& level);

    [[nodiscard]] bool operator==(const Settings&) const = default;
};

/// Where they are: under XDG_CONFIG_HOME, HOME/.config, or APPDATA on Windows. Empty if the environment names no
/// folder.
[[nodiscard]] std::string settings_path();

/// Settings that are not there are the defaults, and so is whatever is out of range. Fails with `unreadable`, and a
/// sentence for the user, where the file is damaged.
[[nodiscard]] Expected<Settings> read_settings(const std::string& path);

/// Makes the folder. Whoever looks finds the whole old file or the whole new one.
[[nodiscard]] Expected<void> write_settings(const Settings& settings, const std::string& path);

}  // namespace surefoot::view
