/// The worlds that the debugger begins with, each with a question that shows something.
#pragma once

#include <string>
#include <vector>

#include <surefoot/bounds.hpp>

#include "debugger/question.hpp"

namespace surefoot::debugger {

/// The triangles of a world; none for `own` and `level`.
[[nodiscard]] std::vector<Triangle> triangles_of(WorldKind world);

/// What it is called in a menu.
[[nodiscard]] std::string title_of(WorldKind world);

/// A question worth looking at: in the triangle's world the ellipsoid comes down beside the longest side and meets the
/// edge; in the fold it meets the crease from outside; in the wedge it is driven into the acute corner, which stops it
/// long before its middle line would. Requires: one of these three.
[[nodiscard]] Question default_question(WorldKind world);

/// Down through the middle of a level, from a tenth of its height above it.
[[nodiscard]] Question question_in_level(const std::string& file, const Bounds& bounds);

}  // namespace surefoot::debugger
