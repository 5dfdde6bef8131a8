/// The two pieces of music.
#pragma once

#include <cstdint>
#include <string_view>

#include "platformer/sound/score.hpp"

namespace surefoot::sound {

enum class Piece : std::uint8_t { calm, lively };

inline constexpr int piece_count = static_cast<int>(Piece::lively) + 1;

[[nodiscard]] std::string_view name_of(Piece piece);

/// As it is written.
[[nodiscard]] std::string_view text_of(Piece piece);

/// As it is read.
[[nodiscard]] const Score& score_of(Piece piece);

}  // namespace surefoot::sound
