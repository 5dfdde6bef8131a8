// The point of a triangle that is closest to a point or to a segment.
#pragma once

#include "overlap/problem.hpp"

namespace surefoot::internal {

struct ClosestPoint {
    Vec point;
    double distance = 1e300;
    int corner = -1;  ///< which corner it is, if it is one
    Feature feature = Feature::face;
};

/// The point at `t` of edge `edge`, with `t` clamped to the edge.
ClosestPoint point_of_edge(const TriangleProblem& triangle, int edge, double t) noexcept;

/// Is the foot of `p` on the plane within the triangle? Never for no area.
bool is_above_face(const TriangleProblem& triangle, const Vec& p) noexcept;

ClosestPoint closest_to_point(const TriangleProblem& triangle, const Vec& p) noexcept;

/// Closest to the segment from `middle - half` to `middle + half`; its middle is preferred among equals. The segment
/// must not pierce the triangle.
ClosestPoint closest_to_segment(const TriangleProblem& triangle, const Vec& middle, const Vec& half,
                                double hair) noexcept;

}  // namespace surefoot::internal
