#include "sweep/sweep.hpp"

#include "fault.hpp"
#include "ieee_guard.hpp"
#include "limits.hpp"
#include "sweep/candidates.hpp"
#include "sweep/contact_point.hpp"
#include "sweep/deepest.hpp"
#include "sweep/face_first.hpp"
#include "sweep/planes.hpp"
#include "sweep/round_first.hpp"
#include "sweep/start.hpp"

namespace surefoot::internal {

namespace {

// How far apart shape and triangle may be where they are said to touch, as a share of the largest number in the query.
constexpr double allowed_gap = 1e-10;

// How far outside the shape a point may lie that says that they touch, in hairs: far less than the gap that is allowed.
constexpr double part_touching_hairs = 64;

void propose(const SweepQuery& query, Planes& planes) noexcept {
    std::visit([&](const auto& shape) { propose_planes(query, shape, planes); }, query.shape);
}

// The motion's direction in the shape's frame, between 1 and 4 long. A motion near the end of the doubles' range would
// lose its direction when it is turned.
Vec heading_of(const SweepQuery& query, const Motion& motion) noexcept {
    return query.frame.to_local(scaled_to_one(enlarged(to_vec(motion.to) - to_vec(motion.from))));
}

void propose_standing(const SweepQuery& query, const Motion& motion, Planes& planes) noexcept {
    if (std::holds_alternative<Cylinder>(query.shape) || std::holds_alternative<Cone>(query.shape)) {
        propose_upright_standing(query, heading_of(query, motion), planes);
        return;
    }
    SweepQuery standing = query;
    standing.along = {};
    propose(standing, planes);
}

Vec normal_in_world(const SweepQuery& query, const Plane& plane) noexcept {
    const Vec normal = has_fault(Fault::mirrored_normal) ? -plane.normal : plane.normal;
    if (has_fault(Fault::world_normal_not_unsquashed)) {
        if (const auto* ellipsoid = std::get_if<Ellipsoid>(&query.shape)) {
            return query.frame.to_world(unit(multiply_each(normal, to_vec(ellipsoid->radii))));
        }
    }
    const Vec zero;
    return query.frame.to_world(normal) + zero;  // no -0 to puzzle a reader
}

double reported_time(const SweepQuery& query, double t) noexcept {
    if (has_fault(Fault::one_ulp_late)) return t + t * 0x1p-52;
    if (has_fault(Fault::padding_along_velocity)) return larger(0, t - 0.001 / length(query.along));
    return t;
}

struct Described {
    Hit hit;
    bool touches;  ///< is the point of the triangle certainly one of the shape, too?
};

// A hit on these corners, at a point relative to `from` in the shape's frame.
Hit described(const SweepQuery& query, const Triangle& triangle, const Motion& motion, const Plane& plane, double t,
              unsigned corners, bool is_on_part, const Vec& point) noexcept {
    Hit hit;
    hit.t = reported_time(query, t);
    hit.triangle = query.triangle_id;
    hit.feature = feature_of(query, corners);
    hit.normal = to_dvec3(normal_in_world(query, plane));
    hit.point = to_dvec3(to_vec(motion.from) + query.frame.to_world(point));
    const dvec3* world[3] = {&triangle.a, &triangle.b, &triangle.c};
    for (unsigned i = 0; i < 3; ++i) {
        // A vertex is reported as the caller's own numbers.
        if (hit.feature == Feature::vertex && is_on_part && (corners & (1U << i)) != 0) {
            hit.point = *world[query.original[i]];
        }
    }
    return hit;
}

Described describe(const SweepQuery& query, const Triangle& triangle, const Motion& motion, const Planes& planes,
                   const Plane& plane, double t) noexcept {
    const double numbers =
        larger(larger(largest(to_vec(motion.from)), largest(to_vec(motion.to))),
               larger(largest(to_vec(triangle.a)), larger(largest(to_vec(triangle.b)), largest(to_vec(triangle.c)))));
    const Contact contact = contact_of(query, planes, plane, t, allowed_gap * numbers);
    const Hit hit = described(query, triangle, motion, plane, t, contact.corners, contact.is_on_part, contact.point);
    const double outside = at_most_outside_by(query.shape, contact.point - query.along * t);
    return {hit, contact.is_on_part && outside <= part_touching_hairs * planes.hair()};
}

Hit describe_face(const SweepQuery& query, const Motion& motion, const FaceFirst& face) noexcept {
    Hit hit;
    hit.t = reported_time(query, face.t);
    hit.triangle = query.triangle_id;
    hit.normal = to_dvec3(normal_in_world(query, face.plane));
    hit.point = to_dvec3(to_vec(motion.from) + query.frame.to_world(face.point));
    return hit;
}

void record_decision(Trace* trace, std::uint32_t id, const std::optional<Hit>& hit) noexcept {
    if (trace == nullptr) return;
    TraceRecord record;
    record.verdict = Verdict::decided;
    record.triangle = id;
    if (hit) {
        record.normal = hit->normal;
        record.t = hit->t;
        record.feature = hit->feature;
    }
    trace->push(record);
}

std::optional<Hit> hit_from_start(const SweepQuery& query, const Volume& volume, const Motion& motion,
                                  const Triangle& triangle, const Planes& planes, StartSign sign) noexcept {
    if (has_fault(Fault::start_in_touch_ignored)) return std::nullopt;
    const Vec heading = heading_of(query, motion);
    Plane nearest = planes.shallowest(heading);
    // All of it within 1e-300 m of a point: no direction was left for a plane but the motion's own.
    if (nearest.normal == Vec{}) nearest.normal = -unit(heading);
    const bool in_doubles = sign == StartSign::rounded || has_fault(Fault::approach_in_doubles);
    const Approach approach = !in_doubles            ? approach_at_start(volume, motion, triangle)
                              : nearest.approach < 0 ? Approach::deeper
                                                     : Approach::no_closer;
    if (approach == Approach::overflow) {
        Hit hit = blocked(HitStatus::overflow);
        hit.triangle = query.triangle_id;
        return hit;
    }
    planes.record_contact(nearest);
    if (approach == Approach::no_closer && !has_fault(Fault::start_in_touch_always_blocks)) return std::nullopt;
    Hit hit = describe(query, triangle, motion, planes, nearest, 0).hit;
    hit.started_inside = planes.starts_inside();
    return hit;
}

bool faces(const Motion& motion, const Triangle& triangle) noexcept {
    if (has_fault(Fault::one_sided_by_rounding)) {
        const Vec a = to_vec(triangle.a);
        const Vec normal = cross(to_vec(triangle.b) - a, to_vec(triangle.c) - a);
        return dot(to_vec(motion.to) - to_vec(motion.from), normal) < 0;
    }
    return approach_to_front(motion, triangle) == Approach::deeper;
}

RoundFirst ask_one_feature(const SweepQuery& query, const FaceFirst& face, double limit) noexcept {
    if (const auto* sphere = std::get_if<Sphere>(&query.shape)) return ask_round_first(query, *sphere, face, limit);
    if (const auto* ellipsoid = std::get_if<Ellipsoid>(&query.shape)) {
        return ask_round_first(query, *ellipsoid, face, limit);
    }
    if (const auto* capsule = std::get_if<Capsule>(&query.shape)) return ask_round_first(query, *capsule, face, limit);
    return {};
}

RoundFirst ask_touching(const SweepQuery& query) noexcept {
    if (const auto* sphere = std::get_if<Sphere>(&query.shape)) return ask_touching_feature(query, *sphere);
    if (const auto* ellipsoid = std::get_if<Ellipsoid>(&query.shape)) return ask_touching_feature(query, *ellipsoid);
    return {};
}

// What most sweeps are: the face settles it, or a feature that is clearly entered and a touch that is found there.
struct Quick {
    bool decided = false;
    std::optional<Hit> hit{};
};

Quick decide_quickly(const SweepQuery& query, const Motion& motion, const Triangle& triangle, double limit,
                     StartSign sign) noexcept {
    FaceFirst face = ask_face_first(query, limit);
    if (sign == StartSign::rounded && face.verdict == FaceFirst::Verdict::undecided) {
        face = ask_touching_face(query, face);
    }
    if (face.verdict == FaceFirst::Verdict::free) return {true};
    if (face.verdict == FaceFirst::Verdict::hit) return {true, describe_face(query, motion, face)};
    RoundFirst round = ask_one_feature(query, face, limit);
    if (sign == StartSign::rounded && round.verdict == RoundFirst::Verdict::undecided) round = ask_touching(query);
    if (round.verdict == RoundFirst::Verdict::free) return {true};
    if (round.verdict == RoundFirst::Verdict::hit) {
        return {true, described(query, triangle, motion, round.plane, round.t, round.corners, true, round.point)};
    }
    Planes planes(query, Ask::entries, limit, nullptr);
    propose(query, planes);
    if (planes.has_free_plane()) return {true};
    if (!planes.enters_clearly()) return {};
    const double t = planes.time_of_last();
    const Described found = describe(query, triangle, motion, planes, planes.steadiest_at(t), t);
    if (!found.touches) return {};
    return {true, found.hit};
}

std::optional<Hit> decide(const SweepQuery& query, const Volume& volume, const Motion& motion, const Triangle& triangle,
                          double limit, Trace* trace, StartSign sign) noexcept {
    const Quick quick = decide_quickly(query, motion, triangle, limit, sign);
    if (quick.decided && trace == nullptr) return quick.hit;
    Planes planes(query, Ask::everything, limit, trace);
    propose(query, planes);
    if (quick.decided) return quick.hit;
    if (!planes.motion_is_free() && !planes.starts_apart()) {
        // In touch at the start, by these planes. Ask those of the standing shape too.
        propose_standing(query, motion, planes);
    }
    if (planes.motion_is_free()) return std::nullopt;
    if (!planes.starts_apart()) return hit_from_start(query, volume, motion, triangle, planes, sign);

    if (sign == StartSign::exact && (planes.grazes_last() || planes.may_slip_by()) &&
        approach_at_start(volume, motion, triangle) == Approach::no_closer) {
        return std::nullopt;  // g is convex: what does not come closer at the start never does
    }
    const double t = smaller(1, planes.time_of_last());
    return describe(query, triangle, motion, planes, planes.steadiest_at(t), t).hit;
}

}  // namespace

Hit blocked(HitStatus status) noexcept {
    Hit hit;
    hit.status = status;
    return hit;
}

bool is_valid_query(const Volume& volume, const Motion& motion) noexcept {
    return is_valid(volume) && is_valid_point(motion.from) && is_valid_point(motion.to);
}

std::optional<Hit> sweep_triangle(const Volume& volume, const Motion& motion, const Triangle& triangle,
                                  std::uint32_t id, bool one_sided, double limit, Trace* trace,
                                  StartSign sign) noexcept {
    // Standing still comes no closer to anything.
    if (to_vec(motion.from) == to_vec(motion.to)) return std::nullopt;
    if (has_fault(Fault::absolute_epsilon) && length(to_vec(motion.to) - to_vec(motion.from)) < 1e-5)
        return std::nullopt;
    if (one_sided && !faces(motion, triangle)) return std::nullopt;
    const SweepQuery query(volume, motion, triangle, id);
    const std::optional<Hit> hit = decide(query, volume, motion, triangle, limit, trace, sign);
    record_decision(trace, id, hit);
    return hit;
}

}  // namespace surefoot::internal

namespace surefoot {
inline namespace v0 {

std::optional<Hit> sweep(const Volume& volume, const Motion& motion, const Triangle& triangle,
                         const SweepOptions& options, Trace* trace) noexcept {
    const internal::IeeeGuard guard;
    if (!internal::is_valid_query(volume, motion) || !internal::is_valid_triangle(triangle)) {
        return internal::blocked(HitStatus::invalid);
    }
    return internal::sweep_triangle(volume, motion, triangle, 0, options.one_sided, 1, trace);
}

}  // namespace v0
}  // namespace surefoot
