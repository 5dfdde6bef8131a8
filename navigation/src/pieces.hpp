// The ground of polygons as triangles that places are drawn from.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include <surefoot/navigation_query.hpp>

#include "mesh_state.hpp"

namespace surefoot::navigation {

struct QueryState;

class Pieces {
public:
    void add(dtPolyRef reference, const dtMeshTile& tile, const dtPoly& polygon);

    /// Each square metre is as likely as any other.
    [[nodiscard]] std::optional<NavigationPoint> draw(const QueryState& state, std::uint64_t seed) const;

private:
    /// A triangle of the fan that a polygon is, with the area of all before it.
    struct Piece {
        dtPolyRef polygon = 0;
        std::array<const float*, 3> corners{};  ///< in the tile, which must outlive this
        double area_before = 0;
    };
    std::vector<Piece> pieces_;
    double area_ = 0;
};

}  // namespace surefoot::navigation
