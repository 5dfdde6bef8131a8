// Replacing a file in one step: whoever looks sees the whole old file or the whole new one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <surefoot/error.hpp>

namespace surefoot::internal {

/// A file in the making. It is written under a name of its own beside the one it is to replace, brought to the disk,
/// and renamed. A full disk, a kill at any moment and other writers leave the old file whole; only a kill leaves a
/// "NAME.*.part" behind.
class AtomicFile {
public:
    /// Fails with `write_failed`: no such folder, no permission, or `path` is there and no plain file.
    [[nodiscard]] static Expected<AtomicFile> create(const std::string& path);

    AtomicFile(AtomicFile&& other) noexcept;
    AtomicFile& operator=(AtomicFile&&) = delete;
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;
    ~AtomicFile();  ///< without `commit`, nothing has happened

    /// Appends.
    [[nodiscard]] Expected<void> write(std::span<const std::byte> bytes);

    /// Makes the file the one at `path`. Fails with `write_failed`, and then nothing has happened.
    [[nodiscard]] Expected<void> commit();

private:
    AtomicFile(std::string path, std::string temporary, std::intptr_t handle) noexcept;
    [[nodiscard]] tl::unexpected<Error> failure(const char* doing, int system_error) const;
    void close() noexcept;

    std::string path_;
    std::string temporary_;  ///< empty once it is gone
    std::intptr_t handle_;   ///< the system's own; -1 once closed
};

/// A file name that no other writer uses: `path`, the process, a count and ".part".
[[nodiscard]] std::string temporary_name(const std::string& path, std::uint64_t process);

/// What a failed write says to a person.
[[nodiscard]] Error write_error(const std::string& path, const char* doing, const std::string& reason);

}  // namespace surefoot::internal
