/// A section of a `.surefoot` file in memory that may be written into: for owners whose data is changed while it is
/// used, such as a navigation mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <surefoot/error.hpp>
#include <surefoot/file.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// The file is mapped, not read: a page is loaded when it is looked at, and copied when it is first written into.
/// Guarantees: the file, and whoever else maps it, never see what is written.
/// Requires: nobody cuts the file short or writes into it as long as this lives; replacing it as `Mesh::write` does is
/// fine.
class PrivateSection {
public:
    /// Nothing if the file has no such section. Fails as `Mesh::open` does, and with `unreadable` when `check` is
    /// `Check::everything` and the section's bytes are not those of its checksum. The other checks look at the file's
    /// header and table alone.
    [[nodiscard]] static Expected<std::optional<PrivateSection>> open(const std::string& path, std::string_view owner,
                                                                      std::string_view name,
                                                                      Check check = Check::header);

    PrivateSection(PrivateSection&& other) noexcept;
    PrivateSection& operator=(PrivateSection&& other) noexcept;
    PrivateSection(const PrivateSection&) = delete;
    PrivateSection& operator=(const PrivateSection&) = delete;
    ~PrivateSection();

    /// Begin at a multiple of 64 bytes.
    [[nodiscard]] std::span<std::byte> bytes() const noexcept { return bytes_; }

    [[nodiscard]] std::uint32_t version() const noexcept { return version_; }         ///< `Section::version`
    [[nodiscard]] std::uint64_t made_from() const noexcept { return made_from_; }     ///< `Section::made_from`
    [[nodiscard]] std::uint64_t mesh_made_from() const noexcept { return of_mesh_; }  ///< `Mesh::made_from`
    [[nodiscard]] std::uint64_t offset() const noexcept { return offset_; }           ///< of its first byte in the file

private:
    PrivateSection() noexcept = default;
    std::span<const std::byte> mapped_;
    std::span<std::byte> bytes_;
    std::uint32_t version_ = 0;
    std::uint64_t made_from_ = 0;
    std::uint64_t of_mesh_ = 0;
    std::uint64_t offset_ = 0;
};

}  // namespace v0
}  // namespace surefoot
