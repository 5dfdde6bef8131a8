#include "view/window_events.hpp"

#include <GLFW/glfw3.h>
#include <cmath>

namespace surefoot::view {
namespace {

Key key_of(int key) {
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return static_cast<Key>(static_cast<int>(Key::a) + key - GLFW_KEY_A);
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9)
        return static_cast<Key>(static_cast<int>(Key::digit_0) + key - GLFW_KEY_0);
    if (key >= GLFW_KEY_F1 && key <= GLFW_KEY_F12)
        return static_cast<Key>(static_cast<int>(Key::f1) + key - GLFW_KEY_F1);
    switch (key) {
        case GLFW_KEY_SPACE:
            return Key::space;
        case GLFW_KEY_ENTER:
        case GLFW_KEY_KP_ENTER:
            return Key::enter;
        case GLFW_KEY_ESCAPE:
            return Key::escape;
        case GLFW_KEY_TAB:
            return Key::tab;
        case GLFW_KEY_BACKSPACE:
            return Key::backspace;
        case GLFW_KEY_DELETE:
            return Key::del;
        case GLFW_KEY_INSERT:
            return Key::insert;
        case GLFW_KEY_LEFT:
            return Key::left;
        case GLFW_KEY_RIGHT:
            return Key::right;
        case GLFW_KEY_UP:
            return Key::up;
        case GLFW_KEY_DOWN:
            return Key::down;
        case GLFW_KEY_HOME:
            return Key::home;
        case GLFW_KEY_END:
            return Key::end;
        case GLFW_KEY_PAGE_UP:
            return Key::page_up;
        case GLFW_KEY_PAGE_DOWN:
            return Key::page_down;
        case GLFW_KEY_LEFT_SHIFT:
        case GLFW_KEY_RIGHT_SHIFT:
            return Key::shift;
        case GLFW_KEY_LEFT_CONTROL:
        case GLFW_KEY_RIGHT_CONTROL:
        case GLFW_KEY_LEFT_SUPER:
        case GLFW_KEY_RIGHT_SUPER:
            return Key::control;  // a Mac's command key is what others' Control is
        case GLFW_KEY_LEFT_ALT:
        case GLFW_KEY_RIGHT_ALT:
            return Key::alt;
        case GLFW_KEY_MINUS:
        case GLFW_KEY_KP_SUBTRACT:
            return Key::minus;
        case GLFW_KEY_EQUAL:
        case GLFW_KEY_KP_ADD:
            return Key::equals;
        case GLFW_KEY_COMMA:
            return Key::comma;
        case GLFW_KEY_PERIOD:
            return Key::period;
        default:
            return Key::none;
    }
}

WindowEvents& events_of(GLFWwindow* window) {
    return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
}

}  // namespace

std::string utf8(unsigned codepoint) {
    std::string text;
    const auto put = [&](unsigned byte) { text.push_back(static_cast<char>(static_cast<unsigned char>(byte))); };
    if (codepoint < 0x80) {
        put(codepoint);
    } else if (codepoint < 0x800) {
        put(0xC0 | codepoint >> 6);
        put(0x80 | (codepoint & 0x3F));
    } else if (codepoint < 0x10000) {
        put(0xE0 | codepoint >> 12);
        put(0x80 | (codepoint >> 6 & 0x3F));
        put(0x80 | (codepoint & 0x3F));
    } else if (codepoint < 0x110000) {
        put(0xF0 | codepoint >> 18);
        put(0x80 | (codepoint >> 12 & 0x3F));
        put(0x80 | (codepoint >> 6 & 0x3F));
        put(0x80 | (codepoint & 0x3F));
    }
    return text;
}

void WindowEvents::keep(int mods) {
    held = {.shift = (mods & GLFW_MOD_SHIFT) != 0,
            .control = (mods & (GLFW_MOD_CONTROL | GLFW_MOD_SUPER)) != 0,
            .alt = (mods & GLFW_MOD_ALT) != 0};
}

void WindowEvents::key(int key, int action, int mods) {
    keep(mods);
    const Key named = key_of(key);
    if (named == Key::shift) held.shift = action != GLFW_RELEASE;
    if (named == Key::control) held.control = action != GLFW_RELEASE;
    if (named == Key::alt) held.alt = action != GLFW_RELEASE;
    if (named != Key::none) waiting.emplace_back(KeyPress{named, action != GLFW_RELEASE, action == GLFW_REPEAT, held});
}

void WindowEvents::character(unsigned codepoint) {
    waiting.emplace_back(TextInput{utf8(codepoint)});
}

void WindowEvents::button(int button, int action, int mods) {
    keep(mods);
    if (button > GLFW_MOUSE_BUTTON_MIDDLE) return;
    const MouseButton named = button == GLFW_MOUSE_BUTTON_LEFT    ? MouseButton::left
                              : button == GLFW_MOUSE_BUTTON_RIGHT ? MouseButton::right
                                                                  : MouseButton::middle;
    waiting.emplace_back(ButtonPress{named, action == GLFW_PRESS, pointer, held});
}

void WindowEvents::move(double x, double y) {
    const dvec2 at(x, y);
    const dvec2 by = moved_before_ ? at - pointer : dvec2(0, 0);
    moved_before_ = true;
    pointer = at;
    waiting.emplace_back(PointerMove{at, by, held});
}

void WindowEvents::wheel(double x, double y) {
    waiting.emplace_back(WheelTurn{{x, y}, pointer, held});
}

void WindowEvents::drop(int count, const char* const* paths) {
    FileDrop dropped;
    for (int i = 0; i < count; ++i) dropped.files.emplace_back(paths[i]);
    waiting.emplace_back(std::move(dropped));
}

void WindowEvents::resize(const ivec2& size, const ivec2& framebuffer) {
    waiting.emplace_back(Resize{size, framebuffer});
}

void WindowEvents::focus(bool focused) {
    if (!focused) held = {};
    waiting.emplace_back(FocusChange{focused});
}

void WindowEvents::scale(double factor) {
    waiting.emplace_back(ScaleChange{factor});
}

void WindowEvents::close() {
    waiting.emplace_back(CloseRequest{});
}

void WindowEvents::gamepad(const GLFWgamepadstate* state) {
    // Ours have the order of GLFW's.
    static_assert(static_cast<int>(PadButton::left) == GLFW_GAMEPAD_BUTTON_LAST &&
                  static_cast<int>(PadAxis::right_trigger) == GLFW_GAMEPAD_AXIS_LAST);
    for (std::size_t i = 0; i < pad_buttons_.size(); ++i) {
        const bool down = state != nullptr && state->buttons[i] == GLFW_PRESS;
        if (down == pad_buttons_[i]) continue;
        pad_buttons_[i] = down;
        waiting.emplace_back(GamepadButton{static_cast<PadButton>(i), down});
    }
    for (std::size_t i = 0; i < pad_axes_.size(); ++i) {
        const bool is_trigger = i >= static_cast<std::size_t>(PadAxis::left_trigger);
        const double raw = state != nullptr ? static_cast<double>(state->axes[i]) : is_trigger ? -1 : 0;
        constexpr double finest = 1.0 / 128;  // what a stick trembles by is no event
        const double value = std::round(raw / finest) * finest;
        if (value == pad_axes_[i]) continue;
        pad_axes_[i] = value;
        waiting.emplace_back(GamepadAxis{static_cast<PadAxis>(i), value});
    }
}

void set_callbacks(GLFWwindow* window) {
    glfwSetKeyCallback(window,
                       [](GLFWwindow* w, int key, int, int action, int mods) { events_of(w).key(key, action, mods); });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned codepoint) { events_of(w).character(codepoint); });
    glfwSetMouseButtonCallback(
        window, [](GLFWwindow* w, int button, int action, int mods) { events_of(w).button(button, action, mods); });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) { events_of(w).move(x, y); });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double x, double y) { events_of(w).wheel(x, y); });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) { events_of(w).drop(count, paths); });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int width, int height) {
        ivec2 size;
        glfwGetWindowSize(w, &size.x, &size.y);
        events_of(w).resize(size, {width, height});
    });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int focused) { events_of(w).focus(focused != 0); });
    glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float x, float) { events_of(w).scale(x); });
    glfwSetWindowCloseCallback(window, [](GLFWwindow* w) { events_of(w).close(); });
}

}  // namespace surefoot::view
