// Capsule: a segment S of half length H along Y with a ball of radius r around it.
//
// M is the prism T (+) S with the same ball around it. Outside the prism the way out is r - d, away from the point of
// the prism that is closest to the reference point. Inside (the core pierces the triangle) it is r more than the way to
// the nearest of the prism's faces: the triangle's two sides, moved to both ends of S, and the three parallelograms
// that its edges sweep, with normals edge x Y.
#include "overlap/closest.hpp"
#include "overlap/ways.hpp"

namespace surefoot::internal {

WayOut overlap_capsule(const Capsule& shape, const TriangleProblem& triangle) noexcept {
    const auto support = [&shape](const Vec& n) noexcept { return shape.half_height * absolute(n.y) + shape.radius; };
    const Vec up{0, 1, 0};
    const Vec ends[2] = {{0, -shape.half_height, 0}, {0, shape.half_height, 0}};
    Ways ways(triangle, support, shape.half_height + shape.radius);
    ways.both(triangle.normal);
    for (const Vec& e : triangle.edge) ways.both(cross(e, up));
    for (int i = 0; i < 3; ++i) {
        const Vec& corner = triangle.corner[i];
        ways.one({-corner.x, 0, -corner.z});  // the corner against the straight part
        for (const Vec& end : ends) {
            ways.one(end - corner);
            ways.one(across(end - corner, triangle.edge[i]));
        }
    }
    WayOut way = ways.best();
    if (way.touches) {
        const Vec moved = way.normal * way.depth;
        const ClosestPoint closest = closest_to_segment(triangle, moved, ends[1], ways.hair());
        way.point = closest.point;
        way.corner = closest.corner;
        way.feature = closest.feature;
    }
    return way;
}

}  // namespace surefoot::internal
