// Sphere and ellipsoid.
//
// Sphere: with q the point of the triangle closest to the centre and d its distance, depth = r - d along (centre - q).
// In terms of directions (ways.hpp): the closest point is on the face, on an edge or is a corner, so the direction is
// the face's normal, the part of the centre across an edge, or from a corner to the centre. A centre in the triangle's
// plane leaves the two sides of the face, both r deep.
//
// Ellipsoid: divide by the radii. There it is a unit ball; with d and u as above the ball leaves along (1 - d) u, and
// stretched back that is the move R (1 - d) u, after which shape and triangle touch in the same point as the ball does.
// How much longer than the shortest: 1 - d is the shortest way out when squashed, and a way of length L in the world is
// at most L / r_min long there, so every way out has L >= r_min (1 - d), while |R (1 - d) u| <= r_max (1 - d): at most
// r_max / r_min times the shortest.
#include "overlap/closest.hpp"
#include "overlap/ways.hpp"

namespace surefoot::internal {

namespace {

WayOut overlap_ball(double radius, const TriangleProblem& triangle) noexcept {
    const auto support = [radius](const Vec&) noexcept { return radius; };
    Ways ways(triangle, support, radius);
    ways.both(triangle.normal);
    for (int i = 0; i < 3; ++i) ways.one(across(-triangle.corner[i], triangle.edge[i]));
    for (int i = 0; i < 3; ++i) ways.one(-triangle.corner[i]);
    WayOut way = ways.best();
    if (way.touches) {
        const ClosestPoint closest = closest_to_point(triangle, Vec{});
        way.point = closest.point;
        way.corner = closest.corner;
        way.feature = closest.feature;
    }
    return way;
}

}  // namespace

WayOut overlap_sphere(const Sphere& shape, const TriangleProblem& triangle) noexcept {
    return overlap_ball(shape.radius, triangle);
}

WayOut overlap_ellipsoid(const Ellipsoid& shape, const TriangleProblem& triangle) noexcept {
    const Vec radii = to_vec(shape.radii);
    TriangleProblem squashed;
    squashed.winding = triangle.winding;
    for (int i = 0; i < 3; ++i) {
        squashed.corner[i] = divide_each(triangle.corner[i], radii);
        squashed.edge[i] = divide_each(triangle.edge[i], radii);
        squashed.scale = larger(squashed.scale, largest(squashed.corner[i]));
    }
    // A normal goes through the transpose of the inverse: n.v = (R n).(v / R).
    squashed.normal = unit(multiply_each(triangle.normal, radii));
    const Vec across_edges = unit(accurate_cross(squashed.edge[0], squashed.edge[1]));
    if (!(across_edges == Vec{})) {
        squashed.normal = dot(across_edges, squashed.normal) < 0 ? -across_edges : across_edges;
    }
    WayOut way = overlap_ball(1, squashed);
    const Vec stretched = multiply_each(way.normal, radii);
    way.depth *= length(stretched);
    way.normal = unit(stretched);
    way.point = multiply_each(way.point, radii);
    return way;
}

}  // namespace surefoot::internal
