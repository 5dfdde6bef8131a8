// Box: M is a polytope. Its facets are parallel to a face of the box, to the triangle, or to an edge of one and an edge
// of the other: the 13 axes of the separating axis test, here with the motion. A polytope needs no root at all.
#include "fault.hpp"
#include "sweep/candidates.hpp"

namespace surefoot::internal {

void propose_planes(const SweepQuery& query, const Box&, Planes& planes) noexcept {
    const Vec axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    if (!has_fault(Fault::face_dropped)) planes.consider_both(query.face_normal());
    if (!has_fault(Fault::vertices_dropped)) {
        for (const Vec& axis : axes) planes.consider_both(axis);
    }
    for (int i = has_fault(Fault::first_edge_dropped) ? 1 : 0; i < 3; ++i) {
        if (planes.has_free_plane()) return;
        const Vec edge = scaled_to_one(query.edge_direction(i));
        for (const Vec& axis : axes) planes.consider_both(cross(edge, axis));
    }
}

}  // namespace surefoot::internal
