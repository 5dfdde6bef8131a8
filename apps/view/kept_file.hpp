/// Small files of the user's configuration folder: read whole, replaced whole.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include <surefoot/error.hpp>

namespace surefoot::view {

/// Where a file of this name is kept: under XDG_CONFIG_HOME, HOME/.config, or APPDATA on Windows. Empty if the
/// environment names no folder.
[[nodiscard]] std::string kept_path(std::string_view name);

/// An empty object if there is no such file. Fails with `unreadable` where the file is damaged; the text begins with
/// the path and `what` the file holds, such as "the settings".
[[nodiscard]] Expected<nlohmann::json> read_kept(const std::string& path, std::string_view what);

/// Makes the folder. Whoever looks finds the whole old file or the whole new one.
[[nodiscard]] Expected<void> write_kept(const nlohmann::json& json, const std::string& path, std::string_view what);

}  // namespace surefoot::view
