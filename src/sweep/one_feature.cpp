#include "sweep/one_feature.hpp"

namespace surefoot::internal {

// Ericson, "Real-Time Collision Detection" (2005), 5.1.5.
unsigned nearest_feature(const Vec (&corners)[3], const Vec& point) noexcept {
    const Vec ab = corners[1] - corners[0];
    const Vec ac = corners[2] - corners[0];
    const Vec from_a = point - corners[0];
    const double d1 = dot(ab, from_a);
    const double d2 = dot(ac, from_a);
    if (d1 <= 0 && d2 <= 0) return 1;
    const Vec from_b = point - corners[1];
    const double d3 = dot(ab, from_b);
    const double d4 = dot(ac, from_b);
    if (d3 >= 0 && d4 <= d3) return 2;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return 1U | 2U;
    const Vec from_c = point - corners[2];
    const double d5 = dot(ab, from_c);
    const double d6 = dot(ac, from_c);
    if (d6 >= 0 && d5 <= d6) return 4;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return 1U | 4U;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return 2U | 4U;
    return 7;
}

bool face_is_as_near(const SweepQuery& query, const Plane& face, double t, double hair) noexcept {
    if (face.normal == Vec{}) return true;
    const double gap = face.gap + t * face.approach;
    const double behind = -gap - 2 * reach_against(query.shape, face.normal);
    return larger(gap, behind) > -2 * hair;
}

}  // namespace surefoot::internal
