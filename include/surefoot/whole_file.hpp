/// Writing a file of one's own, settings, a save, a replay, as the library writes its files.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include <surefoot/error.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// Puts `bytes` into the file at `path`, in place of what was there: they are written beside it, brought to the disk,
/// and given its name. Text goes in as `std::as_bytes(std::span(text))`.
/// Requires: the folder is there.
/// Guarantees: whoever looks, at any moment, finds the whole old file or the whole new one; a full disk, a kill and
/// other writers change nothing about that, and only a kill leaves a "NAME.*.part" behind.
/// Fails with `write_failed`, and then the old file is what it was: no such folder, no permission, no room, or `path`
/// is there and no plain file.
[[nodiscard]] Expected<void> write_whole_file(const std::string& path, std::span<const std::byte> bytes);

}  // namespace v0
}  // namespace surefoot
