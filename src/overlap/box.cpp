// Box. M = T (+) (-K) is a polytope, and the shortest way out of a polytope is square to one of its faces: a face of
// the triangle (its normal), a face of the box (three axes), or the parallelogram of an edge of each (nine cross
// products). These are the 13 axes of the separating axis test; both ways along each of them are considered.
#include "overlap/closest.hpp"
#include "overlap/ways.hpp"
#include "polygon.hpp"

namespace surefoot::internal {

namespace {

// The middle of what the triangle's farthest feature and the box, moved out, have in common.
ClosestPoint middle_of_contact(const Box& shape, const TriangleProblem& triangle, const WayOut& way,
                               double hair) noexcept {
    const FarthestFeature far = farthest_along(triangle, way.normal, 8 * hair);
    if (far.feature == Feature::vertex) return point_of_edge(triangle, far.index, 0);
    const Vec moved = way.normal * way.depth;
    Polygon polygon;
    if (far.feature == Feature::edge) {
        polygon.add(triangle.corner[far.index] - moved);
        polygon.add(triangle.corner[far.index == 2 ? 0 : far.index + 1] - moved);
    } else {
        for (const Vec& corner : triangle.corner) polygon.add(corner - moved);
    }
    const Vec half = to_vec(shape.half_extents) + Vec{1, 1, 1} * (8 * hair);
    const Vec axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const double limits[3] = {half.x, half.y, half.z};
    for (int i = 0; i < 3; ++i) {
        polygon = polygon.clipped(axes[i], limits[i]).clipped(-axes[i], limits[i]);
    }
    return closest_to_point(triangle, (polygon.count > 0 ? polygon.middle() : Vec{}) + moved);
}

}  // namespace

WayOut overlap_box(const Box& shape, const TriangleProblem& triangle) noexcept {
    const Vec half = to_vec(shape.half_extents);
    const auto support = [&half](const Vec& n) noexcept {
        return half.x * absolute(n.x) + half.y * absolute(n.y) + half.z * absolute(n.z);
    };
    Ways ways(triangle, support, largest(half));
    const Vec axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    ways.both(triangle.normal);
    for (const Vec& axis : axes) ways.both(axis);
    for (const Vec& e : triangle.edge) {
        for (const Vec& axis : axes) ways.both(cross(e, axis));
    }
    WayOut way = ways.best();
    if (way.touches) {
        const ClosestPoint contact = middle_of_contact(shape, triangle, way, ways.hair());
        way.point = contact.point;
        way.corner = contact.corner;
        way.feature = contact.feature;
    }
    return way;
}

}  // namespace surefoot::internal
