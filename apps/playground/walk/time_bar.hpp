/// The bar below a character: what it does, why it stopped last, and time: pause, single steps, slow motion, going
/// back.
#pragma once

#include <functional>
#include <string>

#include "playground/walk/walker.hpp"

namespace surefoot::playground {

/// What time does; the keys do the same as the buttons.
void toggle_pause(Walker& walker);
void step_back(Walker& walker);

/// The widgets, at the bottom of the window between these places [window units]; `step` is called for one step.
void time_bar(Walker& walker, bool why, double left, double right, const std::function<void()>& step);

/// "on ground, 4.00 m/s; stepped up": the state that is looked at and the events of the step that led there.
[[nodiscard]] std::string state_text(const Walker& walker);

}  // namespace surefoot::playground
