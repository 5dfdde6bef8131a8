/// Reading levels of any format and cooking them, with the user's cache in between.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <surefoot/cook.hpp>
#include <surefoot/import.hpp>

namespace surefoot::tools {

/// Is this the name of a cooked file?
[[nodiscard]] bool is_cooked_name(const std::string& path);

/// A hash of the bytes of all these files, of what they refer to, and of whatever changes how they are cooked; nothing
/// if one of them cannot be read.
[[nodiscard]] std::optional<std::uint64_t> hash_of_sources(const std::vector<std::string>& files,
                                                           const ImportOptions& options, double tolerance);

/// Reads levels and makes one of them. Surfaces of one name become one. Throws `Failure`.
[[nodiscard]] ImportedLevel import_all(const std::vector<std::string>& files, const ImportOptions& options);

/// Cooks with a progress bar, and tells how much is done [0 to 1]. Throws `Failure`.
[[nodiscard]] Cooked cook_imported(ImportedLevel& level, double tolerance, std::uint64_t made_from,
                                   const std::function<void(double done)>& tell = {});

/// What to say about a level that could not be opened: near file names if there is none of this name.
[[nodiscard]] std::string with_near_file(const Error& error, const std::string& path);

/// Every count of the notes, in the order in which they are written.
inline constexpr std::size_t import_note_count = 11;
[[nodiscard]] std::array<std::uint64_t*, import_note_count> counts_of(ImportNotes& notes);

/// What the importer left out, as the bytes of a section and back.
[[nodiscard]] std::vector<std::byte> to_bytes(const ImportNotes& notes);
[[nodiscard]] ImportNotes import_notes_of(const Mesh& mesh);

inline constexpr Section import_notes_section{.owner = "surefoot-tools", .name = "import"};

}  // namespace surefoot::tools
