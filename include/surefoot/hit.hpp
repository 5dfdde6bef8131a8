/// The answer to "do I hit something moving from A to B, and where?"
#pragma once

#include <cstdint>
#include <type_traits>

#include <surefoot/math.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// Which part of the triangle was met.
enum class Feature : std::uint8_t { face, edge, vertex };

/// Whether an answer can be trusted. A query that cannot be answered is not a free pass: it blocks at t = 0 and says
/// so.
enum class HitStatus : std::uint8_t {
    ok,        ///< an answer
    invalid,   ///< the input was outside the stated limits (NaN, infinity, a zero radius): blocked
    overflow,  ///< a stated bound on the work was exceeded: blocked
};

/// The first touch of a moving shape. Where a shape starts so deep in a triangle that the part of it that must be left
/// behind is outside the shape, `point` is the deepest point of the triangle instead of a point of that part.
struct Hit {
    double t = 0;                      ///< time of first touch [0 at `from`, 1 at `to`]
    dvec3 point{0, 0, 0};              ///< a point of the triangle where they touch [m]
    dvec3 normal{0, 0, 0};             ///< unit, in the world, from what was hit towards the shape; zero if not `ok`
    std::uint32_t triangle = 0;        ///< which triangle of the mesh; 0 for a query against one triangle
    std::uint32_t surface = 0;         ///< what that triangle is made of; 0 if nothing was said
    std::uint32_t body = 0;            ///< which body of the world; 0 for a query against a mesh or one triangle
    Feature feature = Feature::face;   ///< the part of the triangle that was met
    HitStatus status = HitStatus::ok;  ///< anything but `ok` blocks the move at t = 0
    bool started_inside = false;       ///< already touching or overlapping at `from`, and going deeper; t is 0
};

static_assert(std::is_trivially_copyable_v<Hit> && sizeof(Hit) == 72);

}  // namespace v0
}  // namespace surefoot
