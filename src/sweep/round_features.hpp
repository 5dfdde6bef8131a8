// The closed forms for a ball that moves along a line: against a point (a vertex), and against an infinite line (an
// edge). Both are the same picture, seen along the motion or along the edge: a disc passes a point.
//
//           u = direction of motion, perpendicular to the edge
//      ---------->                 w = from the feature to the closest approach of the line of motion, |w| its distance
//            |w                    entry normal: w - h u,  exit normal: w + h u,  h = sqrt(R^2 - |w|^2)
//            o feature             |w| >= R: the line passes by, and w itself separates
//
// Solving for the normal instead of for t keeps all digits: no b^2 - 4 a c, in which a grazing motion loses half of
// them. R is the radius inflated by a hair, so that a motion that barely touches still meets it at an angle that
// doubles can hold.
#pragma once

#include "sweep/query.hpp"

namespace surefoot::internal {

/// The normals that a passing ball proposes: the entry and the exit, or the closest approach alone.
struct RoundNormals {
    Vec first;   ///< entry, or closest approach
    Vec second;  ///< exit, or zero
};

/// `point` relative to the ball's centre at `from`; `along` its motion; all in a space where the ball is round.
[[nodiscard]] RoundNormals ball_against_point(const Vec& point, const Vec& along, double radius) noexcept;

/// The same against the infinite line through `point` along `direction`.
[[nodiscard]] RoundNormals ball_against_line(const Vec& point, const Vec& direction, const Vec& along,
                                             double radius) noexcept;

}  // namespace surefoot::internal
