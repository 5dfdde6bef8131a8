/// Writing a file so that whoever looks finds the whole old one or the whole new one.
#pragma once

#include <string>
#include <string_view>

#include <surefoot/error.hpp>

namespace surefoot::game {

/// Makes the folder, too. Fails with `write_failed`; nothing half-written is left.
[[nodiscard]] Expected<void> write_whole(const std::string& path, std::string_view bytes);

/// Fails with `not_found`.
[[nodiscard]] Expected<std::string> read_whole(const std::string& path);

}  // namespace surefoot::game
