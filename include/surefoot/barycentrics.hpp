/// Where on its triangle a point lies, as weights of the corners: to interpolate what the corners carry (texture
/// coordinates, colours, the friction of a painted floor) at a hit.
#pragma once

#include <surefoot/math.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// The weights of a, b and c for the point of the triangle that is nearest to `point`; a hit's `point` is its own
/// nearest. Each is in [0, 1], their sum is 1 to rounding, and x * a + y * b + z * c is the point, to rounding.
/// Of a triangle without area, the weights are those on the longest of its edges; of one without length, {1, 0, 0}.
/// NaN or infinity anywhere gives {1, 0, 0}.
[[nodiscard]] dvec3 barycentrics(const dvec3& point, const Triangle& triangle) noexcept;

}  // namespace v0
}  // namespace surefoot
