#include "overlap/rim.hpp"

namespace surefoot::internal {

LineRoots meet_rim_cone(const RimCone& cone, const Vec& start, const Vec& edge) noexcept {
    // x^2 + z^2 = slope^2 (y - apex)^2 along the line: a t^2 + 2 b t + c = 0.
    const double k = cone.slope;
    const double y = start.y - cone.apex_height;
    const double a = edge.x * edge.x + edge.z * edge.z - k * k * edge.y * edge.y;
    const double b = start.x * edge.x + start.z * edge.z - k * k * y * edge.y;
    const double c = start.x * start.x + start.z * start.z - k * k * y * y;
    const double discriminant = difference_of_products(b, b, a, c);
    const double root = discriminant > 0 ? std::sqrt(discriminant) : 0;
    const double q = b < 0 ? root - b : -(root + b);
    LineRoots roots;
    if (a != 0) roots.t[roots.count++] = q / a;
    if (q != 0) roots.t[roots.count++] = c / q;
    return roots;
}

int ways_out_of_rim(double radius, double height, const Vec& line, const Vec& through, Vec (&normals)[3]) noexcept {
    // Looked at along the line, the rim is an ellipse with half axes a along m1 (level) and b along m2, about the image
    // of its centre. In M it is mirrored, so the origin's place in it is q = -(through - centre).
    const Vec m1 = unit(cross(line, Vec{0, 1, 0}));
    const Vec m2 = cross(line, m1);
    const double a = radius;
    const double b = radius * absolute(line.y);
    if (m1 == Vec{} || !(b > 0)) return 0;
    const Vec from_centre = Vec{0, height, 0} - through;
    const double q1 = dot(m1, from_centre);
    const double q2 = dot(m2, from_centre);
    const double z0 = absolute(q1) / a;
    const double z1 = absolute(q2) / b;
    const double r = (a / b) * (a / b);
    const auto normal = [&](double u0, double u1) noexcept {
        return m1 * ((q1 < 0 ? -u0 : u0) / a) + m2 * ((q2 < 0 ? -u1 : u1) / b);
    };
    int count = 0;

    // Where the way from q leaves the ellipse squarely, at (a u0, b u1), u0 = r z0 / (s + r) and u1 = z1 / (s + 1) with
    // z = |q| over the half axes, r = (a/b)^2 and u of length one (Eberly, "Distance from a point to an ellipse").
    // On q's own side of the long axis -1 < s <= 0. One over the length of u is concave there and nearly straight, so
    // Newton from the left converges fast and from one side (Hebden 1973, as in trust regions).
    if (z0 * z0 + z1 * z1 <= 1) {
        double s = larger(z1 - 1, r * (z0 - 1));
        for (int i = 0; i < 6 && s > -1; ++i) {
            const double u0 = r * z0 / (s + r);
            const double u1 = z1 / (s + 1);
            const double squared = u0 * u0 + u1 * u1;
            const double slope = u0 * u0 / (s + r) + u1 * u1 / (s + 1);
            if (!(slope > 0)) break;
            s += (std::sqrt(squared) - 1) * squared / slope;
        }
        const double u0 = r > 1 || s > -1 ? smaller(1, r * z0 / (s + r)) : 0;
        normals[count++] = normal(u0, std::sqrt(larger(0, 1 - u0 * u0)));
        if (s > -1) normals[count++] = normal(u0, z1 / (s + 1));
    }

    // Across the long axis, where a flat ellipse has its other near side: -r < s < -1, and of the two roots there the
    // one next to -1. With w = -(s + 1), |u|^2 is convex in w, so Newton from the left stops short of the root or on
    // it.
    double w = z1;
    double u0 = 0;
    double u1 = 1;
    for (int i = 0; i < 8 && w > 0 && w < r - 1; ++i) {
        u0 = r * z0 / (r - 1 - w);
        u1 = z1 / w;
        const double slope = u0 * u0 / (r - 1 - w) - u1 * u1 / w;
        if (!(slope < 0)) return count;  // no root
        w += (1 - u0 * u0 - u1 * u1) / (2 * slope);
    }
    normals[count++] = normal(smaller(1, u0), -u1);
    return count;
}

}  // namespace surefoot::internal
