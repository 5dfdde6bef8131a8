// Cone, apex at the origin, its disc of radius R at height H.
//
// As for the cylinder, with these differences. The side's outward normals are (H u, -R) for every level unit u, so the
// side against a corner leaves along u = the corner's own direction from the axis, and against an edge along the u
// with (H u, -R) . edge = 0: no quadratic but a cosine, H u.e = R e.y. The apex can separate against an edge that
// crosses the axis: then the normal is the part of Y across the edge.
//
// What grows here grows from the centre of the inscribed ball, a height c = H - b above the apex with
// b = R H / (R + sqrt(R^2 + H^2)): the growing rim draws the cone of slope R / b from there, and the grown side is
// (sqrt(x^2 + z^2) - k (y - c)) / (k c), with k = R / H.
#include "overlap/rim.hpp"

namespace surefoot::internal {

namespace {

template <typename Support>
void consider_side_against_edge(const Cone& shape, const Vec& e, Ways<Support>& ways) noexcept {
    const double level_length = std::sqrt(e.x * e.x + e.z * e.z);
    if (!(level_length > 0)) return;
    double cosine = shape.radius * e.y / (shape.height * level_length);
    if (absolute(cosine) > 1 + 0x1p-40) return;  // steeper than the side: no tangent plane holds it
    cosine = smaller(1, larger(-1, cosine));
    const double sine = std::sqrt(1 - cosine * cosine);
    const double x = e.x / level_length;
    const double z = e.z / level_length;
    for (const double side : {sine, -sine}) {
        const Vec u{cosine * x - side * z, 0, cosine * z + side * x};
        ways.one({-shape.height * u.x, shape.radius, -shape.height * u.z});
    }
}

}  // namespace

WayOut overlap_cone(const Cone& shape, const TriangleProblem& triangle) noexcept {
    const double r = shape.radius;
    const double h = shape.height;
    const auto support = [r, h](const Vec& n) noexcept {
        return larger(0, r * std::sqrt(n.x * n.x + n.z * n.z) + h * n.y);
    };
    const double ball = r * h / (r + std::sqrt(r * r + h * h));
    const double centre = h - ball;
    const double slope = r / h;
    const RimCone rim{.apex_height = centre, .slope = r / ball};
    const Vec up{0, 1, 0};
    Ways ways(triangle, support, larger(r, h));
    ways.both(triangle.normal);
    ways.both(up);
    for (int i = 0; i < 3; ++i) {
        const Vec& corner = triangle.corner[i];
        const double level = std::sqrt(corner.x * corner.x + corner.z * corner.z);
        if (level > 0) ways.one({-h * (corner.x / level), r, -h * (corner.z / level)});
        consider_side_against_edge(shape, triangle.edge[i], ways);
        ways.both(across(up, triangle.edge[i]));
    }
    consider_rim_planes(rim, triangle, ways);
    if (!ways.touches()) return ways.best();
    consider_rim_exits(r, h, triangle, ways);

    WayOut way = ways.best();
    const Vec level = unit({-way.normal.x, 0, -way.normal.z}) * r;
    const Vec supports[4] = {{0, 0, 0}, {level.x / 2, h / 2, level.z / 2}, {0, h, 0}, {level.x, h, level.z}};
    const auto gauge = [=](const Vec& p) noexcept {
        const double y = p.y - centre;
        return larger((std::sqrt(p.x * p.x + p.z * p.z) - slope * y) / (slope * centre), y / ball);
    };
    const ClosestPoint contact = deepest_point(triangle, way, ways.hair(), rim, slope, supports, 4, gauge);
    way.point = contact.point;
    way.corner = contact.corner;
    way.feature = contact.feature;
    return way;
}

}  // namespace surefoot::internal
