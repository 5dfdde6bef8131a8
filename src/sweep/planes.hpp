// The judgement of planes, which every shape shares.
//
// M = T (+) (-K) is convex, and the shape's reference point moves along a line. A plane with normal n, pushed against
// the triangle from the shape's side, leaves the gap
//
//     gap(n, t) = n . x(t) - max over T of n . v - max over K of -n . k
//
// which is linear in t and, for a unit normal, never more than the true distance. Therefore:
//  - while any plane has a gap, there is no touch: the last plane to give way is the answer, and it cannot be late;
//  - a plane with a gap at both ends of the motion proves that there is no touch at all;
//  - two planes, one that the motion leaves before it enters the other, prove the same: their combination that is
//    perpendicular to the motion has a gap throughout (M is an intersection of convex sets, and intervals on a line
//    that meet in pairs have a common point: Helly's theorem).
// Which planes are worth asking is what the closed forms of each shape know; a plane that was not worth asking does no
// harm. Every gap here is reduced by the rounding that it may contain, the hair.
#pragma once

#include <surefoot/trace.hpp>

#include "sweep/query.hpp"
#include "sweep/round_features.hpp"

namespace surefoot::internal {

/// A plane with its gap. All in the shape's frame.
struct Plane {
    Vec normal;           ///< unit, from the triangle towards the shape
    double gap = 0;       ///< at `from`, the hair taken off [m]
    double approach = 0;  ///< what the motion adds to the gap [m]: negative when it closes
};

/// The plane with this unit normal, pushed against the triangle.
[[nodiscard]] Plane judged(const SweepQuery& query, const Vec& normal) noexcept;

/// Which corners of the triangle (bits, canonical order) lie on the plane with this normal, within the rounding.
[[nodiscard]] unsigned touched_corners(const SweepQuery& query, const Vec& normal) noexcept;

/// Does a motion with this plane only graze it?
[[nodiscard]] inline bool is_grazed(const SweepQuery& query, const Plane& plane) noexcept {
    return -plane.approach <= 0x1p-16 * norm1(query.along);
}

/// Which of the planes that the closed forms know are asked.
enum class Ask : std::uint8_t {
    entries,     ///< those that the motion may enter by: enough for most that is met on the way
    everything,  ///< all of them: for starts in touch, for motions that graze, and to prove a miss
};

class Planes {
public:
    /// What is met after `limit` [0, 1] is of no interest, and may be taken for a free motion.
    Planes(const SweepQuery& query, Ask which, double limit, Trace* trace) noexcept
        : query_(query), trace_(trace), limit_(limit), which_(which) {
        hair_ = 2 * query.shape_slack;
        for (const double slack : query.corner_slack) hair_ += slack;
    }

    /// Judges the plane with this normal, of any length; zero is no plane and is passed over.
    void consider(const Vec& normal) noexcept;

    /// Judges the planes that a passing round feature proposes.
    void consider_pass(const RoundNormals& normals) noexcept {
        consider(normals.entry);
        if (which_ == Ask::entries) return;
        consider(normals.exit);
        consider(normals.passing);
        consider(normals.grazing_entry);
        consider(normals.grazing_exit);
    }

    /// Judges the plane and its opposite.
    void consider_both(const Vec& normal) noexcept {
        consider(normal);
        consider(-normal);
    }

    /// Is there a plane with a gap over the whole motion, or a combination of two? Call when all planes have been
    /// considered.
    [[nodiscard]] bool motion_is_free() noexcept;

    /// Has one plane with a gap over the whole motion been found? The others need not be asked.
    [[nodiscard]] bool has_free_plane() const noexcept { return free_; }

    /// Does the motion clearly enter the last plane, from clearly before it, and leave none before that? Then a touch
    /// found there is the answer.
    [[nodiscard]] bool enters_clearly() const noexcept {
        return has_last_ && last_.gap > 8 * hair_ && enter_ <= 1 && !is_grazed(query_, last_) &&
               !(has_leave_ && leave_ < enter_);
    }

    /// Does some plane have a gap at `from`?
    [[nodiscard]] bool starts_apart() const noexcept { return apart_; }

    /// Do shape and triangle touch or overlap at `from`, to half a hair? (A contact reported before is a whole hair
    /// off.)
    [[nodiscard]] bool starts_inside() const noexcept;

    /// When the last plane gives way. Requires: not motion_is_free(), starts_apart().
    [[nodiscard]] double time_of_last() const noexcept;

    /// Does the motion only graze the last plane?
    [[nodiscard]] bool grazes_last() const noexcept { return is_grazed(query_, last_); }

    /// Among planes that are as good as the last, the one that touches the most of the triangle: where a face and an
    /// edge are met together, the face's normal is the steadier answer.
    [[nodiscard]] Plane steadiest_at(double t) const noexcept;

    /// May shape and triangle be within the hair of each other at `from`, while the motion slides along one of the
    /// planes that are as near, or leaves it?
    [[nodiscard]] bool may_slip_by() const noexcept;

    /// The plane with the least depth at `from`; of several as near, one that a motion with this heading (in the
    /// shape's frame, between 1 and 4 long) closes on and that touches the most of the triangle.
    [[nodiscard]] Plane shallowest(const Vec& heading) const noexcept;

    /// Tells the trace that shape and triangle are in touch at `from`, and where.
    void record_contact(const Plane& nearest) const noexcept { record(nearest, Verdict::contact, 0); }

    [[nodiscard]] std::span<const Plane> all() const noexcept {
        return {room_.planes, static_cast<std::size_t>(count_)};
    }

    /// At least the rounding that any plane's gap may contain, once taken off and once more [m].
    [[nodiscard]] double hair() const noexcept { return hair_; }

private:
    void record(const Plane& plane, Verdict verdict, double t) const noexcept;

    static constexpr int most_planes = 160;

    const SweepQuery& query_;
    Trace* trace_;
    double limit_;
    double hair_;
    Ask which_;
    // Planes are put here one by one; clearing it first would cost as much as asking them.
    union Room {
        Room() noexcept {}
        Plane planes[most_planes];
    };
    Room room_;
    int count_ = 0;
    Plane last_;
    Plane first_to_open_;
    double enter_ = 0;
    double leave_ = 0;
    bool has_last_ = false;
    bool has_leave_ = false;
    bool free_ = false;
    bool apart_ = false;
};

/// Which edge (0: ab, 1: bc, 2: ca) or vertex (0: a, 1: b, 2: c) of the caller's triangle a set of corners is; 0 for a
/// face.
[[nodiscard]] std::uint8_t index_in_triangle(const SweepQuery& query, unsigned corners) noexcept;

/// Which part of the triangle a set of corners is.
[[nodiscard]] Feature feature_of(const SweepQuery& query, unsigned corners) noexcept;

}  // namespace surefoot::internal
