// Where nobody is to set foot, though feet could.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include <surefoot/character.hpp>
#include <surefoot/navigation_build.hpp>

#include "frame.hpp"

namespace surefoot::navigation {

struct Forbidden {
    std::span<const NavigationRegion> regions;
    std::span<const std::uint32_t> surface_areas;

    [[nodiscard]] bool any() const {
        return !regions.empty() ||
               std::find(surface_areas.begin(), surface_areas.end(), forbidden_area) != surface_areas.end();
    }

    /// Does somebody with feet there stand where nobody is to?
    [[nodiscard]] bool holds(const CharacterState& state, const dvec3& feet) const {
        if (state.footing != Footing::ground) return false;
        if (state.ground_surface < surface_areas.size() && surface_areas[state.ground_surface] == forbidden_area)
            return true;
        return std::any_of(regions.begin(), regions.end(), [&](const NavigationRegion& region) {
            const dvec3 inside = to_body(region.pose, feet);
            return region.kind == NavigationRegion::Kind::forbid && std::abs(inside.x) <= region.half_extents.x &&
                   std::abs(inside.y) <= region.half_extents.y && std::abs(inside.z) <= region.half_extents.z;
        });
    }
};

}  // namespace surefoot::navigation
