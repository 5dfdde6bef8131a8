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
///  - sphere and capsule: the shortest there is (for a pierced capsule core: out through the nearest face of the prism
///    that the triangle and the core make);
///  - box: the shortest there is, over its 13 axes;
///  - ellipsoid: the shortest in squashed space, carried back: at most r_max / r_min times the shortest;
///  - cylinder and cone: see docs/method.md for the bound.
///
/// Guarantees: allocates nothing; data outside the limits answer with status `invalid`, zero normal and zero depth.
[[nodiscard]] std::optional<Overlap> overlap(const Volume& volume, const dvec3& position, const Triangle& triangle,
                                             const OverlapOptions& options = {}) noexcept;

}  // namespace v0
}  // namespace surefoot
