#include <cmath>

#include <surefoot/navigation_build.hpp>

namespace surefoot {
inline namespace v0 {

std::vector<NavigationRegion> navigation_regions(std::span<const Marker> markers) {
    std::vector<NavigationRegion> regions;
    for (const Marker& marker : markers) {
        const bool forbids = marker.kind == "navigation_forbid";
        if (!forbids && marker.kind != "navigation_require") continue;
        // A mirrored box is the same box.
        const dvec3 half{std::abs(marker.scale.x), std::abs(marker.scale.y), std::abs(marker.scale.z)};
        regions.push_back({.name = marker.name,
                           .pose = {.position = marker.position, .orientation = marker.orientation},
                           .half_extents = half,
                           .kind = forbids ? NavigationRegion::Kind::forbid : NavigationRegion::Kind::require});
    }
    return regions;
}

}  // namespace v0
}  // namespace surefoot
