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
// doubles can hold. Within that hair of grazing all three normals are proposed: the plane of w may yet prove a miss.
#pragma once

#include "sweep/query.hpp"

namespace surefoot::internal {

/// The normals that a passing ball proposes; zero where there is none.
struct RoundNormals {
    Vec entry;
    Vec exit;
    Vec passing;        ///< at the closest approach
    Vec grazing_entry;  ///< entry and exit of a feature inflated by the triangle's hair
    Vec grazing_exit;
};

/// A ball in the space where it is round: the world divided by `squash`.
struct Ball {
    double radius = 1;
    Hairs hairs;  ///< in the world
    Vec squash{1, 1, 1};
};

/// The normals of a pass: `closest` points from the feature to the closest approach, `onward` is the unit direction of
/// motion perpendicular to it, `hairs` how much the radius is inflated.
[[nodiscard]] RoundNormals normals_of_pass(const Vec& closest, const Vec& onward, double radius,
                                           const Hairs& hairs) noexcept;

/// `point` relative to the ball's centre at `from`; `along` its motion; all in the ball's space.
[[nodiscard]] RoundNormals ball_against_point(const Vec& point, const Vec& along, const Ball& ball) noexcept;

/// The same against the infinite line through `point` along `direction`.
[[nodiscard]] RoundNormals ball_against_line(const Vec& point, const Vec& direction, const Vec& along,
                                             const Ball& ball) noexcept;

}  // namespace surefoot::internal
