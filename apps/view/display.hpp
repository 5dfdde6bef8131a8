/// Where frames appear: a window, or an off-screen framebuffer on machines without a display. Either owns the one
/// OpenGL context, which is current on the thread that opened it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <surefoot/error.hpp>

#include "view/input.hpp"

namespace surefoot::view {

enum class GlApi : std::uint8_t {
    any,   ///< OpenGL 3.3 core if there is one, else OpenGL ES 3.0
    core,  ///< OpenGL 3.3 core
    es,    ///< OpenGL ES 3.0
};

struct DisplayOptions {
    std::string title = "Surefoot";
    ivec2 size{1280, 720};  ///< in window units [1 to 16384 each]
    bool headless = false;  ///< draw into memory; no display is asked for
    GlApi api = GlApi::any;
    double scale = 1;  ///< of letters, headless only: a window asks its system [0.5 to 4]
};

class Display {
public:
    /// Fails with `unsupported` where there is no display or no OpenGL that is new enough; the text says what to do.
    [[nodiscard]] static Expected<std::unique_ptr<Display>> open(const DisplayOptions& options);

    Display() = default;
    Display(const Display&) = delete;
    Display& operator=(const Display&) = delete;
    virtual ~Display() = default;

    /// Appends what happened since the last call; waits for something to happen for up to `seconds`.
    virtual void poll(std::vector<InputEvent>& events, double seconds) = 0;

    /// Shows what was drawn into `framebuffer`.
    virtual void present() = 0;

    virtual void set_full_screen(bool full) = 0;

    /// Hides the pointer and keeps it in the window, so that it can turn a camera without end.
    virtual void capture_pointer(bool captured) = 0;

    [[nodiscard]] virtual std::string clipboard() const = 0;
    virtual void set_clipboard(const std::string& text) = 0;

    /// In window units, and in pixels.
    [[nodiscard]] ivec2 size() const { return size_; }
    [[nodiscard]] ivec2 framebuffer_size() const { return framebuffer_size_; }

    /// How large letters should be, in window units.
    [[nodiscard]] double scale() const { return scale_; }

    /// The framebuffer object to draw into.
    [[nodiscard]] unsigned framebuffer() const { return framebuffer_; }

    /// Wide and high change by the script of a headless run; a window is told by its system.
    virtual void resize(const ivec2& size) = 0;

    [[nodiscard]] bool is_full_screen() const { return full_screen_; }
    [[nodiscard]] bool is_pointer_captured() const { return captured_; }

protected:
    ivec2 size_{0, 0};
    ivec2 framebuffer_size_{0, 0};
    double scale_ = 1;
    unsigned framebuffer_ = 0;
    bool full_screen_ = false;
    bool captured_ = false;
};

/// "OpenGL 3.3 (core), llvmpipe ...", for the about box and for messages.
[[nodiscard]] std::string gl_description();

/// Is it a renderer without a graphics card, for which effects are dear?
[[nodiscard]] bool gl_is_software();

[[nodiscard]] Expected<std::unique_ptr<Display>> open_window(const DisplayOptions& options);
[[nodiscard]] Expected<std::unique_ptr<Display>> open_headless(const DisplayOptions& options);

}  // namespace surefoot::view
