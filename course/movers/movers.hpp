/// How each mover that comes with the course is made.
#pragma once

#include <memory>

#include "course/mover.hpp"
#include "course/movers/textbook.hpp"

namespace surefoot::course {

[[nodiscard]] std::unique_ptr<Mover> make_ours();
[[nodiscard]] std::unique_ptr<Mover> make_textbook(const Faults& faults);
[[nodiscard]] std::unique_ptr<Mover> make_bullet();

}  // namespace surefoot::course
