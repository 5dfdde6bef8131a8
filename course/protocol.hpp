/// The line protocol by which any program in any language can be a mover: docs/course-protocol.md.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "course/mover.hpp"

namespace surefoot::course::protocol {

/// The first line, from both sides.
inline constexpr std::string_view greeting = "surefoot-course 1";

/// What a mover says once it has taken in a run.
inline constexpr std::string_view ready = "ready";

/// Settings, bodies and start of a run, ended by "go".
[[nodiscard]] std::string text_of(const Run& run);

/// One tick: the poses at its end of the bodies that move, then the input.
[[nodiscard]] std::string text_of(const Level& level, const Input& input, double dt, std::span<const Pose> poses);

/// "at X Y Z GROUNDED", or nothing.
[[nodiscard]] std::optional<Answer> answer_of(const std::string& line);

}  // namespace surefoot::course::protocol
