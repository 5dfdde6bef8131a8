/// A character's settings for the clipboard: as JSON to be pasted here again, and as C++ to be pasted into a game.
#pragma once

#include <string>
#include <string_view>

#include <surefoot/character_settings.hpp>
#include <surefoot/error.hpp>

namespace surefoot::playground {

/// All fields but `surfaces`, on a line each.
[[nodiscard]] std::string settings_json(const CharacterSettings& settings);

/// Fields that are not named keep the values of `base`. Fails with `invalid`, in words, for a name that is none and for
/// a value that does not fit, also for settings with which nobody can step.
[[nodiscard]] Expected<CharacterSettings> parse_settings(std::string_view text, const CharacterSettings& base);

/// What differs from the defaults, as designated initialisers.
[[nodiscard]] std::string settings_cpp(const CharacterSettings& settings);

}  // namespace surefoot::playground
