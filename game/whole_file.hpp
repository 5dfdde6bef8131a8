/// Writing a file so that whoever looks finds the whole old one or the whole new one.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <surefoot/error.hpp>

namespace surefoot::game {

/// Makes the folder, too. Fails with `write_failed`; nothing half-written is left.
[[nodiscard]] Expected<void> write_whole(const std::string& path, std::string_view bytes);

/// Fails with `not_found`.
[[nodiscard]] Expected<std::string> read_whole(const std::string& path);

/// Where something that can be made again may be kept for the next time: in the user's cache folder, by what it is and
/// what it was made from. Empty if the environment names no folder.
[[nodiscard]] std::string cache_path(std::string_view what, std::uint64_t made_from);

}  // namespace surefoot::game
