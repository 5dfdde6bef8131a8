/// The room Debugger: one question, taken by the hand.
#pragma once

#include <memory>

#include "playground/room.hpp"

namespace surefoot::playground {

[[nodiscard]] std::unique_ptr<Room> make_debugger();

}  // namespace surefoot::playground
