#include "sweep/deepest.hpp"

#include "nearest.hpp"
#include "overloaded.hpp"
#include "polygon.hpp"

namespace surefoot::internal {

namespace {

constexpr Vec axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

double clamp(double s, double low, double high) noexcept {
    return s < low ? low : (s > high ? high : s);
}

double component(const Vec& v, int axis) noexcept {
    return axis == 0 ? v.x : (axis == 1 ? v.y : v.z);
}

double sideways_length(const Vec& v) noexcept {
    return std::sqrt(v.x * v.x + v.z * v.z);
}

Polygon clipped_between(const Vec (&corners)[3], const Vec& axis, double low, double high) noexcept {
    const Polygon whole{{corners[0], corners[1], corners[2]}, 3};
    return whole.clipped(axis, high).clipped(-axis, -low);
}

// The part of a segment, as shares, whose coordinate along an axis lies in [low, high].
struct Shares {
    double from = 0;
    double to = 1;

    void keep(double start, double along, double low, double high) noexcept {
        if (along == 0) return;
        const double a = (low - start) / along;
        const double b = (high - start) / along;
        from = larger(from, smaller(a, b));
        to = smaller(to, larger(a, b));
    }
    // An empty part is the point where it vanishes.
    [[nodiscard]] double clamp_to(double share) const noexcept {
        return from <= to ? clamp(share, from, to) : clamp((from + to) / 2, 0, 1);
    }
};

// The share at which the line a + s d is nearest to the Y axis.
double nearest_to_axis(const Vec& a, const Vec& d) noexcept {
    const double size = d.x * d.x + d.z * d.z;
    return size > 0 ? -(a.x * d.x + a.z * d.z) / size : 0.5;
}

// The share at which the line a + s d has the least |p_h| - k p.y: with m its distance from the axis, w and d.y its
// pace sideways and up, at k d.y m / (w sqrt(w^2 - k^2 d.y^2)) past the nearest point, if it climbs less than the
// cone's side.
double deepest_in_cone(const Cone& cone, const Vec& a, const Vec& d) noexcept {
    const double w = sideways_length(d);
    const double climb = cone.radius / cone.height * d.y;
    if (w <= absolute(climb)) return climb > 0 ? 1 : 0;
    const double nearest = nearest_to_axis(a, d);
    const double m = sideways_length(a + d * nearest);
    return nearest + climb * m / (w * std::sqrt((w - climb) * (w + climb)));
}

double in_cylinder(const Cylinder& cylinder, const Vec& a, const Vec& d, double margin) noexcept {
    Shares shares;
    shares.keep(a.y, d.y, -cylinder.half_height - margin, cylinder.half_height + margin);
    return shares.clamp_to(nearest_to_axis(a, d));
}

double in_cone(const Cone& cone, const Vec& a, const Vec& d, double margin) noexcept {
    Shares shares;
    shares.keep(a.y, d.y, -margin, cone.height + margin);
    return shares.clamp_to(deepest_in_cone(cone, a, d));
}

double in_box(const Box& box, const Vec& a, const Vec& d, double margin) noexcept {
    Shares shares;
    for (int axis = 0; axis < 3; ++axis) {
        const double bound = component(to_vec(box.half_extents), axis) + margin;
        shares.keep(component(a, axis), component(d, axis), -bound, bound);
    }
    return clamp((shares.from + shares.to) / 2, 0, 1);
}

double height_in_cone(const Cone& cone, const Vec& p) noexcept {
    return sideways_length(p) - cone.radius / cone.height * p.y;
}

// Of the polygon's edges and, for the axis that runs through it, of the crossing: the point with the least `measure`.
template <typename OnEdge, typename Measure>
Vec least_on_polygon(const Polygon& polygon, const Vec& fallback, const OnEdge& on_edge,
                     const Measure& measure) noexcept {
    if (polygon.count == 0) return fallback;
    Vec best = polygon.points[0];
    const auto keep = [&](const Vec& p) {
        if (measure(p) < measure(best)) best = p;
    };
    for (int i = 0; i < polygon.count; ++i) {
        const Vec& a = polygon.points[i];
        const Vec d = polygon.points[(i + 1) % polygon.count] - a;
        keep(a + d * on_edge(a, d));
    }
    for (int i = 1; i + 1 < polygon.count; ++i) {
        const Vec fan[3] = {polygon.points[0], polygon.points[i], polygon.points[i + 1]};
        const Vec normal = cross(fan[1] - fan[0], fan[2] - fan[0]);
        if (normal.y == 0) continue;
        const Vec crossing{0, dot(normal, fan[0]) / normal.y, 0};
        const Vec inside = nearest_on_triangle(crossing, fan);
        if (measure(inside) < measure(best)) best = inside;
    }
    return best;
}

}  // namespace

Vec deepest_on_segment(const Shape& shape, const Vec& a, const Vec& b, double margin) noexcept {
    const Vec d = b - a;
    return std::visit(Overloaded{
                          [&](const Sphere&) { return nearest_on_segment({}, a, b); },
                          [&](const Ellipsoid& ellipsoid) {
                              const Vec radii = to_vec(ellipsoid.radii);
                              return multiply_each(nearest_on_segment({}, divide_each(a, radii), divide_each(b, radii)),
                                                   radii);
                          },
                          [&](const Capsule& capsule) {
                              const Vec up{0, capsule.half_height, 0};
                              const Vec twice[3] = {a, b, b};
                              return nearest_on_triangle_to_segment(-up, up, twice);
                          },
                          [&](const Box& box) { return a + d * in_box(box, a, d, margin); },
                          [&](const Cylinder& cylinder) { return a + d * in_cylinder(cylinder, a, d, margin); },
                          [&](const Cone& cone) { return a + d * in_cone(cone, a, d, margin); },
                      },
                      shape);
}

Vec deepest_on_triangle(const Shape& shape, const Vec (&corners)[3], double margin) noexcept {
    return std::visit(
        Overloaded{
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
                Polygon polygon{{corners[0], corners[1], corners[2]}, 3};
                for (const Vec& axis : axes) {
                    const double bound = dot(to_vec(box.half_extents), axis) + margin;
                    polygon = polygon.clipped(axis, bound).clipped(-axis, bound);
                }
                return polygon.count == 0 ? nearest_on_triangle({}, corners) : polygon.middle();
            },
            [&](const Cylinder& cylinder) {
                const double bound = cylinder.half_height + margin;
                return least_on_polygon(
                    clipped_between(corners, axes[1], -bound, bound), nearest_on_triangle({}, corners),
                    [](const Vec& a, const Vec& along) { return clamp(nearest_to_axis(a, along), 0, 1); },
                    sideways_length);
            },
            [&](const Cone& cone) {
                return least_on_polygon(
                    clipped_between(corners, axes[1], -margin, cone.height + margin),
                    nearest_on_triangle({0, cone.height / 2, 0}, corners),
                    [&](const Vec& a, const Vec& along) { return clamp(deepest_in_cone(cone, a, along), 0, 1); },
                    [&](const Vec& p) { return height_in_cone(cone, p); });
            },
        },
        shape);
}

Vec nearest_in_cone(const Cone& cone, const Vec& p) noexcept {
    const double sideways = sideways_length(p);
    if (p.y <= cone.height && sideways <= cone.radius / cone.height * p.y) return p;
    // On the disc, or on the line from the apex to the rim.
    const double on_disc = smaller(sideways, cone.radius);
    const double share = clamp(
        (sideways * cone.radius + p.y * cone.height) / (cone.radius * cone.radius + cone.height * cone.height), 0, 1);
    const auto point_at = [&](double distance, double height) {
        const double scale = sideways > 0 ? distance / sideways : 0;
        return Vec{p.x * scale, height, p.z * scale};
    };
    const Vec disc = point_at(on_disc, cone.height);
    const Vec side = point_at(share * cone.radius, share * cone.height);
    return length(p - disc) < length(p - side) ? disc : side;
}

double outside_by(const Shape& shape, const Vec& p) noexcept {
    return std::visit(Overloaded{
                          [&](const Sphere& sphere) { return length(p) - sphere.radius; },
                          [&](const Ellipsoid& ellipsoid) {
                              const Vec radii = to_vec(ellipsoid.radii);
                              return (length(divide_each(p, radii)) - 1) * smaller(radii.x, smaller(radii.y, radii.z));
                          },
                          [&](const Capsule& capsule) {
                              const Vec up{0, capsule.half_height, 0};
                              return length(p - nearest_on_segment(p, -up, up)) - capsule.radius;
                          },
                          [&](const Box& box) {
                              const Vec half = to_vec(box.half_extents);
                              return larger(absolute(p.x) - half.x,
                                            larger(absolute(p.y) - half.y, absolute(p.z) - half.z));
                          },
                          [&](const Cylinder& cylinder) {
                              return larger(absolute(p.y) - cylinder.half_height, sideways_length(p) - cylinder.radius);
                          },
                          [&](const Cone& cone) { return larger(p.y - cone.height, height_in_cone(cone, p)); },
                      },
                      shape);
}

double at_most_outside_by(const Shape& shape, const Vec& p) noexcept {
    const double outside = outside_by(shape, p);
    if (outside <= 0) return outside;
    return std::visit(Overloaded{
                          [&](const Ellipsoid& ellipsoid) {
                              // Back to the surface along the radius.
                              const Vec radii = to_vec(ellipsoid.radii);
                              return outside * largest(radii) / smaller(radii.x, smaller(radii.y, radii.z));
                          },
                          [&](const Box&) { return outside * 2; },       // in all three directions at once
                          [&](const Cylinder&) { return outside * 2; },  // up and sideways
                          [&](const Cone& cone) {
                              // Sideways to the side and down to the disc; near the rim, by turns.
                              return outside * (2 + 2 * (cone.height / cone.radius + cone.radius / cone.height));
                          },
                          [&](const auto&) { return outside; },
                      },
                      shape);
}

}  // namespace surefoot::internal
