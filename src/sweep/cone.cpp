// Cone, standing on its apex: the patches of M are the flat disc, the triangle's plane, the side against an edge, the
// side against a vertex, and the rim of the disc against an edge.
//
// A side normal, from the triangle towards the cone, is (H h, R) with a sideways unit vector h: horizontally H h,
// upwards R.
//  - Side against edge e: the side normals perpendicular to e, h . e_h H + e.y R = 0: two of them, for any time.
//  - Side against vertex: the plane through the apex and the line on which the vertex moves cuts the cone in two
//    generators; the side normal of one of them is the entry's.
//  - A motion that passes a vertex by: the side normals perpendicular to the motion.
#include "exact/products.hpp"
#include "fault.hpp"
#include "sweep/candidates.hpp"
#include "sweep/rim.hpp"

namespace surefoot::internal {

namespace {

Vec side_normal(const Cone& cone, const Vec& sideways) noexcept {
    const Vec h = unit({sideways.x, 0, sideways.z});
    return {h.x * cone.height, cone.radius, h.z * cone.height};
}

// The two side normals with h . v_h = lean, if there are any; `sideways` is the length of v_h.
void consider_leaning_sides(const Cone& cone, const Vec& v, double sideways, double lean, Planes& planes) noexcept {
    if (absolute(lean) > sideways) return;
    const double other = std::sqrt((sideways - lean) * (sideways + lean));
    for (const double turn : {-other, other}) {
        planes.consider(side_normal(cone, {lean * v.x - turn * v.z, 0, lean * v.z + turn * v.x}));
    }
}

// The side normals perpendicular to `direction`.
void consider_perpendicular_sides(const Cone& cone, const Vec& direction, Planes& planes) noexcept {
    const Vec v = scaled_to_one(direction);
    const double sideways = std::sqrt(v.x * v.x + v.z * v.z);
    if (sideways == 0) return;
    consider_leaning_sides(cone, v, sideways, -cone.radius * v.y / cone.height, planes);
}

// The plane through the apex and the line on which the vertex moves cuts the cone in two generators, or not at all. The
// vertex enters on the one and leaves on the other (or on its mirror image below the apex). With P = vertex x motion
// the normal of that plane, they are the generators perpendicular to P, and their side normals are those with h . P_h =
// P.y H / R. The vertex is first lifted into the cone, by a few hairs along the side's normal, so that a motion that
// grazes the side still cuts it at an angle.
void consider_vertex(const SweepQuery& query, const Cone& cone, int vertex, Planes& planes) noexcept {
    const Vec& corner = query.corners[vertex];
    const double side = std::sqrt(cone.radius * cone.radius + cone.height * cone.height);
    const Vec lifted{corner.x, corner.y + inflation * query.triangle_hair() * side / cone.radius, corner.z};
    const Vec p = accurate_cross(scaled_to_one(lifted), scaled_to_one(query.along));
    const double sideways = std::sqrt(p.x * p.x + p.z * p.z);
    if (sideways == 0) {
        planes.consider(side_normal(cone, {1, 0, 0}));  // up or down the axis, through the apex: any side will do
        return;
    }
    consider_leaning_sides(cone, p, sideways, p.y * cone.height / cone.radius, planes);
}

}  // namespace

void propose_planes(const SweepQuery& query, const Cone& cone, Planes& planes) noexcept {
    const Vec axis{0, 1, 0};
    const Vec rim_centre{0, cone.height, 0};
    if (!has_fault(Fault::face_dropped)) {
        planes.consider_both(axis);
        planes.consider_both(query.face_normal());
    }
    for (int i = has_fault(Fault::first_edge_dropped) ? 1 : 0; i < 3; ++i) {
        if (planes.has_free_plane()) return;
        const Vec edge = query.edge_direction(i);
        consider_perpendicular_sides(cone, edge, planes);
        planes.consider_pass(
            rim_against_line(query.edge_start(i) - rim_centre, edge, query.along, cone.radius, query.edge_hairs(i)));
    }
    if (has_fault(Fault::vertices_dropped)) return;
    consider_perpendicular_sides(cone, query.along, planes);
    for (int i = 0; i < 3; ++i) consider_vertex(query, cone, i, planes);
}

}  // namespace surefoot::internal
