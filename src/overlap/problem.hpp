// The static question as the shapes are asked it: one triangle in the shape's own frame, relative to its reference
// point. Everything below works on differences of the input, so distance from the world's origin costs nothing.
#pragma once

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

#include "exact/products.hpp"
#include "frame.hpp"
#include "vec.hpp"

namespace surefoot::internal {

/// A gap or a depth up to this part of the largest distance in the question is rounding: such shapes touch. Turning,
/// subtracting and projecting three coordinates leaves an error of about 20 * 2^-53; this is thirty times that.
inline constexpr double touching_hair = 0x1p-44;

struct TriangleProblem {
    Vec corner[3];  ///< relative to the reference point, in an order that does not depend on the caller's
    Vec edge[3];    ///< from corner i to corner i + 1, from the input's own difference: short edges keep their digits
    Vec normal;     ///< unit, to the front; for no area some unit vector across the longest edge
    double winding = 1;  ///< 1 if the corners go counter-clockwise when seen from the front, -1 if clockwise
    double scale = 0;    ///< the largest of the corners' components [m]
};

/// The corners in an order of their own, so that the caller's order changes no bit of the answer but the front.
struct OrderedTriangle {
    Vec corner[3];  ///< in the world
    bool mirrored = false;
};

[[nodiscard]] OrderedTriangle ordered(const Triangle& triangle) noexcept;

/// The triangle in the frame of a shape that stands at `position`.
[[nodiscard]] TriangleProblem seen_by(const Frame& frame, const OrderedTriangle& world, const Vec& position) noexcept;

/// How to get out: the least depth over all directions that were considered.
struct WayOut {
    Vec normal;                       ///< unit
    double depth = 0;                 ///< may be negative: the gap
    Vec point;                        ///< of the triangle
    int corner = -1;                  ///< which corner `point` is, if it is one
    Feature feature = Feature::face;  ///< of the triangle
    bool touches = false;
};

WayOut overlap_sphere(const Sphere& shape, const TriangleProblem& triangle) noexcept;
WayOut overlap_ellipsoid(const Ellipsoid& shape, const TriangleProblem& triangle) noexcept;
WayOut overlap_capsule(const Capsule& shape, const TriangleProblem& triangle) noexcept;
WayOut overlap_box(const Box& shape, const TriangleProblem& triangle) noexcept;
WayOut overlap_cylinder(const Cylinder& shape, const TriangleProblem& triangle) noexcept;
WayOut overlap_cone(const Cone& shape, const TriangleProblem& triangle) noexcept;

/// The part of `v` across `axis`, times |axis|^2 or so; keeps its direction when `v` is nearly along `axis`.
inline Vec across(const Vec& v, const Vec& axis) noexcept {
    return cross(accurate_cross(axis, v), axis);
}

/// Which corners are farthest along `normal`, to within `hair`: the whole face, one edge or one corner.
struct FarthestFeature {
    Feature feature = Feature::vertex;
    int index = 0;  ///< of the edge or the corner
};
FarthestFeature farthest_along(const TriangleProblem& triangle, const Vec& normal, double hair) noexcept;

}  // namespace surefoot::internal
