// The limits within which every promise holds. Beyond them a query is blocked and says `invalid`.
#pragma once

#include <surefoot/math.hpp>

#include "vec.hpp"

namespace surefoot::internal {

inline constexpr double largest_coordinate = 1e9;   // [m]
inline constexpr double smallest_dimension = 1e-6;  // [m]
inline constexpr double largest_dimension = 1e6;    // [m]
inline constexpr double largest_ratio = 1e4;

/// False for NaN and infinity too.
constexpr bool is_valid_point(const dvec3& p) noexcept {
    return absolute(p.x) <= largest_coordinate && absolute(p.y) <= largest_coordinate &&
           absolute(p.z) <= largest_coordinate;
}

constexpr bool is_valid_triangle(const Triangle& triangle) noexcept {
    return is_valid_point(triangle.a) && is_valid_point(triangle.b) && is_valid_point(triangle.c);
}

}  // namespace surefoot::internal
