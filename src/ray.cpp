// A ray against a triangle, watertight: on which side of each edge the line passes is the sign of a determinant, first
// in doubles with a bound on the error, then exactly. Two triangles that share an edge ask the same determinant about
// it. Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection" (2013) has the idea; Shewchuk, "Adaptive Precision
// Floating-Point Arithmetic and Fast Robust Geometric Predicates" (1997) the bound.
#include <surefoot/ray.hpp>

#include "exact/products.hpp"
#include "ieee_guard.hpp"
#include "limits.hpp"
#include "sweep/exact_query.hpp"
#include "sweep/start.hpp"

namespace surefoot {
inline namespace v0 {

namespace {

using namespace internal;

using RayNumber = ExactNumber<320>;  // degree 8 in coordinates of at most 1107 digits
using RayVec = ExactVec<RayNumber>;

// The sign of (b - a) x (c - a) . (d - a): on which side of the plane through a, b, c is d?
int side_of_plane(const Vec& a, const Vec& b, const Vec& c, const Vec& d) noexcept {
    const Vec ab = b - a;
    const Vec ac = c - a;
    const Vec ad = d - a;
    const double determinant = dot(cross(ab, ac), ad);
    // Each difference is good to one rounding, each product of three to five more; 16 covers the sums too.
    const double bound = 16 * 0x1p-53 * norm1(ab) * norm1(ac) * norm1(ad);
    // A bound near the end of the doubles' range is no bound.
    if (bound > 0x1p-900 && absolute(determinant) > bound) return determinant > 0 ? 1 : -1;
    const auto exact_a = to_exact<RayNumber>(a);
    return dot(cross(to_exact<RayNumber>(b) - exact_a, to_exact<RayNumber>(c) - exact_a),
               to_exact<RayNumber>(d) - exact_a)
        .sign();
}

struct Crossing {
    double t = 0;
    Feature feature = Feature::edge;
};

// The first point of the segment `from` + t * along that lies on the segment p, q (relative to `from`), all exact.
std::optional<Crossing> meet_in_plane(const RayVec& along, const RayVec& p, const RayVec& q) noexcept {
    const RayVec edge = q - p;
    const RayVec normal = cross(along, edge);
    if (is_zero(normal)) {
        // Parallel, or the edge is a point.
        if (!is_zero(cross(along, p)) || !is_zero(cross(along, q))) return std::nullopt;
        const RayNumber size = dot(along, along);
        const RayNumber at_p = dot(p, along);
        const RayNumber at_q = dot(q, along);
        const RayNumber& first = compare(at_p, at_q) <= 0 ? at_p : at_q;
        const RayNumber& last = compare(at_p, at_q) <= 0 ? at_q : at_p;
        if (last.sign() < 0 || compare(first, size) > 0) return std::nullopt;
        if (first.sign() <= 0) return Crossing{0, Feature::edge};
        return Crossing{ratio(first, size), Feature::vertex};
    }
    const RayNumber size = dot(normal, normal);
    const RayNumber t = dot(cross(p, edge), normal);
    const RayNumber s = dot(cross(p, along), normal);
    if (dot(p, normal).sign() != 0) return std::nullopt;
    if (t.sign() < 0 || compare(t, size) > 0 || s.sign() < 0 || compare(s, size) > 0) return std::nullopt;
    const bool at_end = s.sign() == 0 || compare(s, size) == 0;
    return Crossing{smaller(1, ratio(t, size)), at_end ? Feature::vertex : Feature::edge};
}

// The ray lies in the triangle's plane, or the triangle has no area: it meets what edges it meets.
std::optional<Crossing> first_edge_met(const Vec (&corners)[3], const Vec& from, const Vec& to) noexcept {
    const RayVec origin = to_exact<RayNumber>(from);
    const RayVec along = to_exact<RayNumber>(to) - origin;
    const RayVec exact_corners[3] = {to_exact<RayNumber>(corners[0]) - origin, to_exact<RayNumber>(corners[1]) - origin,
                                     to_exact<RayNumber>(corners[2]) - origin};
    const RayVec normal = cross(exact_corners[1] - exact_corners[0], exact_corners[2] - exact_corners[0]);
    if (!is_zero(normal)) {
        bool inside = true;
        for (int i = 0; i < 3; ++i) {
            const RayVec& a = exact_corners[i];
            inside = inside && dot(cross(exact_corners[(i + 1) % 3] - a, -a), normal).sign() >= 0;
        }
        if (inside) return Crossing{0, Feature::face};
    }
    std::optional<Crossing> first;
    for (int i = 0; i < 3; ++i) {
        const auto crossing = meet_in_plane(along, exact_corners[i], exact_corners[(i + 1) % 3]);
        if (crossing && (!first || crossing->t < first->t)) first = crossing;
    }
    return first;
}

Hit make_hit(double t, const Vec& from, const Vec& to, const Vec& normal, Feature feature) noexcept {
    Hit hit;
    hit.t = t;
    hit.point = to_dvec3(from + (to - from) * t);
    const Vec zero;
    hit.normal = to_dvec3(normal + zero);  // no -0 to puzzle a reader
    hit.feature = feature;
    hit.started_inside = t == 0;
    return hit;
}

// `start` and `end` are the sides of the plane on which the ray starts and ends, not both zero and not alike.
std::optional<Hit> cross_face(const Vec (&corners)[3], const Vec& from, const Vec& to, int start, int end) noexcept {
    // The line runs through the closed triangle when all three edges are passed on one side.
    int sides[3];
    int on_lines = 0;
    bool left = false;
    bool right = false;
    for (int i = 0; i < 3; ++i) {
        sides[i] = side_of_plane(from, to, corners[i], corners[(i + 1) % 3]);
        left = left || sides[i] > 0;
        right = right || sides[i] < 0;
        on_lines += sides[i] == 0 ? 1 : 0;
    }
    if (left && right) return std::nullopt;

    const Vec along = to - from;
    Vec normal = unit(accurate_cross(scaled_to_one(enlarged(corners[1] - corners[0])),
                                     scaled_to_one(enlarged(corners[2] - corners[0]))));
    if (start < 0 || (start == 0 && end > 0)) normal = -normal;
    // Edges whose difference doubles have lost leave no face, though the exact sides know one.
    if (normal == Vec{}) normal = -unit(enlarged(along));
    // The nearest corner gives the height its best digits.
    double height = 0;
    double nearest = -1;
    for (const Vec& corner : corners) {
        const double distance = norm1(corner - from);
        if (nearest >= 0 && distance >= nearest) continue;
        nearest = distance;
        height = dot(normal, from - corner);
    }
    const double approach = -dot(normal, along);
    const bool on_plane = start == 0 || height <= 0;
    const double t = on_plane ? 0 : (approach > 0 ? smaller(1, height / approach) : 1);
    const Feature feature = on_lines == 0 ? Feature::face : (on_lines == 1 ? Feature::edge : Feature::vertex);
    return make_hit(t, from, to, normal, feature);
}

}  // namespace

std::optional<Hit> ray(const Motion& motion, const Triangle& triangle, const SweepOptions& options) noexcept {
    const internal::IeeeGuard guard;
    if (!is_valid_point(motion.from) || !is_valid_point(motion.to) || !is_valid_triangle(triangle)) {
        Hit hit;
        hit.status = HitStatus::invalid;
        return hit;
    }
    const Vec from = to_vec(motion.from);
    const Vec to = to_vec(motion.to);
    if (from == to) return std::nullopt;
    if (options.one_sided && approach_to_front(motion, triangle) != Approach::deeper) return std::nullopt;

    const Vec corners[3] = {to_vec(triangle.a), to_vec(triangle.b), to_vec(triangle.c)};
    const int start = side_of_plane(corners[0], corners[1], corners[2], from);
    const int end = side_of_plane(corners[0], corners[1], corners[2], to);
    if (start * end > 0) return std::nullopt;
    if (start != 0 || end != 0) return cross_face(corners, from, to, start, end);
    const auto crossing = first_edge_met(corners, from, to);
    if (!crossing) return std::nullopt;
    return make_hit(crossing->t, from, to, -unit(enlarged(to - from)), crossing->feature);
}

}  // namespace v0
}  // namespace surefoot
