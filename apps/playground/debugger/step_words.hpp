/// The lines of a step's story in words, for a list: what was tried, met or decided, and by which number.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <surefoot/character.hpp>
#include <surefoot/character_trace.hpp>

namespace surefoot::debugger {

/// In a few words: "touch: an edge of triangle 4, after 42 %".
[[nodiscard]] std::string title_of(const StepRecord& record);

/// A sentence or two: what it means, and why it was decided so. "The touch lies on an inner edge: the plane of the face
/// that covers it takes the place of its own."
[[nodiscard]] std::string meaning_of(const StepRecord& record);

/// Its places and numbers, a line each.
[[nodiscard]] std::string numbers_of(const StepRecord& record);

/// How deep each line lies within what was begun before it: a touch in its pass, a pass in the look for a step.
[[nodiscard]] std::vector<int> depths_of(std::span<const StepRecord> records);

/// Is it about a triangle?
[[nodiscard]] bool names_triangle(const StepRecord& record);

}  // namespace surefoot::debugger
