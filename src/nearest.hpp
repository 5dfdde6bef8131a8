// Nearest points, in doubles.
#pragma once

#include "vec.hpp"

namespace surefoot::internal {

[[nodiscard]] Vec nearest_on_segment(const Vec& point, const Vec& a, const Vec& b) noexcept;
[[nodiscard]] Vec nearest_on_triangle(const Vec& point, const Vec (&corners)[3]) noexcept;

/// The point of the triangle that is nearest to the segment; of several, one in their middle where the segment lies
/// along the triangle.
[[nodiscard]] Vec nearest_on_triangle_to_segment(const Vec& from, const Vec& to, const Vec (&corners)[3]) noexcept;

}  // namespace surefoot::internal
