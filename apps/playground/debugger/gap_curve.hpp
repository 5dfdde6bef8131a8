/// g(t), the signed distance between shape and triangle along the motion: above 0 the gap, below 0 the depth. Convex,
/// because it is the distance to the convex set M = T + (-K); where it first comes down to 0 is the answer.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

namespace surefoot::debugger {

enum class GapSpace : std::uint8_t {
    world,     ///< metres
    squashed,  ///< where the ellipsoid is the ball of radius 1: shares of a radius
};

struct GapSample {
    double t = 0;
    double g = 0;
};

struct GapCurve {
    GapSpace space = GapSpace::world;
    std::string method;              ///< how g was found, in a sentence
    std::vector<GapSample> samples;  ///< evenly spaced in t, both ends included
    std::optional<double> t_star;    ///< the library's answer
    double g_at_t_star = 0;          ///< 0 to rounding, unless the motion starts in touch
};

/// g at one place. Exact to rounding for sphere and ellipsoid: the distance of the centre to the triangle, minus the
/// radius. For the others the distance by Gilbert, Johnson and Keerthi while they are apart, and minus the depth that
/// the library's `overlap` tells while they touch.
[[nodiscard]] double gap_at(const Volume& volume, const dvec3& position, const Triangle& triangle);

/// Requires: a valid question, `count` >= 2.
[[nodiscard]] GapCurve gap_curve(const Volume& volume, const Motion& motion, const Triangle& triangle,
                                 std::size_t count = 200, bool one_sided = false);

}  // namespace surefoot::debugger
