// A display that is a GLFW window. Its callbacks do nothing but write events.
#include <epoxy/gl.h>
// After epoxy, which it would otherwise bring another OpenGL header to.
#include <GLFW/glfw3.h>
#include <algorithm>
#include <cstdlib>

#include "view/display.hpp"
#include "view/window_events.hpp"

namespace surefoot::view {
namespace {

std::string& last_words() {
    static std::string words;
    return words;
}

class Window final : public Display {
public:
    explicit Window(GLFWwindow* window) : window_(window) {
        glfwSetWindowUserPointer(window, &events_);
        set_callbacks(window);
        measure();
        float x = 1;
        float y = 1;
        glfwGetWindowContentScale(window, &x, &y);
        content_scale_ = x;
        set_scale();
    }

    ~Window() override {
        glfwDestroyWindow(window_);
        glfwTerminate();
    }

    void poll(std::vector<InputEvent>& events, double seconds) override {
        if (seconds > 0) {
            // A gamepad wakes nobody: it has to be asked.
            constexpr double asked_every = 1.0 / 60;  // [s]
            glfwWaitEventsTimeout(first_gamepad() >= 0 ? std::min(seconds, asked_every) : seconds);
        } else {
            glfwPollEvents();
        }
        GLFWgamepadstate pad;
        const int first = first_gamepad();
        events_.gamepad(first >= 0 && glfwGetGamepadState(first, &pad) == GLFW_TRUE ? &pad : nullptr);
        for (const InputEvent& event : events_.waiting) {
            if (const auto* const change = std::get_if<ScaleChange>(&event)) content_scale_ = change->scale;
        }
        measure();
        set_scale();
        events.insert(events.end(), events_.waiting.begin(), events_.waiting.end());
        events_.waiting.clear();
    }

    void present() override { glfwSwapBuffers(window_); }

    void set_full_screen(bool full) override {
        if (full == full_screen_) return;
        full_screen_ = full;
        if (full) {
            glfwGetWindowPos(window_, &windowed_at_.x, &windowed_at_.y);
            windowed_size_ = size_;
            GLFWmonitor* const monitor = glfwGetPrimaryMonitor();
            const GLFWvidmode* const mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
            if (mode != nullptr)
                glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
        } else {
            glfwSetWindowMonitor(window_, nullptr, windowed_at_.x, windowed_at_.y, windowed_size_.x, windowed_size_.y,
                                 GLFW_DONT_CARE);
        }
    }

    void capture_pointer(bool captured) override {
        captured_ = captured;
        glfwSetInputMode(window_, GLFW_CURSOR, captured ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
    }

    [[nodiscard]] std::string clipboard() const override {
        const char* const text = glfwGetClipboardString(window_);
        return text == nullptr ? std::string() : std::string(text);
    }
    void set_clipboard(const std::string& text) override { glfwSetClipboardString(window_, text.c_str()); }
    void resize(const ivec2& size) override { glfwSetWindowSize(window_, size.x, size.y); }

private:
    /// The lowest number of a gamepad, or -1.
    static int first_gamepad() {
        for (int i = GLFW_JOYSTICK_1; i <= GLFW_JOYSTICK_LAST; ++i)
            if (glfwJoystickIsGamepad(i) == GLFW_TRUE) return i;
        return -1;
    }

    void measure() {
        glfwGetWindowSize(window_, &size_.x, &size_.y);
        glfwGetFramebufferSize(window_, &framebuffer_size_.x, &framebuffer_size_.y);
    }
    // Some systems count windows in pixels and want larger letters, others count in units of several pixels.
    void set_scale() {
        const double ratio = size_.x > 0 ? double(framebuffer_size_.x) / size_.x : 1;
        scale_ = ratio > 0 ? content_scale_ / ratio : 1;
    }

    GLFWwindow* window_;
    WindowEvents events_;
    double content_scale_ = 1;
    ivec2 windowed_at_{0, 0};
    ivec2 windowed_size_{1280, 720};
};

GLFWwindow* make_window(const DisplayOptions& options, bool es) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_CLIENT_API, es ? GLFW_OPENGL_ES_API : GLFW_OPENGL_API);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, es ? 0 : 3);
    if (!es) {
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    }
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);  // the renderer keeps depth in a framebuffer of its own
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    return glfwCreateWindow(options.size.x, options.size.y, options.title.c_str(), nullptr, nullptr);
}

}  // namespace

Expected<std::unique_ptr<Display>> open_window(const DisplayOptions& options) {
    glfwSetErrorCallback([](int /*code*/, const char* words) { last_words() = words; });
    const auto failed = [](const char* advice) {
        return tl::unexpected(
            Error{ErrorCode::unsupported, "no window can be opened (" + last_words() + "): " + advice, {}, 0});
    };
    if (glfwInit() == GLFW_FALSE) return failed("is there a display? --headless draws without one");
    GLFWwindow* window = nullptr;
    if (options.api != GlApi::es) window = make_window(options, false);
    if (window == nullptr && options.api != GlApi::core) window = make_window(options, true);
    if (window == nullptr) {
        glfwTerminate();
        return failed("OpenGL 3.3 or OpenGL ES 3.0 is needed; LIBGL_ALWAYS_SOFTWARE=1 takes Mesa's software renderer");
    }
    glfwMakeContextCurrent(window);
    glfwSwapInterval(1);
    return std::make_unique<Window>(window);
}

}  // namespace surefoot::view
