/// Which panels the Debugger has.
#pragma once

#include <memory>
#include <vector>

#include "playground/debugger_room/panel.hpp"

namespace surefoot::playground {

/// All of them, in the order of the bar.
[[nodiscard]] std::vector<std::unique_ptr<Panel>> make_panels();

}  // namespace surefoot::playground
