/// The platformer as a room, and as the only room of a program of its own.
#pragma once

#include <memory>

#include "playground/room.hpp"

namespace surefoot::playground {

[[nodiscard]] std::unique_ptr<Room> make_platformer();

}  // namespace surefoot::playground
