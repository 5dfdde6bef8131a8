/// Dear ImGui 1.86 between the stream of events and the screen. There is one at a time.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "view/display.hpp"
#include "view/input.hpp"

namespace surefoot::view {

class ImGuiAdapter {
public:
    explicit ImGuiAdapter(Display& display);
    ImGuiAdapter(const ImGuiAdapter&) = delete;
    ImGuiAdapter& operator=(const ImGuiAdapter&) = delete;
    ~ImGuiAdapter();

    /// Hands an event over; true if it is the widgets' and nobody else's. What began in the world stays the world's: a
    /// drag that leaves over a panel, a key that is let go.
    bool event(const InputEvent& event);

    void begin_frame(double dt);

    /// No widget comes after this in the frame.
    void end_frame();

    /// Draws the widgets of the frame that ended last into the framebuffer that is bound.
    void paint();

    /// Does a widget want the text that is typed?
    [[nodiscard]] bool wants_text() const;
    [[nodiscard]] bool wants_pointer() const;

private:
    void load_fonts(double scale);

    Display& display_;
    double font_scale_ = 0;
    double pixel_ratio_ = 0;
    std::array<bool, 3> pressed_now_{};  // in this frame: a click shorter than a frame must not be lost
    std::array<bool, 3> down_{};
    std::array<bool, 3> worlds_{};  // a press that was not the widgets'
};

}  // namespace surefoot::view
