// How every pair is swept: planes judge.
//
// A plane of unit normal n between the two shapes proves a gap that is linear in time, gap + t n.motion. So nothing can
// touch before that gap closes, and nothing ever touches if it does not close. Stand where the last plane closed, ask
// for the distance there and for the plane that proves it, go on. The distance is convex along a straight motion, so
// this is Newton's method from the side on which it cannot overshoot: exact after one plane on flat sides, quadratic on
// round ones (Mirtich, "Impulse-based dynamic simulation", 1996, calls it conservative advancement).
#pragma once

#include "pair/placed.hpp"

namespace surefoot::internal {

struct Advance {
    enum class Outcome { free, touches, starts_touching, overflows };
    Outcome outcome = Outcome::free;
    double t = 0;
    Gap gap;  ///< at `t`
};

inline constexpr int most_advances = 100;

/// `Pairing` has `Gap gap_at(const Vec& x)` and `double guess_entry(const Vec& x, const Vec& motion)`. `hair`: how
/// close counts as touching [m].
template <typename Pairing>
Advance advance(const Pairing& pairing, const PlacedPair& pair, const Vec& from, const Vec& motion,
                double hair) noexcept {
    Advance result;
    result.gap = pairing.gap_at(from);
    if (result.gap.is_deep || result.gap.most <= hair) {
        result.outcome = Advance::Outcome::starts_touching;
        return result;
    }
    // A guess is only a place to look for a plane: it is the plane that says how far is safe.
    Vec last = result.gap.normal;
    const double guess = pairing.guess_entry(from, motion);
    if (guess > 0 && guess <= 1) {
        const Vec n = pairing.gap_at(from + motion * guess).normal;
        const double speed = -dot(n, motion);
        const double gap = pair.gap_along(n, from) - hair / 2;
        if (gap > 0 && speed > 0) {
            result.t = gap / speed;
            last = n;
        }
    }
    for (int i = 0; i < most_advances; ++i) {
        if (result.t > 1) return result;
        if (result.t > 0) {
            const Vec x = from + motion * result.t;
            result.gap = pairing.gap_at(x);
            // Close to a touch the plane that led here, found from farther away, may know the normal better; and where
            // it still has a gap, cores that seem to overlap do so by rounding only.
            const double least = pair.gap_along(last, x);
            if (least > 0 && result.gap.is_deep) result.gap = Gap{.least = least, .most = least, .normal = last};
            if (least > result.gap.least) {
                result.gap.least = least;
                result.gap.normal = last;
            }
            last = result.gap.normal;
        }
        // Planes are closed to half a hair; a little more than that leaves room for rounding and is still a touch when
        // asked again.
        if (result.gap.most <= hair * 0.75 && !result.gap.is_deep) {
            result.outcome = Advance::Outcome::touches;
            return result;
        }
        const double speed = -dot(result.gap.normal, motion);
        if (!(result.gap.least > 0)) break;
        if (!(speed > 0)) return result;
        const double next = result.t + larger(result.gap.least - hair / 2, result.gap.least / 2) / speed;
        if (!(next > result.t)) {
            result.outcome = Advance::Outcome::touches;  // closer than time can tell apart
            return result;
        }
        result.t = next;
    }
    result.outcome = Advance::Outcome::overflows;
    return result;
}

}  // namespace surefoot::internal
