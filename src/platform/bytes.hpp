// The bytes of a file, mapped where they lie or owned.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>

#include <surefoot/error.hpp>

namespace surefoot::internal {

/// A file, mapped read-only for as long as this lives. Whoever cuts the file short meanwhile takes the pages away from
/// under its readers (SIGBUS on POSIX); files that a stranger may cut are for `OwnedBytes`.
class MappedFile {
public:
    /// Fails with `not_found`, or `unreadable` for what is not a plain file or is empty.
    [[nodiscard]] static Expected<MappedFile> open(const std::string& path);

    /// The same, copied page by page when it is written into: the file and other processes never see what is written.
    [[nodiscard]] static Expected<MappedFile> open_private(const std::string& path);

    MappedFile(MappedFile&& other) noexcept;
    MappedFile& operator=(MappedFile&& other) noexcept;
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;
    ~MappedFile();

    [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return bytes_; }

    /// Gives the mapping away; `unmap` is the new owner's to call.
    [[nodiscard]] std::span<const std::byte> release() noexcept { return std::exchange(bytes_, {}); }

private:
    explicit MappedFile(std::span<const std::byte> bytes) noexcept : bytes_(bytes) {}
    std::span<const std::byte> bytes_;
};

/// Memory of one's own, aligned as the sections of a file are, and on huge pages where the system offers them.
class OwnedBytes {
public:
    static constexpr std::size_t alignment = 64;

    /// Empty when memory has run out (and size is not 0). The bytes are all zeros.
    [[nodiscard]] static OwnedBytes allocate(std::size_t size) noexcept;

    /// All bytes of a file. Fails as `MappedFile::open` does, and with `out_of_memory`.
    [[nodiscard]] static Expected<OwnedBytes> read(const std::string& path);

    OwnedBytes() noexcept = default;
    OwnedBytes(OwnedBytes&& other) noexcept;
    OwnedBytes& operator=(OwnedBytes&& other) noexcept;
    OwnedBytes(const OwnedBytes&) = delete;
    OwnedBytes& operator=(const OwnedBytes&) = delete;
    ~OwnedBytes();

    [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return bytes_; }
    [[nodiscard]] std::span<std::byte> writable() noexcept { return bytes_; }

private:
    std::span<std::byte> bytes_;
};

}  // namespace surefoot::internal
