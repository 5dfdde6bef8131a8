/// The lessons: panels with a scene of their own.
#pragma once

#include <memory>

#include "playground/debugger_room/panel.hpp"

namespace surefoot::playground {

/// Five shapes on a slope, at stairs and over a ledge.
[[nodiscard]] std::unique_ptr<Panel> make_side_by_side_panel();

/// The move of block worlds, wrong and right.
[[nodiscard]] std::unique_ptr<Panel> make_voxels_panel();

}  // namespace surefoot::playground
