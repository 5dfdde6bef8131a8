// A plane with a gap until t cannot be late; a point that shape and triangle have in common at t cannot be early. So a
// face's plane whose touch lies inside the face is the whole answer: no other plane can give way later, or there would
// be no common point. The touch has to lie inside by much more than the rounding in where it is; the rest is for the
// edges to say.
#include "sweep/face_first.hpp"

#include "fault.hpp"
#include "overloaded.hpp"

namespace surefoot::internal {

namespace {

// How far inside the face a touch has to lie, in hairs.
constexpr double clearance = 0x1p10;

// +-half, whichever is farthest against the normal; the middle where both are as far to within a hair.
double far_side(double half, double normal, double hair) noexcept {
    return absolute(normal) * half <= hair ? 0 : (normal > 0 ? -half : half);
}

// On a circle of this radius in the XZ plane, the point farthest against the normal; the centre where all are as far.
Vec far_on_disc(double radius, const Vec& normal, double hair) noexcept {
    const double sideways = std::sqrt(normal.x * normal.x + normal.z * normal.z);
    if (sideways * radius <= hair) return {};
    return {-radius * normal.x / sideways, 0, -radius * normal.z / sideways};
}

// A point of the shape that is farthest against the normal, to within a few hairs.
Vec farthest_against(const Shape& shape, const Vec& n, double hair) noexcept {
    return std::visit(
        Overloaded{
            [&](const Sphere& sphere) { return -sphere.radius * n; },
            [&](const Ellipsoid& ellipsoid) {
                const Vec radii = to_vec(ellipsoid.radii);
                const Vec squashed = multiply_each(n, radii);
                return multiply_each(squashed, radii) / -length(squashed);
            },
            [&](const Capsule& capsule) {
                return Vec{0, far_side(capsule.half_height, n.y, hair), 0} - capsule.radius * n;
            },
            [&](const Box& box) {
                return Vec{far_side(box.half_extents.x, n.x, hair), far_side(box.half_extents.y, n.y, hair),
                           far_side(box.half_extents.z, n.z, hair)};
            },
            [&](const Cylinder& cylinder) {
                return far_on_disc(cylinder.radius, n, hair) + Vec{0, far_side(cylinder.half_height, n.y, hair), 0};
            },
            [&](const Cone& cone) {
                const Vec rim = far_on_disc(cone.radius, n, hair) + Vec{0, cone.height, 0};
                return dot(rim, n) < 0 ? rim : Vec{};
            },
        },
        shape);
}

// How far from the face, in hairs, a shape may be at the start and touch it.
constexpr double touching_hairs = 8;

// Where the shape is nearest to the face's plane at t, on that plane.
Vec touch_at(const SweepQuery& query, const Vec& normal, double t, double hair) noexcept {
    const Vec touch = query.along * t + farthest_against(query.shape, normal, hair);
    return touch - normal * dot(normal, touch - query.corners[0]);
}

// Is a point of the triangle's plane inside all three edges by `margin`? `normal` is of unit length.
bool is_well_inside(const SweepQuery& query, const Vec& normal, const Vec& point, double margin) noexcept {
    const Vec across_first = cross(normal, query.edge_direction(0));
    const double winding = dot(across_first, query.corners[2] - query.corners[0]) < 0 ? -1 : 1;
    for (int i = 0; i < 3; ++i) {
        const Vec edge = query.edge_direction(i);
        const double turned = i == 2 ? -winding : winding;  // the last edge runs backwards
        const double inside = turned * dot(cross(normal, edge), point - query.edge_start(i));
        if (!(inside > 0 && inside * inside > margin * margin * dot(edge, edge))) return false;
    }
    return true;
}

}  // namespace

FaceFirst ask_face_first(const SweepQuery& query, double limit) noexcept {
    FaceFirst face;
    if (has_fault(Fault::face_dropped)) return face;
    const Vec normal = unit(query.face_normal());
    if (normal == Vec{}) return face;
    face.plane = judged(query, normal);
    if (!(face.plane.gap > 0)) face.plane = judged(query, -normal);
    if (!(face.plane.gap > 0)) return face;

    const double left_at_end = face.plane.gap + face.plane.approach;
    if (left_at_end > 0 && !(has_fault(Fault::far_end_ignored) && face.plane.approach < 0)) {
        face.verdict = FaceFirst::Verdict::free;
        return face;
    }
    if (limit < 1 && face.plane.gap + limit * face.plane.approach > 4 * query.triangle_hair()) {
        face.verdict = FaceFirst::Verdict::free;
        return face;
    }
    if (is_grazed(query, face.plane)) return face;
    face.t = smaller(1, face.plane.gap / -face.plane.approach);
    const double hair = query.triangle_hair();
    face.point = touch_at(query, face.plane.normal, face.t, hair);
    if (is_well_inside(query, face.plane.normal, face.point, clearance * hair)) {
        face.verdict = FaceFirst::Verdict::hit;
    }
    return face;
}

FaceFirst ask_touching_face(const SweepQuery& query, FaceFirst face) noexcept {
    if (face.plane.normal == Vec{}) return face;
    if (!(face.plane.gap > 0)) {
        const Plane other = judged(query, -face.plane.normal);
        if (other.gap > face.plane.gap) face.plane = other;
    }
    const double hair = query.triangle_hair();
    if (!(absolute(face.plane.gap) <= touching_hairs * hair)) return face;
    face.point = touch_at(query, face.plane.normal, 0, hair);
    if (!is_well_inside(query, face.plane.normal, face.point, clearance * hair)) return face;
    face.t = 0;
    face.verdict = face.plane.approach < 0 ? FaceFirst::Verdict::hit : FaceFirst::Verdict::free;
    return face;
}

}  // namespace surefoot::internal
