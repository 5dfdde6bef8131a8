// Built without GLFW: there is no window.
#include "window.hpp"

namespace day {

std::unique_ptr<Window> Window::open() {
    return nullptr;
}

}  // namespace day
