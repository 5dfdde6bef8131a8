// Exact nearest points between a triangle and the origin, as the offset from the triangle to the origin. Offsets are
// kept as a numerator over a positive denominator, squared distances likewise, so that nothing is divided. The regions
// are those of Ericson, "Real-Time Collision Detection" (2005), 5.1.5.
#pragma once

#include "exact/vector.hpp"

namespace surefoot::internal {

template <typename Number>
struct ExactOffset {
    ExactVec<Number> direction;  ///< from the nearest point of the triangle to the origin, times something positive
    Number squared_numerator;    ///< squared distance, times `squared_denominator`
    Number squared_denominator;  ///< > 0

    [[nodiscard]] bool nearer_than(const ExactOffset& other) const noexcept {
        return compare(squared_numerator * other.squared_denominator, other.squared_numerator * squared_denominator) <
               0;
    }
};

template <typename Number>
ExactOffset<Number> offset_from_point(const ExactVec<Number>& point) noexcept {
    return {-point, dot(point, point), Number(1.0)};
}

template <typename Number>
ExactOffset<Number> offset_from_segment(const ExactVec<Number>& a, const ExactVec<Number>& b) noexcept {
    const ExactVec<Number> edge = b - a;
    const Number squared = dot(edge, edge);
    const Number share = -dot(a, edge);
    if (share.sign() <= 0) return offset_from_point(a);
    if (compare(share, squared) >= 0) return offset_from_point(b);
    const ExactVec<Number> across = cross(a, edge);
    return {-(a * squared + edge * share), dot(across, across), squared};
}

template <typename Number>
ExactOffset<Number> offset_from_triangle(const ExactVec<Number>& a, const ExactVec<Number>& b,
                                         const ExactVec<Number>& c) noexcept {
    const ExactVec<Number> normal = cross(b - a, c - a);
    if (!is_zero(normal)) {
        // Above the face when the origin is on the inner side of all three edges.
        const bool inside_ab = dot(cross(b - a, -a), normal).sign() >= 0;
        const bool inside_bc = dot(cross(c - b, -b), normal).sign() >= 0;
        const bool inside_ca = dot(cross(a - c, -c), normal).sign() >= 0;
        if (inside_ab && inside_bc && inside_ca) {
            const Number height = -dot(normal, a);
            return {normal * height, height * height, dot(normal, normal)};
        }
    }
    // Else the nearest point is on an edge; for a triangle without area, always.
    ExactOffset<Number> best = offset_from_segment(a, b);
    const ExactOffset<Number> on_bc = offset_from_segment(b, c);
    if (on_bc.nearer_than(best)) best = on_bc;
    const ExactOffset<Number> on_ca = offset_from_segment(c, a);
    if (on_ca.nearer_than(best)) best = on_ca;
    return best;
}

}  // namespace surefoot::internal
