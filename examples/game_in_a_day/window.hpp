// A window, if there is a display and the program was built with one.
#pragma once

#include <memory>

#include "scene.hpp"

namespace day {

// [window]
struct Keys {
    double north = 0, east = 0;  // as the camera sees it: -1 to 1
    double turn = 0, tilt = 0;   // of the camera
    bool jump = false, save = false, restart = false;
};

class Window {
public:
    static std::unique_ptr<Window> open();  // null without a display
    virtual ~Window() = default;
    virtual bool poll(Keys& keys) = 0;  // false: it was closed
    [[nodiscard]] virtual double width_by_height() const = 0;
    virtual void show(const Scene& scene, const std::string& title) = 0;
};
// [/window]

}  // namespace day
