/// Copy and paste: a question as the line of JSON that `surefoot sweep --batch` reads, with one more name, "triangles",
/// where the world is a few triangles and not a level.
#pragma once

#include <string>
#include <string_view>

#include "debugger/question.hpp"
#include "parse.hpp"

namespace surefoot::debugger {

/// {"shape":{"sphere":[0.5]},"from":[x,y,z],"to":[x,y,z],"rotate":[w,x,y,z],"one_sided":false,
/// "triangles":[[[x,y,z],[x,y,z],[x,y,z]],...]}, in one line. Numbers read back to the same bits.
[[nodiscard]] std::string to_line(const Question& question);

/// Reads such a line. What it says nothing about (its triangles, the sizes of the other shapes) stays as it is in
/// `now`. A sentence that says what to write instead, if it is no such line.
[[nodiscard]] tools::Parsed<Question> from_line(std::string_view line, const Question& now);

/// No more triangles than this are read: it is for a few, and levels have files.
inline constexpr std::size_t most_triangles = 64;

}  // namespace surefoot::debugger
