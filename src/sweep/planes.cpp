#include "sweep/planes.hpp"

#include <bit>
#include <new>

#include "fault.hpp"

namespace surefoot::internal {

Plane judged(const SweepQuery& query, const Vec& normal) noexcept {
    const double slack_share = has_fault(Fault::one_ulp_late) ? 0 : (has_fault(Fault::hair_too_thick) ? 0x1p20 : 1);
    double top = dot(normal, query.corners[0]) + slack_share * query.corner_slack[0];
    for (int i = 1; i < 3; ++i) {
        top = larger(top, dot(normal, query.corners[i]) + slack_share * query.corner_slack[i]);
    }
    return {.normal = normal,
            .gap = -top - reach_against(query.shape, normal) - slack_share * query.shape_slack,
            .approach = dot(normal, query.along)};
}

unsigned touched_corners(const SweepQuery& query, const Vec& normal) noexcept {
    double heights[3];
    int highest = 0;
    for (int i = 0; i < 3; ++i) {
        heights[i] = dot(normal, query.corners[i]);
        if (heights[i] > heights[highest]) highest = i;
    }
    unsigned corners = 0;
    for (int i = 0; i < 3; ++i) {
        const double rounding = 4 * (query.corner_slack[i] + query.corner_slack[highest]);
        if (heights[i] >= heights[highest] - rounding) corners |= 1U << i;
    }
    return corners;
}

void Planes::consider(const Vec& direction) noexcept {
    if (free_) return;
    const Vec normal = unit(direction);
    if (normal == Vec{}) return;
    const Plane plane = judged(query_, normal);
    if (count_ < most_planes) ::new (&room_.planes[count_++]) Plane(plane);

    const bool apart_at_from = plane.gap > 0;
    const bool apart_at_to = plane.gap + plane.approach > 0;
    apart_ = apart_ || apart_at_from;
    if (apart_at_from && apart_at_to && !(has_fault(Fault::far_end_ignored) && plane.approach < 0)) {
        free_ = true;
        record(plane, Verdict::separates, 0);
    } else if (limit_ < 1 && apart_at_from && plane.gap + limit_ * plane.approach > 2 * hair_) {
        free_ = true;  // until after the limit
    } else if (plane.approach < 0) {
        const double t = plane.gap / -plane.approach;
        if (!has_last_ || t > enter_) {
            has_last_ = true;
            enter_ = t;
            last_ = plane;
        }
        record(plane, Verdict::enters, t);
    } else if (plane.approach > 0) {
        const double t = -plane.gap / plane.approach;
        if (!has_leave_ || t < leave_) {
            has_leave_ = true;
            leave_ = t;
            first_to_open_ = plane;
        }
        record(plane, Verdict::leaves, t);
    } else {
        record(plane, Verdict::inside, 0);
    }
}

bool Planes::motion_is_free() noexcept {
    if (!free_ && has_last_ && has_leave_ && leave_ < enter_) {
        // The motion has left one side before it enters another. The combination is perpendicular to the motion.
        consider(last_.normal * first_to_open_.approach - first_to_open_.normal * last_.approach);
    }
    return free_;
}

double Planes::time_of_last() const noexcept {
    // A motion that passes within the hair leaves one plane before it enters the last. It is held where it still comes
    // nearer, if that is near enough.
    const bool passes = has_leave_ && leave_ < enter_ && leave_ > 0;
    return passes && last_.gap + leave_ * last_.approach <= hair() ? leave_ : enter_;
}

bool Planes::starts_inside() const noexcept {
    double half_hair = query_.shape_slack / 2;
    for (const double slack : query_.corner_slack) half_hair = larger(half_hair, slack / 2);
    for (const Plane& plane : all()) {
        if (plane.gap > -half_hair) return false;
    }
    return true;
}

Plane Planes::steadiest_at(double t) const noexcept {
    const double within = hair();
    Plane best = last_;
    int most = std::popcount(touched_corners(query_, last_.normal));
    for (const Plane& plane : all()) {
        const double gap = plane.gap + t * plane.approach;
        if (plane.approach >= 0 || gap < -within || gap > within) continue;
        const int touched = std::popcount(touched_corners(query_, plane.normal));
        if (touched > most) {
            most = touched;
            best = plane;
        }
    }
    return best;
}

bool Planes::may_slip_by() const noexcept {
    // What is asked of doubles here is only whether to ask exactly, so the margin is generous.
    const double near = 8 * hair();
    bool slips = false;
    for (const Plane& plane : all()) {
        if (plane.gap > near) return false;
        slips = slips || (plane.gap > -near && is_grazed(query_, plane));
    }
    return slips;
}

Plane Planes::shallowest(const Vec& heading) const noexcept {
    // An ellipsoid's depth counts in squashed space, where a plane of the world with normal n is |radii n| times as
    // far.
    const bool squashed = std::holds_alternative<Ellipsoid>(query_.shape);
    const auto depth_of = [&](const Plane& plane) {
        return squashed ? -plane.gap / reach_against(query_.shape, plane.normal) : -plane.gap;
    };
    const Plane* best = nullptr;
    for (const Plane& plane : all()) {
        if (best == nullptr || depth_of(plane) < depth_of(*best)) best = &plane;
    }
    if (best == nullptr) return {};
    // Of several as near, one that the motion clearly closes on, or else one that it slides along: the plane that
    // closes may do so by less than rounding. Of those, the one that touches the most of the triangle.
    const double least = depth_of(*best) + hair() * (squashed ? 1 / reach_against(query_.shape, best->normal) : 1);
    const auto rank = [&](const Plane& plane) {
        const double approach = dot(plane.normal, heading);
        constexpr double sliding = 0x1p-20;  // far above the rounding in normals, but for those of slivers
        return (approach < -sliding ? 16 : (approach < sliding ? 8 : 0)) +
               2 * std::popcount(touched_corners(query_, plane.normal)) + (approach < 0 ? 1 : 0);
    };
    int highest = rank(*best);
    for (const Plane& plane : all()) {
        if (depth_of(plane) > least || rank(plane) <= highest) continue;
        highest = rank(plane);
        best = &plane;
    }
    return *best;
}

void Planes::record(const Plane& plane, Verdict verdict, double t) const noexcept {
    if (trace_ == nullptr) return;
    const unsigned corners = touched_corners(query_, plane.normal);
    TraceRecord entry;
    entry.normal = to_dvec3(query_.frame.to_world(plane.normal));
    entry.gap_from = plane.gap;
    entry.gap_to = plane.gap + plane.approach;
    entry.t = t;
    entry.feature = feature_of(query_, corners);
    entry.feature_index = index_in_triangle(query_, corners);
    entry.verdict = verdict;
    entry.triangle = query_.triangle_id;
    trace_->push(entry);
}

std::uint8_t index_in_triangle(const SweepQuery& query, unsigned corners) noexcept {
    // In the caller's order: a vertex is its own number, an edge that of the corner it starts at.
    unsigned original = 0;
    for (unsigned i = 0; i < 3; ++i) {
        if ((corners & (1U << i)) != 0) original |= 1U << query.original[i];
    }
    switch (original) {
        case 2:      // b
        case 2 | 4:  // bc
            return 1;
        case 4:      // c
        case 4 | 1:  // ca
            return 2;
        default:
            return 0;
    }
}

Feature feature_of(const SweepQuery& query, unsigned corners) noexcept {
    // Corners in one place are one corner, and three in a row are an edge.
    int distinct = 0;
    Vec seen[3];
    for (unsigned i = 0; i < 3; ++i) {
        if ((corners & (1U << i)) == 0) continue;
        bool known = false;
        for (int j = 0; j < distinct; ++j) known = known || seen[j] == query.corners[i];
        if (!known) seen[distinct++] = query.corners[i];
    }
    if (distinct == 1) return Feature::vertex;
    if (distinct == 2) return Feature::edge;
    return query.face_normal() == Vec{} ? Feature::edge : Feature::face;
}

}  // namespace surefoot::internal
