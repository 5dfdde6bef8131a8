/// Which deliberately broken movers each scene catches.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace surefoot::course {

/// The names of the broken movers that do not clear a scene; the one whose fault it is about comes first.
[[nodiscard]] std::vector<std::string> broken_movers_caught_by(std::string_view scene);

}  // namespace surefoot::course
