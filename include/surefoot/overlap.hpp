/// The static question: does a shape, standing still, touch or overlap this triangle, and which way is out?
///
/// A triangle is a surface, not a solid: "out" means out of that one triangle, on the side that is nearer.
#pragma once

#include <optional>
#include <type_traits>

#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// How a shape overlaps a triangle. Moving the shape by `normal * depth` brings it out, just touching.
struct Overlap {
    dvec3 point{0, 0, 0};             ///< the point of the triangle that lies deepest in the shape [m]
    dvec3 normal{0, 0, 0};            ///< unit, in the world: the way out for the shape; zero if not `ok`
    double depth = 0;                 ///< how far to move along `normal` [m, >= 0]; 0 is just touching
    std::uint32_t triangle = 0;       ///< which triangle of the mesh; 0 for a query against one triangle
    std::uint32_t surface = 0;        ///< what that triangle is made of; 0 if nothing was said
    std::uint32_t body = 0;           ///< which body of the world; 0 for a query against a mesh or one triangle
    Feature feature = Feature::face;  ///< the part of the triangle that holds `point`
    HitStatus status = HitStatus::ok;
};

static_assert(std::is_trivially_copyable_v<Overlap> && sizeof(Overlap) == 72);

struct OverlapOptions {
    /// A one-sided triangle exists only for a reference point that is not behind its plane. A triangle without area has
    /// no plane to be behind.
    bool one_sided = false;
};

/// Does `volume` at `position` touch `triangle`, and which way is out?
///
/// How short the way out is, by shape:
///  - sphere, capsule, box, cylinder, cone: the shortest there is, to rounding (for a pierced capsule core that is out
///    through the nearest face of the prism that the triangle and the core make; for a box over its 13 axes);
///  - ellipsoid: the shortest in squashed space, carried back: at most r_max / r_min times the shortest.
///
/// Touching counts, and rounding is given the benefit of the doubt: a gap of up to 2^-44 of the largest of the
/// distances from the reference point to the corners and the shape's own size (for an ellipsoid both squashed) still
/// touches, with depth 0. A reference point on the triangle's plane that may leave by either side leaves by the front.
///
/// Guarantees: allocates nothing; data outside the limits answer with status `invalid`, zero normal and zero depth; the
/// corners in any order of the same winding give the same bits. docs/overlap.md has the formulas and their reasons.
[[nodiscard]] std::optional<Overlap> overlap(const Volume& volume, const dvec3& position, const Triangle& triangle,
                                             const OverlapOptions& options = {}) noexcept;

}  // namespace v0
}  // namespace surefoot
