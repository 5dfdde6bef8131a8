// Cylinder of radius r and half height H along Y.
//
// The smooth patches of M, from which alone a shortest way out can start: a cap against a corner (normal Y), the face
// against the rim's farthest point (normal N), the side against a corner (level, away from the corner) or an edge
// (edge x Y), and the rim against an edge: an elliptic cylinder, and the shortest way out of an ellipse is Newton's, to
// rounding. So the way out is the shortest there is.
//
// Whether they touch at all is decided without iterating: grow the cylinder from its centre, by s, until it meets the
// triangle. Where it does, a plane separates the two, and its normal is one of the above or, where the growing rim
// meets an edge or a corner, square to that edge and to the rim's tangent there. The growing rims draw the double cone
// x^2 + z^2 = (r/H)^2 y^2, so that is a quadratic. If s > 1 that plane has a negative depth: they do not touch.
#include "overlap/rim.hpp"

namespace surefoot::internal {

WayOut overlap_cylinder(const Cylinder& shape, const TriangleProblem& triangle) noexcept {
    const double r = shape.radius;
    const double h = shape.half_height;
    const auto support = [r, h](const Vec& n) noexcept {
        return r * std::sqrt(n.x * n.x + n.z * n.z) + h * absolute(n.y);
    };
    const RimCone rims{.apex_height = 0, .slope = r / h};
    const Vec up{0, 1, 0};
    Ways ways(triangle, support, larger(r, h));
    ways.both(triangle.normal);
    ways.both(up);
    for (const Vec& e : triangle.edge) ways.both(cross(e, up));
    for (const Vec& corner : triangle.corner) ways.one({-corner.x, 0, -corner.z});
    consider_rim_planes(rims, triangle, ways);
    if (!ways.touches()) return ways.best();
    consider_rim_exits(r, h, triangle, ways);
    consider_rim_exits(r, -h, triangle, ways);

    WayOut way = ways.best();
    const Vec level = unit({-way.normal.x, 0, -way.normal.z}) * r;
    const double end = way.normal.y > 0 ? -h : h;
    const Vec supports[3] = {{level.x, 0, level.z}, {0, end, 0}, {level.x, end, level.z}};
    const auto gauge = [r, h](const Vec& p) noexcept {
        return larger(std::sqrt(p.x * p.x + p.z * p.z) / r, absolute(p.y) / h);
    };
    const ClosestPoint contact = deepest_point(triangle, way, ways.hair(), rims, 0, supports, 3, gauge);
    way.point = contact.point;
    way.corner = contact.corner;
    way.feature = contact.feature;
    return way;
}

}  // namespace surefoot::internal
