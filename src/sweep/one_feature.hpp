// The one feature that a round shape meets, guessed and then proved: the nearest feature at a time, its plane, the time
// at which that gives way; again from there until the feature stays the same (conservative advancement, but each step
// is the closed form of a whole feature, so that two are nearly always enough: Mirtich, "Impulse-based Dynamic
// Simulation of Rigid Body Systems" (1996), advances by bounds instead). Whatever it finds is checked, and where a
// contact is within rounding of a neighbouring feature it leaves the answer to the full search, which weighs all of
// them.
#pragma once

#include <bit>

#include "fault.hpp"
#include "sweep/round_first.hpp"

namespace surefoot::internal {

/// How far beyond the end of an edge, as a share of the radius, a contact must lie to be clearly the corner's. The
/// planes of edge and corner are as good there to within the square of it.
inline constexpr double clearly_beyond = 0x1p-19;

/// The corners at the ends of an edge, as bits in canonical order; and the edge that has these ends.
inline constexpr unsigned ends_of[3] = {1U | 2U, 2U | 4U, 1U | 4U};
constexpr int edge_of(unsigned ends) noexcept {
    return ends == ends_of[0] ? 0 : (ends == ends_of[1] ? 1 : 2);
}

/// The feature of a triangle that is nearest to a point, as the bits of its corners; 7 for the face.
[[nodiscard]] unsigned nearest_feature(const Vec (&corners)[3], const Vec& point) noexcept;

/// A plane that a feature proposes.
struct Proposal {
    Vec normal;           ///< unit, in the shape's frame; zero for none
    bool passes = false;  ///< the motion passes the feature by: the plane can only prove that
};

/// Where a feature is met, if it is met there.
struct Place {
    bool is_clear = false;  ///< clearly within the feature, as seen from its neighbours
    double outside = 0;     ///< at most how far outside the shape the point is [m]
    Vec point;              ///< of the triangle, in the shape's frame, relative to `from`
};

inline bool is_left_out(unsigned feature) noexcept {
    return (has_fault(Fault::vertices_dropped) && std::has_single_bit(feature)) ||
           (has_fault(Fault::first_edge_dropped) && feature == ends_of[0]);
}

/// Where a face is met together with its edge, its normal is the steadier answer. No area, no face: then others know.
[[nodiscard]] bool face_is_as_near(const SweepQuery& query, const Plane& face, double t, double hair) noexcept;

/// Guess offers
///     Part nearest(double t)                     the nearest features of both: comparable, with the triangle's
///     `corners` Proposal propose(Part)                     their plane Place place(Part, double t, const Vec& n) where
///     they meet at t, if that is where the plane with normal n gives way
template <class Guess>
[[nodiscard]] RoundFirst settle_one_feature(const SweepQuery& query, const Guess& guess, const FaceFirst& face,
                                            double limit) noexcept {
    constexpr int most_steps = 3;
    // The gap that is allowed is far more than these hairs.
    constexpr double touching_hairs = 64;
    RoundFirst first;
    // Faults that the full search makes when it proposes planes have to come to light.
    if (has_fault(Fault::parallel_skipped) || has_fault(Fault::face_dropped)) return first;
    double hair = 2 * query.shape_slack;
    for (const double slack : query.corner_slack) hair += slack;
    const bool enters_face = face.plane.gap > 0 && face.plane.gap + face.plane.approach <= 0;
    double t = enters_face ? face.plane.gap / -face.plane.approach : 0;
    auto known = guess.none();
    for (int step = 0; step < most_steps; ++step) {
        const auto part = guess.nearest(t);
        if (part.corners == 7 || part == known || is_left_out(part.corners)) return first;
        known = part;
        const Proposal proposal = guess.propose(part);
        if (proposal.normal == Vec{}) return first;
        const Plane plane = judged(query, proposal.normal);
        if (proposal.passes) {
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
        const Place place = guess.place(part, t, proposal.normal);
        const bool is_believed = has_fault(Fault::guess_believed);
        if (!is_believed && !(place.is_clear && place.outside <= touching_hairs * hair)) continue;
        if (face_is_as_near(query, face.plane, t, hair)) return first;
        if (!is_believed && touched_corners(query, proposal.normal) != part.corners) return first;
        return {RoundFirst::Verdict::hit, plane, t, place.point, part.corners};
    }
    return first;
}

}  // namespace surefoot::internal
