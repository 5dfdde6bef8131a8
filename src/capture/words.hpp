// What the file calls things: shared by the writer and the reader, so that they cannot differ.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include <surefoot/capture.hpp>

namespace surefoot::internal {

inline constexpr std::array<std::string_view, 2> kind_words{"sweep", "ray"};
inline constexpr std::array<std::string_view, 3> feature_words{"face", "edge", "vertex"};
inline constexpr std::array<std::string_view, 3> status_words{"ok", "invalid", "overflow"};

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
