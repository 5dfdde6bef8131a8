/// The panel in which a question is typed: world, shape, sizes, places, sides; undo, copy and paste.
#pragma once

#include <optional>
#include <string>

#include <surefoot/math.hpp>

#include "playground/debugger_room/investigation.hpp"

namespace surefoot::playground {

class QuestionPanel {
public:
    /// What the user asked for that is not the panel's to do.
    struct Wishes {
        bool open = false;  ///< a file
        bool copy = false;
        bool paste = false;
        bool framed = false;  ///< another world is to be looked at
    };

    [[nodiscard]] Wishes ui(Investigation& asked);

    double grid = 0.5;  ///< what Shift snaps to [m]

private:
    void shape_rows(Investigation& asked);
    void turn_row(Investigation& asked);
    void place_rows(Investigation& asked);

    // Euler's angles as they were typed, and the quaternion that they stand for: its own angles may be others.
    dvec3 angles_{0, 0, 0};
    dquat turned_{1, 0, 0, 0};
};

}  // namespace surefoot::playground
