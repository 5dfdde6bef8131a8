// What cylinder and cone have in common: a circular rim about the Y axis, and what it does to the edges of a triangle.
#pragma once

#include "overlap/closest.hpp"
#include "overlap/ways.hpp"

namespace surefoot::internal {

/// A shape shrunk towards `centre_height` on its axis draws its rim along a cone with this apex: the points at which a
/// rim can be the first part of the growing shape to meet an edge. `slope` is radius over height of that cone.
struct RimCone {
    double apex_height = 0;
    double slope = 1;
};

struct LineRoots {
    double t[2] = {0, 0};
    int count = 0;
};

/// Where the line `start + t edge` meets the cone (both nappes). At a tangency rounded away, the tangent point.
LineRoots meet_rim_cone(const RimCone& cone, const Vec& start, const Vec& edge) noexcept;

/// The tangent of the circle about the Y axis through `p`.
constexpr Vec rim_tangent(const Vec& p) noexcept {
    return {-p.z, 0, p.x};
}

/// A rim of `radius` at `height`, looked at along a line of unit direction `line`, is an ellipse. Its outward normals
/// at the points through which the origin's image can leave it squarely, for a line through `through`. Returns how many
/// were found; the same one may come twice, computed in two ways.
int ways_out_of_rim(double radius, double height, const Vec& line, const Vec& through, Vec (&normals)[3]) noexcept;

/// All directions in which a rim may separate the triangle from the shape: square to an edge and to the rim's tangent
/// where the growing rim meets that edge or its ends.
template <typename Support>
void consider_rim_planes(const RimCone& cone, const TriangleProblem& triangle, Ways<Support>& ways) noexcept {
    for (int i = 0; i < 3; ++i) {
        const Vec line = unit(triangle.edge[i]);
        if (line == Vec{}) continue;
        // From the foot of the perpendicular, where a needle's coordinates are smallest.
        const Vec foot = across(triangle.corner[i], line);
        const LineRoots roots = meet_rim_cone(cone, foot, line);
        for (int k = 0; k < roots.count; ++k) ways.both(cross(line, rim_tangent(foot + line * roots.t[k])));
        ways.both(cross(line, rim_tangent(triangle.corner[i])));
        ways.both(cross(line, rim_tangent(triangle.corner[i == 2 ? 0 : i + 1])));
    }
}

/// The shortest ways out of the patches that a rim and an edge make.
template <typename Support>
void consider_rim_exits(double radius, double height, const TriangleProblem& triangle, Ways<Support>& ways) noexcept {
    for (int i = 0; i < 3; ++i) {
        const Vec line = unit(triangle.edge[i]);
        Vec normals[3];
        const int count = ways_out_of_rim(radius, height, line, triangle.corner[i], normals);
        for (int k = 0; k < count; ++k) ways.one(normals[k]);
    }
}

/// The point of the triangle at which a shape that has been moved out touches it: of the candidates, the one for which
/// the shape would have to be shrunk most towards `apex_height` to let it go. `Gauge` is `double gauge(const Vec& p)`,
/// 1 on the shape's surface, with p relative to the reference point; `side_slope` is radius over height of a cone's
/// side, 0 for a cylinder; `supports` are points of the shape's surface that may be what touches the face.
template <typename Gauge>
ClosestPoint deepest_point(const TriangleProblem& triangle, const WayOut& way, double hair, const RimCone& cone,
                           double side_slope, const Vec* supports, int support_count, const Gauge& gauge) noexcept {
    const FarthestFeature far = farthest_along(triangle, way.normal, 8 * hair);
    if (far.feature == Feature::vertex) return point_of_edge(triangle, far.index, 0);
    const Vec moved = way.normal * way.depth;
    const double tie = hair / larger(triangle.scale, hair);
    ClosestPoint best;
    const auto consider = [&](ClosestPoint candidate) noexcept {
        candidate.distance = gauge(candidate.point - moved);
        if (candidate.distance < best.distance - tie) best = candidate;
    };
    if (far.feature == Feature::face) {
        for (int k = 0; k < support_count; ++k) {
            const Vec p = supports[k] + moved;
            if (!is_above_face(triangle, p)) continue;
            ClosestPoint candidate;
            candidate.point = p - triangle.normal * dot(triangle.normal, p - triangle.corner[0]);
            consider(candidate);
        }
    }
    for (int i = 0; i < 3; ++i) {
        if (far.feature == Feature::edge && i != far.index) continue;
        const Vec& e = triangle.edge[i];
        const Vec start = triangle.corner[i] - moved;
        const double across_squared = e.x * e.x + e.z * e.z;
        double nearest = 0;
        if (across_squared > 0) {
            nearest = -(start.x * e.x + start.z * e.z) / across_squared;
            consider(point_of_edge(triangle, i, nearest));
            const double cosine = side_slope * e.y / std::sqrt(across_squared);
            if (side_slope > 0 && absolute(cosine) < 1) {
                const double x = start.x + e.x * nearest;
                const double z = start.z + e.z * nearest;
                const double further = cosine * std::sqrt((x * x + z * z) / ((1 - cosine * cosine) * across_squared));
                consider(point_of_edge(triangle, i, nearest + further));
            }
        }
        if (e.y != 0) consider(point_of_edge(triangle, i, (cone.apex_height - start.y) / e.y));
        const LineRoots roots = meet_rim_cone(cone, start, e);
        for (int k = 0; k < roots.count; ++k) consider(point_of_edge(triangle, i, roots.t[k]));
        consider(point_of_edge(triangle, i, 0));
        consider(point_of_edge(triangle, i, 1));
    }
    return best;
}

}  // namespace surefoot::internal
