/// The change of space in which an ellipsoid is a ball, as a map that can stop half way, to be watched.
#pragma once

#include <glm/mat3x3.hpp>

#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

namespace surefoot::debugger {

/// Has this shape a squashed space at all? Sphere and ellipsoid have.
[[nodiscard]] bool is_squashable(const Shape& shape);

/// The half axes of a sphere or an ellipsoid; {1, 1, 1} for the others, which are not squashed.
[[nodiscard]] dvec3 radii_of(const Shape& shape);

/// A vector of the world, in the shape's own frame, divided by the radii.
[[nodiscard]] dvec3 squashed(const Volume& volume, const dvec3& vector);
/// And back.
[[nodiscard]] dvec3 unsquashed(const Volume& volume, const dvec3& vector);

/// A linear map about a point that stays where it is.
struct Squash {
    glm::dmat3 map{1};
    dvec3 pivot{0, 0, 0};           ///< stays where it is [m]
    dvec3 radii{1, 1, 1};           ///< of the mapped ellipsoid
    dquat orientation{1, 0, 0, 0};  ///< of the mapped ellipsoid; unit

    [[nodiscard]] dvec3 vector(const dvec3& v) const { return map * v; }
    [[nodiscard]] dvec3 point(const dvec3& p) const { return pivot + map * (p - pivot); }
    [[nodiscard]] Triangle triangle(const Triangle& t) const { return {point(t.a), point(t.b), point(t.c)}; }
    [[nodiscard]] Motion motion(const Motion& m) const { return {point(m.from), point(m.to)}; }
    /// Where the normal of a plane goes, unit: not where a vector goes, but by the inverse transposed.
    [[nodiscard]] dvec3 normal(const dvec3& n) const;
};

/// The map at `s`: the world as it is at 0, the squashed space (the shape's own axes, the ball of radius 1) at 1, and
/// between them lengths along each of the shape's axes divided by radius^s while the axes turn towards the shape's.
/// Requires: 0 <= s <= 1.
[[nodiscard]] Squash squash_at(const Volume& volume, double s, const dvec3& pivot = {0, 0, 0});

}  // namespace surefoot::debugger
