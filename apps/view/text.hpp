/// Labels at places of the world, drawn by the widgets' letters so that they stay crisp.
#pragma once

#include <functional>
#include <span>

#include "view/renderer.hpp"

namespace surefoot::view {

/// Does something stand between the eye and this place?
using Hidden = std::function<bool(const dvec3& place)>;

/// Where a label lies on the picture.
struct LabelBox {
    Area area;
    bool yields = false;
};

/// Moves those that yield up or down, by as little as brings them clear of all before them and of all that do not
/// yield; who finds no such place nearby stays.
void step_aside(std::span<LabelBox> boxes);

/// Draws the labels behind all panels, the farthest first. The nearest ones are the last to step aside.
void draw_labels(const FrameView& view, std::span<const Label> labels, const Hidden& hidden = {});

}  // namespace surefoot::view
