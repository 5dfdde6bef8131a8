/// The room Walk: any level, seen from everywhere, with all that is known about it.
#pragma once

#include <memory>

#include "playground/room.hpp"

namespace surefoot::playground {

[[nodiscard]] std::unique_ptr<Room> make_walk();

}  // namespace surefoot::playground
