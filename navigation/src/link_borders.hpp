// Where a navigation mesh ends: its borders, as places to jump off and to land on.
#pragma once

#include <unordered_map>
#include <vector>

#include "mesh_state.hpp"

namespace surefoot::navigation {

/// A place on a border.
struct BorderPlace {
    dvec3 place{0, 0, 0};  ///< at the feet, in the world [m]
    dvec3 out{0, 0, 0};    ///< level, unit, away from the ground
    std::uint32_t island = 0;
    dtPolyRef polygon = 0;
};

/// Ground that walking joins is one island; polygons that were taken out are of none.
class Islands {
public:
    explicit Islands(const dtNavMesh& detour);
    [[nodiscard]] std::uint32_t of(dtPolyRef polygon) const;

private:
    std::unordered_map<dtPolyRef, std::uint32_t> islands_;
};

/// About one in `spacing` metres of border, tile by tile.
[[nodiscard]] std::vector<BorderPlace> border_places(const MeshState& state, const Islands& islands, double spacing);

}  // namespace surefoot::navigation
