/// Which side of zero are the signed distance g and its slope at one time of the motion? This decides what starts in
/// touch. g(x) = max over unit n of (n.x - h(n)), so the slope of g along d is the largest n.d among the *active*
/// normals, those that attain the maximum (Danskin).
#pragma once

#include "dyadic.hpp"

namespace judge {

struct StartSigns {
    int depth = unsure;  ///< sign of g: 1 apart, 0 touching, -1 overlapping
    int slope = unsure;  ///< sign of g'(t+): -1 approaching
    double g = 0;        ///< about g, in squashed space for an ellipsoid; only to compare normals with
};

/// At time t of the motion.
[[nodiscard]] StartSigns start_signs(const Query& query, double t);

/// For sphere, ellipsoid, capsule and box: exact.
[[nodiscard]] StartSigns polytope_start(const Query& query, double t);

/// For cylinder and cone: in long doubles if they are clear, else in floats of 2560 bits. There a depth or slope below
/// 2^-360 of the largest number or of the motion counts as zero; one between that and 2^-340 is `unsure`.
/// Where a coordinate is next to zero the two are 2^-1300 and 2^-1280 for depths.
[[nodiscard]] StartSigns curved_start(const Query& query, double t);

/// For cylinder and cone: is it at some time nearer to the triangle, or deeper in it, than at the start? Then it
/// approaches, by however little, as g is convex. Asked only where a coordinate is next to zero: there a slope may be
/// that slight, and along a rim's normal `curved_start` takes it for zero.
[[nodiscard]] bool curved_comes_closer(const Query& query);

/// Does a cylinder or cone that starts apart ever meet the triangle?
struct Pass {
    int meets = unsure;    ///< 1 or -1
    V3<Dyadic> planes[2];  ///< if it does not: normals, one of which separates; to be checked
    int count = 0;
};

/// In floats of 2560 bits: every normal bounds the times at which the two may meet, until none are left or they do.
[[nodiscard]] Pass curved_pass(const Query& query);

}  // namespace judge
