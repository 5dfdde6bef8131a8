/// The settings of a character as widgets: a row for each field of the table.
#pragma once

#include "playground/level_loader.hpp"
#include "playground/walk/walker.hpp"
#include "view/display.hpp"
#include "view/toasts.hpp"

namespace surefoot::playground {

/// What a character of this room can do: the library's defaults, and it can also crouch, dash, hang on edges and vault.
[[nodiscard]] CharacterSettings room_settings();

/// The widgets: all groups, each to be folded, and buttons to reset, copy and paste. A change is for the next tick.
void settings_panel(Walker& walker, const tools::Level& level, view::Display& display, view::Toasts& toasts);

}  // namespace surefoot::playground
