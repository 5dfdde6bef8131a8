/// What GLFW's callbacks write: events in the order in which they came. Apart from the window, so that callbacks can be
/// called by a test.
#pragma once

#include <array>
#include <vector>

#include "view/input.hpp"

struct GLFWwindow;
struct GLFWgamepadstate;

namespace surefoot::view {

struct WindowEvents {
    std::vector<InputEvent> waiting;
    dvec2 pointer{0, 0};
    Modifiers held{};

    void key(int key, int action, int mods);
    void character(unsigned codepoint);
    void button(int button, int action, int mods);
    void move(double x, double y);
    void wheel(double x, double y);
    void drop(int count, const char* const* paths);
    void resize(const ivec2& size, const ivec2& framebuffer);
    void focus(bool focused);
    void scale(double factor);
    void close();

    /// What a gamepad's buttons and sticks are at; whatever is otherwise than the last time is an event. Null: there is
    /// none, and nothing is held any more.
    void gamepad(const GLFWgamepadstate* state);

private:
    void keep(int mods);
    bool moved_before_ = false;
    std::array<bool, static_cast<std::size_t>(PadButton::count)> pad_buttons_{};
    std::array<double, static_cast<std::size_t>(PadAxis::count)> pad_axes_{0, 0, 0, 0, -1, -1};
};

/// Makes a window write into the WindowEvents that its user pointer points at.
void set_callbacks(GLFWwindow* window);

/// A code point as UTF-8; empty for what is none.
[[nodiscard]] std::string utf8(unsigned codepoint);

}  // namespace surefoot::view
