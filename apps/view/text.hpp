/// Labels at places of the world, drawn by the widgets' letters so that they stay crisp.
#pragma once

#include <functional>
#include <span>

#include "view/renderer.hpp"

namespace surefoot::view {

/// Does something stand between the eye and this place?
using Hidden = std::function<bool(const dvec3& place)>;

/// Draws the labels behind all panels, the farthest first.
void draw_labels(const FrameView& view, std::span<const Label> labels, const Hidden& hidden = {});

}  // namespace surefoot::view
