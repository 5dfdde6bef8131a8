#include "sweep/contact_point.hpp"

#include "nearest.hpp"
#include "overloaded.hpp"

namespace surefoot::internal {

namespace {

struct Polygon {
    Vec points[10];
    int count = 0;
};

// Sutherland and Hodgman's clip against the half space where side * (p along one axis) <= bound.
Polygon clipped(const Polygon& polygon, const Vec& axis, double bound) noexcept {
    Polygon result;
    for (int i = 0; i < polygon.count; ++i) {
        const Vec& here = polygon.points[i];
        const Vec& next = polygon.points[(i + 1) % polygon.count];
        const double over = dot(here, axis) - bound;
        const double over_next = dot(next, axis) - bound;
        if (over <= 0 && result.count < 10) result.points[result.count++] = here;
        if ((over < 0 && over_next > 0) || (over > 0 && over_next < 0)) {
            if (result.count < 10) result.points[result.count++] = here + (next - here) * (over / (over - over_next));
        }
    }
    return result;
}

// The middle of what the box, a little larger, has of the triangle.
Vec in_box(const Vec (&corners)[3], const Vec& half_extents, double margin, const Vec& fallback) noexcept {
    Polygon polygon{{corners[0], corners[1], corners[2]}, 3};
    const Vec axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const Vec& axis : axes) {
        const double bound = dot(half_extents, axis) + margin;
        polygon = clipped(clipped(polygon, axis, bound), -axis, bound);
    }
    if (polygon.count == 0) return nearest_on_triangle(fallback, corners);
    Vec middle;
    for (int i = 0; i < polygon.count; ++i) middle = middle + polygon.points[i];
    return middle / polygon.count;
}

double signed_like(double size, double sign) noexcept {
    return sign < 0 ? -size : size;
}

}  // namespace

Vec contact_point(const SweepQuery& query, const Vec& moved, const Vec& normal) noexcept {
    const Vec corners[3] = {query.corners[0] - moved, query.corners[1] - moved, query.corners[2] - moved};
    double hair = 2 * query.shape_slack;
    for (const double slack : query.corner_slack) hair += 2 * slack;

    const double sideways = std::sqrt(normal.x * normal.x + normal.z * normal.z);
    const auto rim_point = [&](double radius, double height) {
        return sideways > 0 ? Vec{-normal.x / sideways * radius, height, -normal.z / sideways * radius}
                            : Vec{0, height, 0};
    };
    const Vec local =
        std::visit(Overloaded{
                       [&](const Sphere&) { return nearest_on_triangle({}, corners); },
            [&](const Ellipsoid& ellipsoid) {
                const Vec radii = to_vec(ellipsoid.radii);
                const Vec squashed[3] = {divide_each(corners[0], radii), divide_each(corners[1], radii),
                                         divide_each(corners[2], radii)};
                return multiply_each(nearest_on_triangle({}, squashed), radii);
            },
            [&](const Capsule& capsule) {
                const Vec up{0, capsule.half_height, 0};
                return nearest_on_triangle_to_segment(-up, up, corners);
            },
            [&](const Box& box) {
                           const Vec half = to_vec(box.half_extents);
                           const Vec support{-signed_like(half.x, normal.x), -signed_like(half.y, normal.y),
                                             -signed_like(half.z, normal.z)};
                           return in_box(corners, half, hair, support);
                       },
                       [&](const Cylinder& cylinder) {
                           const double height = -signed_like(cylinder.half_height, normal.y);
                           if (sideways * cylinder.radius <= hair) return nearest_on_triangle({0, height, 0}, corners);
                           const Vec rim = rim_point(cylinder.radius, height);
                           if (absolute(normal.y) * cylinder.half_height > hair)
                               return nearest_on_triangle(rim, corners);
                           return nearest_on_triangle_to_segment(rim, {rim.x, -height, rim.z}, corners);
                       },
                       [&](const Cone& cone) {
                           const Vec rim = rim_point(cone.radius, cone.height);
                           const double rim_reach = sideways * cone.radius - normal.y * cone.height;
                           if (normal.y < 0 && sideways * cone.radius <= hair) {
                               return nearest_on_triangle({0, cone.height, 0}, corners);
                           }
                           if (rim_reach > hair) return nearest_on_triangle(rim, corners);
                           if (rim_reach < -hair) return nearest_on_triangle({0, 0, 0}, corners);
                           return nearest_on_triangle_to_segment({0, 0, 0}, rim, corners);
                       },
                   },
                   query.shape);
    return local + moved;
}

}  // namespace surefoot::internal
