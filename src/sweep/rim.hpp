// The rim of a cylinder's or cone's flat end against an edge: where the line of the edge crosses the plane of the rim
// is a point that moves linearly in that plane, so the touch is a point meeting a circle, a quadratic. The normal there
// is perpendicular to the edge, and its sideways part points from the crossing to the centre of the rim.
//
// With e the edge and e.y its climb, the crossing moves along G / e.y, G = along_h e.y - along.y e_h. Everything is
// kept multiplied by e.y, so that an edge nearly parallel to the plane, whose crossing races away, loses no digits.
#pragma once

#include "sweep/query.hpp"
#include "sweep/round_features.hpp"

namespace surefoot::internal {

/// `point` is relative to the centre of the rim at `from`, `edge` the direction of the line. Nothing for an edge
/// parallel to the plane of the rim: it meets the end's flat or the side first. `hairs` the rounding in the edge's
/// numbers [m].
[[nodiscard]] RoundNormals rim_against_line(const Vec& point, const Vec& edge, const Vec& along, double radius,
                                            const Hairs& hairs) noexcept;

}  // namespace surefoot::internal
