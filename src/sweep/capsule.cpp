// Capsule: M is a prism, the triangle drawn out along the capsule's core, thickened by the radius. Its patches are the
// prism's faces moved out (the triangle's own plane, and each edge x axis), a cylinder about each of the prism's edges
// (three at either end, three along the axis), a ball about each of its corners.
#include "fault.hpp"
#include "sweep/candidates.hpp"
#include "sweep/round_features.hpp"

namespace surefoot::internal {

void propose_planes(const SweepQuery& query, const Capsule& capsule, Planes& planes) noexcept {
    const Vec axis{0, 1, 0};
    const Vec ends[2] = {{0, -capsule.half_height, 0}, {0, capsule.half_height, 0}};

    if (!has_fault(Fault::face_dropped)) planes.consider_both(query.face_normal());
    for (int i = has_fault(Fault::first_edge_dropped) ? 1 : 0; i < 3; ++i) {
        if (planes.has_free_plane()) return;
        const Vec edge = query.edge_direction(i);
        const Ball ball{.radius = capsule.radius, .hairs = query.edge_hairs(i)};
        planes.consider_both(cross(scaled_to_one(edge), axis));
        for (const Vec& end : ends) {
            planes.consider_pass(ball_against_line(query.edge_start(i) + end, edge, query.along, ball));
        }
    }
    if (has_fault(Fault::vertices_dropped)) return;
    for (int i = 0; i < 3; ++i) {
        if (planes.has_free_plane()) return;
        const Vec& corner = query.corners[i];
        const Ball ball{.radius = capsule.radius, .hairs = query.corner_hairs(i)};
        planes.consider_pass(ball_against_line(corner, axis, query.along, ball));
        for (const Vec& end : ends) planes.consider_pass(ball_against_point(corner + end, query.along, ball));
    }
}

}  // namespace surefoot::internal
