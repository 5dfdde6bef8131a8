/// Small files of the game, read whole and replaced whole.
#pragma once

#include <string>
#include <string_view>

#include <surefoot/error.hpp>

namespace surefoot::game {

/// As `write_whole_file`, and makes the folder, too. Fails with `write_failed`.
[[nodiscard]] Expected<void> write_whole(const std::string& path, std::string_view bytes);

/// Fails with `not_found`.
[[nodiscard]] Expected<std::string> read_whole(const std::string& path);

}  // namespace surefoot::game
