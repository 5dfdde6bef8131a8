// Notes and reports as the bytes of a section.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <surefoot/cook.hpp>

namespace surefoot::internal {

inline constexpr std::uint32_t notes_version = 1;
inline constexpr std::uint32_t report_version = 1;

[[nodiscard]] std::vector<std::byte> to_bytes(const LevelNotes& notes);
[[nodiscard]] std::vector<std::byte> to_bytes(const CookReport& report);

/// Nothing if the bytes end too early.
[[nodiscard]] std::optional<LevelNotes> notes_from(std::span<const std::byte> bytes);
[[nodiscard]] std::optional<CookReport> report_from(std::span<const std::byte> bytes);

}  // namespace surefoot::internal
