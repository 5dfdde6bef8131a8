/// Draws one entry of a menu.
#pragma once

#include "platformer/screens/arrange.hpp"
#include "platformer/screens/palette.hpp"
#include "platformer/screens/screens.hpp"

namespace surefoot::platformer {

struct EntryLook {
    const Palette& palette;
    bool focused = false;
    double pulse = 0;  ///< of the frame about what is in focus [0 to 1]
};

void draw_entry(view::Canvas& canvas, const Screens& screens, const Entry& entry, const view::Rect& place,
                const EntryLook& look);

}  // namespace surefoot::platformer
