/// The part of a triangle that was met, lit: all rooms show it alike.
#pragma once

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>

#include "view/renderer.hpp"

namespace surefoot::playground {

/// Lights the face, the edge or the corner of a triangle that was met.
void draw_feature(view::Renderer& renderer, const Triangle& triangle, const Hit& hit);

}  // namespace surefoot::playground
