// Upright cylinder: the patches of M are the caps, the triangle's plane, the wall against an edge (edge x axis), the
// wall against a vertex (a circle, seen along the axis), and either rim against an edge.
#include "fault.hpp"
#include "sweep/candidates.hpp"
#include "sweep/rim.hpp"
#include "sweep/round_features.hpp"

namespace surefoot::internal {

void propose_planes(const SweepQuery& query, const Cylinder& cylinder, Planes& planes) noexcept {
    const Vec axis{0, 1, 0};
    const Vec rim_centres[2] = {{0, -cylinder.half_height, 0}, {0, cylinder.half_height, 0}};

    if (!has_fault(Fault::face_dropped)) {
        planes.consider_both(axis);
        planes.consider_both(query.face_normal());
    }
    for (int i = has_fault(Fault::first_edge_dropped) ? 1 : 0; i < 3; ++i) {
        if (planes.has_free_plane()) return;
        const Vec edge = query.edge_direction(i);
        planes.consider_both(cross(scaled_to_one(edge), axis));
        for (const Vec& centre : rim_centres) {
            planes.consider_pass(rim_against_line(query.edge_start(i) - centre, edge, query.along, cylinder.radius,
                                                  query.edge_hairs(i)));
        }
    }
    if (has_fault(Fault::vertices_dropped)) return;
    for (int i = 0; i < 3; ++i) {
        if (planes.has_free_plane()) return;
        const Ball seen_along_axis{.radius = cylinder.radius, .hairs = query.corner_hairs(i)};
        planes.consider_pass(ball_against_line(query.corners[i], axis, query.along, seen_along_axis));
    }
}

}  // namespace surefoot::internal
