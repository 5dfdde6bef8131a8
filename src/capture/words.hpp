// What the file calls things: shared by the writer and the reader, so that they cannot differ.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include <surefoot/capture.hpp>
#include <surefoot/character.hpp>

namespace surefoot::internal {

inline constexpr std::array<std::string_view, 2> kind_words{"sweep", "ray"};
inline constexpr std::array<std::string_view, 3> feature_words{"face", "edge", "vertex"};
inline constexpr std::array<std::string_view, 3> status_words{"ok", "invalid", "overflow"};

inline constexpr std::array<std::string_view, 2> response_words{"slide", "stop"};
inline constexpr std::array<std::string_view, 2> firmness_words{"hard", "soft"};
inline constexpr std::array<std::string_view, 2> slope_speed_words{"level", "along"};
inline constexpr std::array<std::string_view, 4> footing_words{"air", "ground", "steep", "ledge"};
inline constexpr std::array<std::string_view, 4> mode_words{"walk", "swim", "fly", "own"};
inline constexpr std::array<std::string_view, 5> form_words{"standing", "crouched", "in_air", "on_ramp", "on_ledge"};
inline constexpr std::array<std::string_view, 3> hold_words{"none", "hanging", "climbing"};
inline constexpr std::array<std::string_view, 31> act_words{
    "carried",      "recovered",    "wants",          "pass",       "touch",         "obeyed",       "passed_over",
    "seam",         "wall",         "gave_up_rising", "rested",     "step_tried",    "step_refused", "stepped_up",
    "ground",       "no_ground",    "snapped_down",   "jumped",     "landed",        "left_ground",  "jump_refused",
    "changed_form", "form_refused", "ledge_wall",     "ledge_edge", "ledge_refused", "crushed",      "stuck",
    "overflow",     "parted",       "met_neighbour"};
inline constexpr std::array<std::string_view, 11> rule_words{
    "none",          "slope_limit",    "step_height", "head_room", "no_advance", "not_higher",
    "snap_distance", "perch_distance", "slippery",    "steps_off", "coyote_time"};

// Whoever adds an act or a rule adds its word.
static_assert(act_words.size() == static_cast<std::size_t>(StepAct::met_neighbour) + 1);
static_assert(rule_words.size() == static_cast<std::size_t>(StepRule::coyote_time) + 1);

/// "unknown", which no reader takes, for a value that is none of the enumeration's.
template <std::size_t count, typename Enum>
[[nodiscard]] std::string_view word_of(const std::array<std::string_view, count>& words, Enum value) noexcept {
    const auto index = static_cast<std::size_t>(value);
    return index < count ? words[index] : std::string_view("unknown");
}

/// In the order of `Shape`.
inline constexpr std::array<std::string_view, 6> shape_words{"sphere", "ellipsoid", "capsule",
                                                             "box",    "cylinder",  "cone"};
/// How many numbers each is.
inline constexpr std::array<std::size_t, 6> shape_counts{1, 3, 2, 3, 2, 2};

[[nodiscard]] std::array<double, 3> dimensions_of(const Shape& shape) noexcept;

/// Requires: `index` < 6, that of `Shape`.
[[nodiscard]] Shape shape_from(std::size_t index, const std::array<double, 3>& dimensions) noexcept;

/// Numbers that JSON has no word for are strings: "inf", "-inf", and "nan:" with the 16 hexadecimal digits of its bits.
inline constexpr std::string_view infinity_word = "inf";
inline constexpr std::string_view minus_infinity_word = "-inf";
inline constexpr std::string_view nan_word = "nan:";

}  // namespace surefoot::internal
