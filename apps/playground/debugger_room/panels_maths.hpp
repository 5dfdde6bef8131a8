/// The panels that take an answer apart: the equations behind it, three ways to ask, and what a level was asked.
#pragma once

#include <memory>

#include "playground/debugger_room/panel.hpp"

namespace surefoot::playground {

[[nodiscard]] std::unique_ptr<Panel> make_mathematics_panel();
[[nodiscard]] std::unique_ptr<Panel> make_strategies_panel();
[[nodiscard]] std::unique_ptr<Panel> make_search_panel();

}  // namespace surefoot::playground
