/// What a candidate of the classic test, or a plane of the library's own, is about: lit in the world.
#pragma once

#include <surefoot/hit.hpp>

#include "debugger/plane_table.hpp"
#include "playground/debugger_room/drawn_world.hpp"
#include "view/renderer.hpp"

namespace surefoot::playground {

[[nodiscard]] view::Colour colour_of(Feature feature);

/// All places of the centre at which the shape would touch this feature's plane, line or corner: the plane one radius
/// above the triangle's, the cylinder around the edge, the ball around the corner, each as it is in this world.
/// `volume` is the real shape. Requires: a sphere or an ellipsoid.
void light_feature(view::Renderer& renderer, const DrawnWorld& world, const Volume& volume, const dvec3& start,
                   const Triangle& triangle, Feature feature, std::uint8_t index);

/// A plane between the shape and the triangle, in the real world, where it touches the triangle.
void light_plane(view::Renderer& renderer, const Volume& volume, const dvec3& position, const Triangle& triangle,
                 const dvec3& normal, view::Colour colour);

}  // namespace surefoot::playground
