/// The judge: is this answer right? A verdict of `right` rests on certificates checked in rigorous intervals or exact
/// numbers; see docs/proof.md for what each verdict needs.
#pragma once

#include "query.hpp"

namespace judge {

enum class Verdict : std::uint8_t {
    right,
    miss,         ///< no hit reported, but the shape reaches the triangle
    late,         ///< a hit, but the shape cuts into the triangle before or at the reported t
    false_hit,    ///< a hit where there is none: no approach, or no contact within the bound, or none at all
    early,        ///< a hit, too far from the triangle at the reported t
    bad_normal,   ///< not unit, on the wrong side, or not that of the contact
    bad_point,    ///< not within the bound of triangle and shape
    bad_feature,  ///< the contact is not on such a feature
    bad_status,   ///< not finite, out of range, or the wrong status for this input
    unproved,     ///< no certificate was found, for or against: counts as a failure
};
inline constexpr int verdict_count = 10;

[[nodiscard]] const char* name_of(Verdict verdict) noexcept;

struct Judgement {
    Verdict verdict = Verdict::unproved;
    double gap = 0;        ///< of a hit: a rigorous upper bound on the distance at t, relative to what is allowed
    const char* why = "";  ///< one sentence
};

/// How far apart shape and triangle may be at a reported hit, relative to `largest(query)`.
inline constexpr double allowed_gap = 1e-10;

[[nodiscard]] Judgement judge(const Query& query, const Answer& answer);

}  // namespace judge
