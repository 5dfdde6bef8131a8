/// The room Course: any scene of the movement course, walked by our character at its real speed, beside the ghost of
/// another mover.
#pragma once

#include <memory>

#include "playground/room.hpp"

namespace surefoot::playground {

[[nodiscard]] std::unique_ptr<Room> make_course();

}  // namespace surefoot::playground
