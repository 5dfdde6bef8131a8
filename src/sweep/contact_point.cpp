#include "sweep/contact_point.hpp"

#include "nearest.hpp"
#include "sweep/deepest.hpp"

namespace surefoot::internal {

namespace {

// On the part of the triangle that the plane touches.
Vec point_on_part(const Shape& shape, const Vec (&corners)[3], unsigned part, double margin) noexcept {
    for (unsigned i = 0; i < 3; ++i) {
        if (part == 1U << i) return corners[i];
        const unsigned j = (i + 1) % 3;
        if (part == (1U << i | 1U << j)) return deepest_on_segment(shape, corners[i], corners[j], margin);
    }
    return deepest_on_triangle(shape, corners, margin);
}

Vec nearest_on_part(const Vec (&corners)[3], unsigned part, const Vec& p) noexcept {
    for (unsigned i = 0; i < 3; ++i) {
        if (part == 1U << i) return corners[i];
        const unsigned j = (i + 1) % 3;
        if (part == (1U << i | 1U << j)) return nearest_on_segment(p, corners[i], corners[j]);
    }
    return nearest_on_triangle(p, corners);
}

// Where an edge passes a flat cone's rim at a grazing angle, a hair of height is ten thousand hairs sideways, and a
// point within the hair by height may be far off the rim. By turns to the nearest point of cone and part, it comes
// nearer.
Vec drawn_to_cone(const Cone& cone, const Vec (&corners)[3], unsigned part, Vec point, double enough) noexcept {
    constexpr int most_turns = 32;
    for (int turn = 0; turn < most_turns; ++turn) {
        const Vec nearest = nearest_in_cone(cone, point);
        if (length(point - nearest) <= enough) break;
        const Vec next = nearest_on_part(corners, part, nearest);
        if (next == point) break;
        point = next;
    }
    return point;
}

}  // namespace

Contact contact_of(const SweepQuery& query, const Planes& planes, const Plane& plane, double t,
                   double allowed) noexcept {
    const double margin = planes.hair();
    // Moved out along the normal, so that it just touches; for a hit on the way that is a hair or less.
    const double gap = plane.gap + t * plane.approach;
    const Vec here = query.along * t;
    // An ellipsoid's way out is not along the normal; its nearest point is the same without it.
    const bool is_ellipsoid = std::holds_alternative<Ellipsoid>(query.shape);
    // Less deep than the gap that is allowed, the point of touch is as good as any, and it lies on the feature.
    const bool overlaps = gap < -margin && (is_ellipsoid || gap < -0.999 * allowed);
    const Vec touching = is_ellipsoid ? here : here - plane.normal * gap;
    const Vec at_touch[3] = {query.corners[0] - touching, query.corners[1] - touching, query.corners[2] - touching};
    Contact contact;
    const unsigned touched = touched_corners(query, plane.normal);
    contact.corners = touched;
    Vec point = point_on_part(query.shape, at_touch, contact.corners, margin);
    const auto look_on = [&](unsigned part, double slack) {
        // An edge is near enough, whatever rounding says of the face beside it; and it tells which feature was touched.
        if (part == 7 && outside_by(query.shape, point) <= margin) return;
        const Vec other = point_on_part(query.shape, at_touch, part, slack);
        if (outside_by(query.shape, other) >= outside_by(query.shape, point)) return;
        // A margin outside is a little more by rounding. That is no reason to leave the edge for a point that is not on
        // the part that the plane touches.
        const bool is_on_edge = part == 7 && contact.is_on_part && outside_by(query.shape, point) <= 2 * margin;
        if (is_on_edge && length(other - nearest_on_part(at_touch, touched, other)) > allowed) return;
        point = other;
        contact.is_on_part = !overlaps && part != 7;
        contact.corners = contact.is_on_part ? part : touched;
    };
    if (outside_by(query.shape, point) > margin) {
        // The corners of a sliver are so nearly in a row that the plane cannot tell on which of them the shape is.
        for (const unsigned part : {3U, 6U, 5U, 7U}) look_on(part, margin);
    }
    if (outside_by(query.shape, point) > margin) {
        // Where a flat side lies in the plane of the triangle, turning that plane by a rounding lifts it by more than a
        // hair.
        for (const unsigned part : {3U, 6U, 5U, 7U}) look_on(part, allowed / 4);
    }
    const auto* cone = std::get_if<Cone>(&query.shape);
    if (cone != nullptr && at_most_outside_by(query.shape, point) > allowed / 4) {
        point = drawn_to_cone(*cone, at_touch, contact.is_on_part ? contact.corners : 7, point, allowed / 4);
    }
    contact.point = point + touching;
    if (overlaps && outside_by(query.shape, contact.point - here) > margin) {
        const Vec now[3] = {query.corners[0] - here, query.corners[1] - here, query.corners[2] - here};
        // The whole triangle comes last: across a sliver a point is less certain than on an edge.
        Vec deepest = point_on_part(query.shape, now, 3, margin);
        for (const unsigned part : {6U, 5U, 7U}) {
            const Vec other = point_on_part(query.shape, now, part, margin);
            if (outside_by(query.shape, other) < outside_by(query.shape, deepest)) deepest = other;
        }
        contact.point = deepest + here;
        contact.is_on_part = false;
    }
    return contact;
}

}  // namespace surefoot::internal
