// Where things that can be made again are kept.
#pragma once

#include <string>

#include <surefoot/error.hpp>

namespace surefoot::internal {

/// The user's folder for Surefoot's cache, whether it is there or not: XDG_CACHE_HOME/surefoot, HOME/.cache/surefoot,
/// or LOCALAPPDATA\surefoot on Windows. Empty if the environment names none.
[[nodiscard]] std::string cache_folder();

/// Makes a folder and those above it. Fails with `write_failed`.
[[nodiscard]] Expected<void> make_folders(const std::string& path);

}  // namespace surefoot::internal
