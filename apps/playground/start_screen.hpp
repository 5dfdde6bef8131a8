/// What is seen first: a still life of the six shapes, and a card for every room.
#pragma once

#include <functional>
#include <memory>
#include <string_view>

#include "playground/room.hpp"

namespace surefoot::playground {

[[nodiscard]] std::unique_ptr<Room> make_start_screen(std::function<void(std::string_view id)> choose);

}  // namespace surefoot::playground
