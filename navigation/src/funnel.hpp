// The simple stupid funnel: the shortest line through a row of portals.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <surefoot/math.hpp>

namespace surefoot::navigation {

/// In the frame; heights are carried along and decide nothing.
struct Portal {
    dvec3 left{0, 0, 0};
    dvec3 right{0, 0, 0};
};

struct FunnelCorner {
    dvec3 position{0, 0, 0};
    std::size_t portals_before = 0;  ///< how many portals were crossed when the line bends here
};

/// Twice the area of a triangle seen from above, positive if c lies to the left of the way from a to b.
[[nodiscard]] inline double left_of(const dvec3& a, const dvec3& b, const dvec3& c) {
    return (c.x - a.x) * (b.z - a.z) - (b.x - a.x) * (c.z - a.z);
}

/// Where the shortest line from `from` to `to` bends; without the two ends. Method: Mikko Mononen, "Simple Stupid
/// Funnel Algorithm" (2010): a funnel from the last bend is narrowed portal by portal; where its sides would cross, the
/// line bends, and a new funnel opens there.
[[nodiscard]] std::vector<FunnelCorner> bends(const dvec3& from, std::span<const Portal> portals, const dvec3& to);

}  // namespace surefoot::navigation
