#include "overlap/closest.hpp"

namespace surefoot::internal {

namespace {

ClosestPoint with_distance(ClosestPoint found, const Vec& p) noexcept {
    found.distance = length(p - found.point);
    return found;
}

ClosestPoint nearer(const ClosestPoint& a, const ClosestPoint& b) noexcept {
    return b.distance < a.distance ? b : a;
}

double ratio(double part, double whole) noexcept {
    return whole > 0 ? part / whole : 0;
}

}  // namespace

ClosestPoint point_of_edge(const TriangleProblem& triangle, int edge, double t) noexcept {
    const int next = edge == 2 ? 0 : edge + 1;
    ClosestPoint found;
    if (!(t > 0)) {
        found.point = triangle.corner[edge];
        found.corner = edge;
        found.feature = Feature::vertex;
    } else if (t >= 1) {
        found.point = triangle.corner[next];
        found.corner = next;
        found.feature = Feature::vertex;
    } else {
        // From the nearer end, so that the error is relative to the shorter part.
        found.point = t < 0.5 ? triangle.corner[edge] + triangle.edge[edge] * t
                              : triangle.corner[next] - triangle.edge[edge] * (1 - t);
        found.feature = Feature::edge;
    }
    return found;
}

bool is_above_face(const TriangleProblem& triangle, const Vec& p) noexcept {
    const Vec normal = triangle.normal * triangle.winding;
    for (int i = 0; i < 3; ++i) {
        if (!(dot(cross(normal, triangle.edge[i]), p - triangle.corner[i]) > 0)) return false;
    }
    return true;
}

ClosestPoint closest_to_point(const TriangleProblem& triangle, const Vec& p) noexcept {
    ClosestPoint best;
    if (is_above_face(triangle, p)) {
        best.point = p - triangle.normal * dot(triangle.normal, p - triangle.corner[0]);
        best.distance = length(p - best.point);
        return best;
    }
    for (int i = 0; i < 3; ++i) {
        const Vec& e = triangle.edge[i];
        const double t = ratio(dot(p - triangle.corner[i], e), dot(e, e));
        best = nearer(best, with_distance(point_of_edge(triangle, i, t), p));
    }
    return best;
}

ClosestPoint closest_to_segment(const TriangleProblem& triangle, const Vec& middle, const Vec& half,
                                double hair) noexcept {
    ClosestPoint best = closest_to_point(triangle, middle);
    best.distance -= hair;
    best = nearer(best, closest_to_point(triangle, middle - half));
    best = nearer(best, closest_to_point(triangle, middle + half));
    // Two lines u = middle + s half, v = corner + t edge: their closest points by the usual 2 by 2 system, s clamped
    // first and t after it (Ericson, Real-Time Collision Detection, 5.1.9).
    const double ss = dot(half, half);
    for (int i = 0; i < 3; ++i) {
        const Vec& e = triangle.edge[i];
        const Vec between = middle - triangle.corner[i];
        const double st = dot(half, e);
        const double tt = dot(e, e);
        const Vec normal = accurate_cross(half, e);
        const double determinant = dot(normal, normal);
        if (!(determinant > 0)) continue;  // parallel: the ends and the middle above have it
        double s = (st * dot(e, between) - tt * dot(half, between)) / determinant;
        s = smaller(1, larger(-1, s));
        double t = (dot(e, between) + s * st) / tt;
        if (t < 0 || t > 1) {
            t = t < 0 ? 0 : 1;
            s = smaller(1, larger(-1, ratio(t * st - dot(half, between), ss)));
        }
        best = nearer(best, with_distance(point_of_edge(triangle, i, t), middle + half * s));
    }
    return best;
}

}  // namespace surefoot::internal
