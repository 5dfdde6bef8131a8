/// Which side of zero are the signed distance g and its slope at one time of the motion? This decides what starts in
/// touch. g(x) = max over unit n of (n.x - h(n)), so the slope of g along d is the largest n.d among the *active*
/// normals, those that attain the maximum (Danskin).
#pragma once

#include "vec.hpp"

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

/// For cylinder and cone: in long doubles if they are clear, else in floats of 384 bits, where what differs by less
/// than 1e-60 of the largest number counts as equal.
[[nodiscard]] StartSigns curved_start(const Query& query, double t);

}  // namespace judge
