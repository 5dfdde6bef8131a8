// Box. M = T (+) (-K) is a polytope, and the shortest way out of a polytope is square to one of its faces: a face of
// the triangle (its normal), a face of the box (three axes), or the parallelogram of an edge of each (nine cross
// products). These are the 13 axes of the separating axis test; both ways along each of them are considered.
#include "overlap/closest.hpp"
#include "overlap/ways.hpp"

namespace surefoot::internal {

namespace {

// The part of the triangle within a box, by cutting with one plane after another (Sutherland and Hodgman, 1974).
struct Polygon {
    Vec corner[9];
    int count = 0;
};

Polygon cut(const Polygon& polygon, const Vec& outward, double limit) noexcept {
    Polygon kept;
    for (int i = 0; i < polygon.count; ++i) {
        const Vec& a = polygon.corner[i];
        const Vec& b = polygon.corner[i + 1 == polygon.count ? 0 : i + 1];
        const double a_over = dot(outward, a) - limit;
        const double b_over = dot(outward, b) - limit;
        if (a_over <= 0 && kept.count < 9) kept.corner[kept.count++] = a;
        if (((a_over < 0 && b_over > 0) || (a_over > 0 && b_over < 0)) && kept.count < 9) {
            kept.corner[kept.count++] = a + (b - a) * (a_over / (a_over - b_over));
        }
    }
    return kept;
}

// The middle of what the triangle's farthest feature and the box, moved out, have in common.
ClosestPoint middle_of_contact(const Box& shape, const TriangleProblem& triangle, const WayOut& way,
                               double hair) noexcept {
    const FarthestFeature far = farthest_along(triangle, way.normal, 8 * hair);
    if (far.feature == Feature::vertex) return point_of_edge(triangle, far.index, 0);
    const Vec moved = way.normal * way.depth;
    Polygon polygon;
    if (far.feature == Feature::edge) {
        polygon.corner[polygon.count++] = triangle.corner[far.index] - moved;
        polygon.corner[polygon.count++] = triangle.corner[far.index == 2 ? 0 : far.index + 1] - moved;
    } else {
        for (const Vec& corner : triangle.corner) polygon.corner[polygon.count++] = corner - moved;
    }
    const Vec half = to_vec(shape.half_extents) + Vec{1, 1, 1} * (8 * hair);
    const Vec axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const double limits[3] = {half.x, half.y, half.z};
    for (int i = 0; i < 3; ++i) {
        polygon = cut(polygon, axes[i], limits[i]);
        polygon = cut(polygon, -axes[i], limits[i]);
    }
    Vec middle;
    for (int i = 0; i < polygon.count; ++i) middle = middle + polygon.corner[i] / polygon.count;
    return closest_to_point(triangle, middle + moved);
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
