// Nearest feature, its plane, the time at which that gives way; again from there until the feature stays the same
// (conservative advancement, but each step is the closed form of a whole feature, so that two are nearly always enough:
// Mirtich, "Impulse-based Dynamic Simulation of Rigid Body Systems" (1996), advances by bounds instead). The features
// come from Ericson, "Real-Time Collision Detection" (2005), 5.1.5. Whatever it finds is checked, and where a contact
// is within rounding of a neighbouring feature it leaves the answer to the full search, which weighs all of them.
#include "sweep/round_first.hpp"

#include <bit>

#include "fault.hpp"
#include "sweep/round_features.hpp"

namespace surefoot::internal {

namespace {

constexpr int most_steps = 3;

// How far beyond the end of an edge, as a share of the radius, a contact must lie to be clearly the corner's. The
// planes of edge and corner are as good there to within the square of it.
constexpr double clearly_beyond = 0x1p-19;

// How far outside the shape the contact may be computed to lie, in hairs. The gap that is allowed is far more.
constexpr double touching_hairs = 64;

// The triangle where the shape is a ball.
struct Squashed {
    Vec corners[3];
    Vec edges[3];  // the query's directions squashed, as the full search has them: not differences of these corners
    Vec along;
    double radius;

    [[nodiscard]] const Vec& edge_start(int i) const noexcept { return corners[i == 2 ? 0 : i]; }
};

// The corners at the ends of an edge, in canonical order.
constexpr unsigned ends_of[3] = {1U | 2U, 2U | 4U, 1U | 4U};

constexpr int edge_of(unsigned ends) noexcept {
    return ends == ends_of[0] ? 0 : (ends == ends_of[1] ? 1 : 2);
}

// The feature that is nearest to a point, as the bits of its corners; 7 for the face.
unsigned nearest_feature(const Squashed& triangle, const Vec& point) noexcept {
    const Vec ab = triangle.corners[1] - triangle.corners[0];
    const Vec ac = triangle.corners[2] - triangle.corners[0];
    const Vec from_a = point - triangle.corners[0];
    const double d1 = dot(ab, from_a);
    const double d2 = dot(ac, from_a);
    if (d1 <= 0 && d2 <= 0) return 1;
    const Vec from_b = point - triangle.corners[1];
    const double d3 = dot(ab, from_b);
    const double d4 = dot(ac, from_b);
    if (d3 >= 0 && d4 <= d3) return 2;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return 1U | 2U;
    const Vec from_c = point - triangle.corners[2];
    const double d5 = dot(ab, from_c);
    const double d6 = dot(ac, from_c);
    if (d6 >= 0 && d5 <= d6) return 4;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return 1U | 4U;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return 2U | 4U;
    return 7;
}

bool is_left_out(unsigned feature) noexcept {
    return (has_fault(Fault::vertices_dropped) && std::has_single_bit(feature)) ||
           (has_fault(Fault::first_edge_dropped) && feature == ends_of[0]);
}

// Where on the feature the ball's centre is nearest to it, if that is clearly within the feature.
struct Place {
    bool is_clear = false;
    Vec squashed;  // in the ball's space
    Vec point;     // in the shape's frame
};

Place place_on(const SweepQuery& query, const Squashed& triangle, unsigned feature, const Vec& centre) noexcept {
    if (std::has_single_bit(feature)) {
        const int corner = std::countr_zero(feature);
        const Vec& at = triangle.corners[corner];
        for (int i = 0; i < 3; ++i) {
            if ((ends_of[i] & feature) == 0) continue;
            const Vec edge = triangle.edges[i];
            const bool is_start = (i == 2 ? 0 : i) == corner;
            const double beyond = (is_start ? -1 : 1) * dot(edge, centre - at);
            const double clearly = clearly_beyond * triangle.radius;
            if (!(beyond > 0 && beyond * beyond > clearly * clearly * dot(edge, edge))) return {};
        }
        return {true, at, query.corners[corner]};
    }
    const int i = edge_of(feature);
    const Vec start = triangle.edge_start(i);
    const Vec edge = triangle.edges[i];
    const double share = dot(centre - start, edge) / dot(edge, edge);
    if (!(share >= 0 && share <= 1) && !has_fault(Fault::guess_believed)) return {};
    return {true, start + edge * share, query.edge_start(i) + query.edge_direction(i) * share};
}

RoundNormals normals_of(const SweepQuery& query, const Squashed& triangle, unsigned feature, Ball ball) noexcept {
    if (std::has_single_bit(feature)) {
        const int corner = std::countr_zero(feature);
        ball.hairs = query.corner_hairs(corner);
        return ball_against_point(triangle.corners[corner], triangle.along, ball);
    }
    const int i = edge_of(feature);
    ball.hairs = query.edge_hairs(i);
    return ball_against_line(triangle.edge_start(i), triangle.edges[i], triangle.along, ball);
}

// Where a face is met together with its edge, its normal is the steadier answer. No area, no face: then others know.
bool face_is_as_near(const SweepQuery& query, const Plane& face, double t, double hair) noexcept {
    if (face.normal == Vec{}) return true;
    const double gap = face.gap + t * face.approach;
    const double behind = -gap - 2 * reach_against(query.shape, face.normal);
    return larger(gap, behind) > -2 * hair;
}

RoundFirst ask(const SweepQuery& query, const Ball& ball, const FaceFirst& face, double limit) noexcept {
    RoundFirst first;
    // Faults that the full search makes when it proposes planes have to come to light.
    if (has_fault(Fault::parallel_skipped) || has_fault(Fault::face_dropped)) return first;
    Squashed triangle;
    for (int i = 0; i < 3; ++i) {
        triangle.corners[i] = divide_each(query.corners[i], ball.squash);
        triangle.edges[i] = divide_each(query.edge_direction(i), ball.squash);
    }
    triangle.along = divide_each(query.along, ball.squash);
    triangle.radius = ball.radius;

    double hair = 2 * query.shape_slack;
    for (const double slack : query.corner_slack) hair += slack;
    const bool enters_face = face.plane.gap > 0 && face.plane.gap + face.plane.approach <= 0;
    double t = enters_face ? face.plane.gap / -face.plane.approach : 0;
    unsigned known = 7;
    for (int step = 0; step < most_steps; ++step) {
        const unsigned feature = nearest_feature(triangle, triangle.along * t);
        if (feature == 7 || feature == known || is_left_out(feature)) return first;
        known = feature;
        const RoundNormals normals = normals_of(query, triangle, feature, ball);
        const bool passes = normals.entry == Vec{};
        const Vec normal = unit(divide_each(passes ? normals.passing : normals.entry, ball.squash));
        if (normal == Vec{}) return first;
        const Plane plane = judged(query, normal);
        if (passes) {
            // It keeps away from this feature; if from the whole triangle, that plane says so.
            if (plane.gap > 0 && plane.gap + plane.approach > 0) first.verdict = RoundFirst::Verdict::free;
            return first;
        }
        if (!(plane.gap > 8 * hair) || is_grazed(query, plane)) return first;
        const bool ends_apart = plane.gap + plane.approach > 0 && !has_fault(Fault::far_end_ignored);
        if (ends_apart || (limit < 1 && plane.gap + limit * plane.approach > 2 * hair)) {
            first.verdict = RoundFirst::Verdict::free;
            return first;
        }
        t = smaller(1, plane.gap / -plane.approach);
        const Vec centre = triangle.along * t;
        const Place place = place_on(query, triangle, feature, centre);
        if (!place.is_clear) continue;
        const double outside = (length(place.squashed - centre) - ball.radius) * largest(ball.squash);
        if (outside > touching_hairs * hair && !has_fault(Fault::guess_believed)) continue;
        if (face_is_as_near(query, face.plane, t, hair)) return first;
        if (touched_corners(query, normal) != feature && !has_fault(Fault::guess_believed)) return first;
        first = {RoundFirst::Verdict::hit, plane, t, place.point, feature};
        return first;
    }
    return first;
}

}  // namespace

RoundFirst ask_round_first(const SweepQuery& query, const Sphere& sphere, const FaceFirst& face,
                           double limit) noexcept {
    return ask(query, {.radius = sphere.radius, .hairs = {}}, face, limit);
}

RoundFirst ask_round_first(const SweepQuery& query, const Ellipsoid& ellipsoid, const FaceFirst& face,
                           double limit) noexcept {
    return ask(query, {.radius = 1, .hairs = {}, .squash = to_vec(ellipsoid.radii)}, face, limit);
}

}  // namespace surefoot::internal
