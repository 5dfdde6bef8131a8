// Cone, standing on its apex: the patches of M are the flat disc, the triangle's plane, the side against an edge, the
// side against a vertex, and the rim of the disc against an edge.
//
// A side normal, from the triangle towards the cone, is (H h, R) with a sideways unit vector h: horizontally H h,
// upwards R.
//  - Side against edge e: the side normals perpendicular to e, h . e_h H + e.y R = 0: two of them, for any time.
//  - Side against vertex: the vertex moves linearly and meets the cone |z_h| = k z_y, k = R / H: a quadratic in t.
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

// The side normals perpendicular to `direction`, if there are any.
void consider_perpendicular_sides(const Cone& cone, const Vec& direction, Planes& planes) noexcept {
    const Vec v = scaled_to_one(direction);
    const double sideways = std::sqrt(v.x * v.x + v.z * v.z);
    // cosine of the angle between h and the direction's sideways part, times `sideways`
    const double lean = -cone.radius * v.y / cone.height;
    if (sideways == 0 || absolute(lean) > sideways) return;
    const double other = std::sqrt((sideways - lean) * (sideways + lean));
    for (const double turn : {-other, other}) {
        planes.consider(side_normal(cone, {lean * v.x - turn * v.z, 0, lean * v.z + turn * v.x}));
    }
}

// z = corner - t * along, seen from the apex; the vertex is inside while |z_h| <= k z_y, z_y >= 0. A first root from
// the quadratic, then planes: the side normal at the root gives a plane whose time is at or before the true one, from
// there the next normal. That is Newton's method from the left on a convex function: it cannot overshoot, and three
// steps restore the digits that the closed form loses when the motion runs along the side.
void consider_vertex(const SweepQuery& query, const Cone& cone, int vertex, Planes& planes) noexcept {
    const Vec& corner = query.corners[vertex];
    const double k = cone.radius / cone.height;
    const Vec& along = query.along;
    const double along_h = std::sqrt(along.x * along.x + along.z * along.z);
    const double squared = (along_h - k * absolute(along.y)) * (along_h + k * absolute(along.y));
    const double half = -(corner.x * along.x + corner.z * along.z) + k * k * corner.y * along.y;
    const double extent = norm1(along);

    const auto consider_at = [&](double t) {
        for (int step = 0; step < 3; ++step) {
            const Vec z = corner - along * t;
            const Vec normal = unit(side_normal(cone, -z));
            if (z.x == 0 && z.z == 0) return;
            planes.consider(normal);
            const double approach = dot(normal, along);
            const double gap = -dot(normal, z);  // of this vertex alone, at t: the apex reaches no further
            if (approach == 0) return;
            const double next = t - gap / approach;
            if (!(absolute(next) < 4) || next == t) return;
            t = next;
        }
    };

    if (extent == 0) {
        consider_at(0);
        return;
    }
    if (absolute(squared) <= 0x1p-30 * extent * extent) {
        // Nearly along a generator: nearly linear.
        if (half != 0) {
            const double z_h = std::sqrt(corner.x * corner.x + corner.z * corner.z);
            const double constant = (z_h - k * corner.y) * (z_h + k * absolute(corner.y));
            consider_at(-constant / (2 * half));
        }
        consider_at(0);
        consider_at(1);
        return;
    }
    // The extremum of the quadratic, and its value there from the position there, so that it keeps its digits.
    const double middle = -half / squared;
    const Vec z = corner - along * middle;
    const double z_h = std::sqrt(z.x * z.x + z.z * z.z);
    const double side = std::sqrt(cone.radius * cone.radius + cone.height * cone.height);
    const double lowered = absolute(z.y) + inflation * query.corner_hair(vertex) * side / cone.radius;
    const double value = (z_h - k * lowered) * (z_h + k * lowered);
    const double root_squared = -value / squared;
    if (root_squared < 0) return;
    const double root = std::sqrt(root_squared);
    consider_at(middle - root);
    consider_at(middle + root);
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
        const Vec edge = query.edge_direction(i);
        consider_perpendicular_sides(cone, edge, planes);
        planes.consider_pass(
            rim_against_line(query.edge_start(i) - rim_centre, edge, query.along, cone.radius, query.edge_hair(i)));
    }
    if (has_fault(Fault::vertices_dropped)) return;
    consider_perpendicular_sides(cone, query.along, planes);
    for (int i = 0; i < 3; ++i) consider_vertex(query, cone, i, planes);
}

}  // namespace surefoot::internal
