// Sections in a file: finding them in bytes that may be anything, and laying them out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <surefoot/error.hpp>
#include <surefoot/file.hpp>

#include "file/format.hpp"

namespace surefoot::internal {

/// An error of a cooked file, with the place and with what to do about it.
[[nodiscard]] Error file_error(ErrorCode code, const std::string& file, std::uint64_t byte, const std::string& what);

/// The sections of a file that somebody else holds in memory.
class Container {
public:
    /// Looks at the header and the table of sections alone. Every section then lies within `bytes`.
    /// Requires: `bytes` begin at a multiple of 64.
    [[nodiscard]] static Expected<Container> parse(std::span<const std::byte> bytes, std::string file);

    [[nodiscard]] std::span<const Section> sections() const noexcept { return sections_; }
    [[nodiscard]] const Section* find(std::string_view owner, std::string_view name) const noexcept;

    /// Where a section begins in the file, for errors. Requires: it is one of these.
    [[nodiscard]] std::uint64_t offset_of(const Section& section) const noexcept;

    [[nodiscard]] const std::string& file() const noexcept { return file_; }
    [[nodiscard]] std::uint64_t made_from() const noexcept { return made_from_; }
    [[nodiscard]] std::uint64_t size() const noexcept { return bytes_.size(); }

    /// Reads all bytes and compares them with their checksums.
    [[nodiscard]] Expected<void> check_sums() const;

    /// The same for one section. Requires: it is one of these.
    [[nodiscard]] Expected<void> check_sum(const Section& section) const;

private:
    Container(std::span<const std::byte> bytes, std::string file) noexcept;

    std::span<const std::byte> bytes_;
    std::string file_;
    std::uint64_t made_from_ = 0;
    std::vector<Section> sections_;
};

/// The header and the table for these sections, padded to where the first one begins.
/// Fails with `invalid` for a name that is too long, empty, not plain ASCII or there twice, and with `limit`.
[[nodiscard]] Expected<std::vector<std::byte>> lay_out(std::span<const Section> sections, std::uint64_t made_from);

/// Writes a file in one step; see AtomicFile.
[[nodiscard]] Expected<void> write_file(const std::string& path, std::span<const Section> sections,
                                        std::uint64_t made_from);

}  // namespace surefoot::internal
