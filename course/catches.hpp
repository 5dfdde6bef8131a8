/// Which deliberately broken movers each scene catches.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "course/shape.hpp"

namespace surefoot::course {

/// The names of the broken movers that do not clear a scene; the one whose fault it is about comes first. Of shapes
/// other than the capsule that one alone is known.
[[nodiscard]] std::vector<std::string> broken_movers_caught_by(std::string_view scene, BodyShape shape);

}  // namespace surefoot::course
