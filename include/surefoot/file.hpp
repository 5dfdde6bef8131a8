/// What a `.surefoot` file holds besides its triangles, and how closely it is looked at. docs/file-format.md tells
/// every byte.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// How closely a file is looked at before it is used. Queries are safe whatever its bytes are, so the check decides
/// only how soon a damaged file is noticed: by an `Error` when it is opened, or by answers that are wrong.
enum class Check : std::uint8_t {
    header,      ///< the header and the table of sections, checksum included; under a millisecond at any size
    structure,   ///< also every node and leaf: all triangles reachable, once each, and their vertices in their boxes
    everything,  ///< also the checksum of every section
};

/// A named run of bytes in a file. Surefoot keeps its own under the owner "surefoot"; yours may hold what you like.
struct Section {
    std::string_view owner{};            ///< who knows what the bytes mean [1 to 16 bytes of ASCII, no spaces]
    std::string_view name{};             ///< what it is, unique for this owner [1 to 24 bytes of ASCII, no spaces]
    std::uint32_t version = 1;           ///< the owner's own count
    std::uint64_t made_from = 0;         ///< a hash of what it was made from, so that its owner sees when it is stale
    std::span<const std::byte> bytes{};  ///< begin at a multiple of 64 bytes in memory when read from a file
};

/// XXH3-64, as in the files: for `Section::made_from`, or for anything else.
[[nodiscard]] std::uint64_t hash_bytes(std::span<const std::byte> bytes, std::uint64_t seed = 0) noexcept;

}  // namespace v0
}  // namespace surefoot
