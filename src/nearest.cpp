#include "nearest.hpp"

#include "exact/products.hpp"

namespace surefoot::internal {

namespace {

double clamp01(double s) noexcept {
    return s < 0 ? 0 : (s > 1 ? 1 : s);
}

double squared(const Vec& v) noexcept {
    return dot(v, v);
}

// Nearest points of two segments (Ericson, "Real-Time Collision Detection", 5.1.9), the one on the first.
struct NearestPair {
    Vec on_first;
    Vec on_second;
};

NearestPair nearest_of_segments(const Vec& p, const Vec& p_end, const Vec& q, const Vec& q_end) noexcept {
    const Vec d1 = p_end - p;
    const Vec d2 = q_end - q;
    const Vec r = p - q;
    const double a = squared(d1);
    const double e = squared(d2);
    const double f = dot(d2, r);
    const double c = dot(d1, r);
    const double b = dot(d1, d2);
    const double denominator = a * e - b * b;
    double s = a > 0 && denominator > 0 ? clamp01((b * f - c * e) / denominator) : 0.5;
    double t = e > 0 ? (b * s + f) / e : 0;
    if (t < 0 || t > 1) {
        t = clamp01(t);
        s = a > 0 ? clamp01((b * t - c) / a) : 0;
    }
    return {p + d1 * s, q + d2 * t};
}

}  // namespace

Vec nearest_on_segment(const Vec& point, const Vec& a, const Vec& b) noexcept {
    const Vec edge = b - a;
    const double size = squared(edge);
    return size > 0 ? a + edge * clamp01(dot(point - a, edge) / size) : a;
}

// Face, else the nearest of the edges: steadier for slivers than deciding the region first.
Vec nearest_on_triangle(const Vec& point, const Vec (&corners)[3]) noexcept {
    // The plane of a sliver is lost in a plain cross product.
    const Vec normal =
        unit(accurate_cross(scaled_to_one(corners[1] - corners[0]), scaled_to_one(corners[2] - corners[0])));
    if (normal != Vec{}) {
        // Past either end of its longest edge no point is above the face. Those of a triangle that has no area but for
        // rounding cannot be told from the normal.
        int longest = 0;
        bool inside = true;
        for (int i = 0; i < 3; ++i) {
            const Vec& a = corners[i];
            const Vec edge = corners[(i + 1) % 3] - a;
            if (squared(edge) > squared(corners[(longest + 1) % 3] - corners[longest])) longest = i;
            inside = inside && dot(cross(edge, point - a), normal) >= 0;
        }
        const Vec& start = corners[longest];
        const Vec& end = corners[(longest + 1) % 3];
        inside = inside && dot(point - start, end - start) >= 0 && dot(point - end, end - start) <= 0;
        if (inside) return point - normal * dot(point - corners[0], normal);
    }
    Vec best = nearest_on_segment(point, corners[0], corners[1]);
    for (int i = 1; i < 3; ++i) {
        const Vec other = nearest_on_segment(point, corners[i], corners[(i + 1) % 3]);
        if (squared(other - point) < squared(best - point)) best = other;
    }
    return best;
}

Vec nearest_on_triangle_to_segment(const Vec& from, const Vec& to, const Vec (&corners)[3]) noexcept {
    Vec best = nearest_on_triangle((from + to) * 0.5, corners);
    double distance = squared(best - nearest_on_segment(best, from, to));
    const auto keep_nearer = [&](const Vec& on_triangle, const Vec& on_segment) {
        const double other = squared(on_triangle - on_segment);
        if (other < distance) {
            distance = other;
            best = on_triangle;
        }
    };
    keep_nearer(nearest_on_triangle(from, corners), from);
    keep_nearer(nearest_on_triangle(to, corners), to);
    const Vec normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double above = dot(from - corners[0], normal);
    const double below = dot(to - corners[0], normal);
    if ((above < 0) != (below < 0)) {
        // The segment crosses the plane, perhaps through the face.
        const Vec crossing = from + (to - from) * (above / (above - below));
        keep_nearer(nearest_on_triangle(crossing, corners), crossing);
    }
    for (int i = 0; i < 3; ++i) {
        const NearestPair pair = nearest_of_segments(corners[i], corners[(i + 1) % 3], from, to);
        keep_nearer(pair.on_first, pair.on_second);
    }
    return best;
}

}  // namespace surefoot::internal
