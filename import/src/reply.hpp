/// How the helper program hands a level, or an error, back to us: one block of bytes on its standard output. Both ends
/// are one machine and one version, so numbers travel as they lie in memory; but the helper may have been led astray by
/// the file it read, so decoding trusts nothing.
///
///     "surefoot-reply-1" | kind: u32 (0 level, 1 error) | payload | "end of the reply"
///     text:  u32 length, bytes                array: u64 count, elements
///     level: vertices, indices, surfaces, surface names, surface extras, parts, markers, notes
///     error: u32 code, text, u64 byte
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <surefoot/import.hpp>

namespace surefoot::internal {

[[nodiscard]] std::vector<std::byte> encode_level(const ImportedLevel& level);
[[nodiscard]] std::vector<std::byte> encode_error(const Error& error);

/// The level (without a file name) or the error that was sent. Anything that is not a whole and consistent reply is an
/// error with the code `unreadable` and an empty text: the caller knows more about why. Any bytes are fine; takes
/// memory in proportion to them.
[[nodiscard]] Expected<ImportedLevel> decode_reply(std::span<const std::byte> bytes);

}  // namespace surefoot::internal
