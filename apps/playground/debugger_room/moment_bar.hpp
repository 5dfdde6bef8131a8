/// The bar with the answer in a line and the moment of the motion that is looked at.
#pragma once

#include "playground/debugger_room/investigation.hpp"

namespace surefoot::playground {

/// What is looked at, and whether time passes.
struct Clock {
    double& t;  ///< [0, 1]
    bool& runs;

    /// Lets the motion run, from START if it is at its end, or stops it.
    void toggle() const {
        runs = !runs;
        if (runs && t >= 1) t = 0;
    }
};

/// The widgets, at the bottom of the window between these places [window units].
void moment_bar(const Investigation& asked, const Clock& clock, double left, double right);

}  // namespace surefoot::playground
