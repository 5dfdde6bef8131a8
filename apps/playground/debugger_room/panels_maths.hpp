/// The panels that take an answer apart: the equations behind it, three ways to ask, what a level was asked,
/// and the story of the step that makes a RESULT of it.
#pragma once

#include <memory>
#include <string_view>

#include "playground/debugger_room/panel.hpp"

namespace surefoot::playground {

inline constexpr std::string_view step_panel_name = "A step";

[[nodiscard]] std::unique_ptr<Panel> make_mathematics_panel();
[[nodiscard]] std::unique_ptr<Panel> make_strategies_panel();
[[nodiscard]] std::unique_ptr<Panel> make_search_panel();
[[nodiscard]] std::unique_ptr<Panel> make_step_panel();

}  // namespace surefoot::playground
