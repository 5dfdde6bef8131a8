#include "sweep/start.hpp"

#include "fault.hpp"
#include "overloaded.hpp"
#include "sweep/exact_distance.hpp"
#include "sweep/exact_facets.hpp"
#include "sweep/upright_start.hpp"

namespace surefoot::internal {

namespace {

template <typename Number>
Approach from_sign(const Number& derivative) noexcept {
    return derivative.sign() < 0 ? Approach::deeper : Approach::no_closer;
}

// Sphere and ellipsoid: g is the distance to the triangle in the space where the shape is round, less a constant; its
// slope has the sign of (centre - nearest point) . d. On the triangle itself the offset is zero, and moving can only
// lead away from the deepest place.
template <typename Number>
Approach approach_of(const ExactQuery<Number>& query) noexcept {
    const auto offset = offset_from_triangle(query.corners[0], query.corners[1], query.corners[2]);
    return from_sign(dot(offset.direction, query.along));
}

template <typename Number>
Approach approach_of(ExactQuery<Number>& query, const Ellipsoid& ellipsoid) noexcept {
    // Dividing by the radii, times their product.
    const Number x(ellipsoid.radii.x);
    const Number y(ellipsoid.radii.y);
    const Number z(ellipsoid.radii.z);
    const ExactVec<Number> squash{y * z, x * z, x * y};
    const auto apply = [&](ExactVec<Number>& v) { v = {v.x * squash.x, v.y * squash.y, v.z * squash.z}; };
    for (auto& corner : query.corners) apply(corner);
    apply(query.along);
    return approach_of(query);
}

// Capsule: g is the signed distance to the prism that triangle and core make, less the radius. Outside the prism that
// is the distance between core and triangle; inside, the faces of the prism at the least depth decide. A flat prism has
// no inside.
template <typename Number>
Approach approach_of(const ExactQuery<Number>& query, const Capsule& capsule) noexcept {
    const Number half_height = Number(capsule.half_height) * query.scale;
    const ExactVec<Number> normal = query.face_normal();
    if (normal.y.sign() != 0 && half_height.sign() != 0) {
        const auto reach = [&](const ExactVec<Number>& n) { return exact_absolute(n.y) * half_height; };
        ExactFacets<Number, decltype(reach)> prism(query, reach);
        prism.add_both(normal);
        for (int i = 0; i < 3; ++i) {
            const ExactVec<Number> edge = query.edge(i);
            prism.add_both({-edge.z, Number(), edge.x});
        }
        if (!prism.origin_is_outside()) return prism.approach_inside();
    }

    // Ends of the core against the triangle, corners against the core, and edges that cross the core's middle.
    const auto against_end = [&](const Number& end) {
        const ExactVec<Number> up{Number(), end, Number()};
        return offset_from_triangle(query.corners[0] - up, query.corners[1] - up, query.corners[2] - up);
    };
    ExactOffset<Number> best = against_end(half_height);
    const auto keep_nearer = [&](const ExactOffset<Number>& offset) {
        if (offset.nearer_than(best)) best = offset;
    };
    keep_nearer(against_end(-half_height));
    for (int i = 0; i < 3; ++i) {
        const ExactVec<Number>& corner = query.corners[i];
        if (compare(exact_absolute(corner.y), half_height) < 0) {
            keep_nearer(offset_from_point(ExactVec<Number>{corner.x, Number(), corner.z}));
        }
        // Seen along the axis: the foot of the axis on the edge, if it is within both.
        const ExactVec<Number> edge = query.edge(i);
        const Number squared = edge.x * edge.x + edge.z * edge.z;
        const Number share = -(corner.x * edge.x + corner.z * edge.z);
        if (share.sign() <= 0 || compare(share, squared) >= 0) continue;
        if (compare(exact_absolute(corner.y * squared + edge.y * share), half_height * squared) >= 0) continue;
        const Number across = corner.x * edge.z - corner.z * edge.x;
        keep_nearer({{-(corner.x * squared + edge.x * share), Number(), -(corner.z * squared + edge.z * share)},
                     across * across,
                     squared});
    }
    return from_sign(dot(best.direction, query.along));
}

// Box: M is a polytope.
template <typename Number>
Approach approach_of(const ExactQuery<Number>& query, const Box& box) noexcept {
    const ExactVec<Number> half{Number(box.half_extents.x) * query.scale, Number(box.half_extents.y) * query.scale,
                                Number(box.half_extents.z) * query.scale};
    const auto reach = [&](const ExactVec<Number>& n) {
        return exact_absolute(n.x) * half.x + exact_absolute(n.y) * half.y + exact_absolute(n.z) * half.z;
    };
    const Number zero;
    const Number one(1.0);
    ExactFacets<Number, decltype(reach)> facets(query, reach);
    facets.add_both({one, zero, zero});
    facets.add_both({zero, one, zero});
    facets.add_both({zero, zero, one});
    facets.add_both(query.face_normal());
    for (int i = 0; i < 3; ++i) {
        const ExactVec<Number> edge = query.edge(i);
        facets.add_both({zero, edge.z, -edge.y});
        facets.add_both({-edge.z, zero, edge.x});
        facets.add_both({edge.y, -edge.x, zero});
    }
    return facets.origin_is_outside() ? facets.approach_outside() : facets.approach_inside();
}

template <typename Number>
Approach approach_with(const Volume& volume, const Motion& motion, const Triangle& triangle) noexcept {
    ExactQuery<Number> query(motion, triangle);
    if (std::holds_alternative<Sphere>(volume.shape)) return approach_of(query);
    query.turn_into_frame(volume.orientation);
    return std::visit(Overloaded{
                          [&](const Sphere&) { return approach_of(query); },
                          [&](const Cylinder&) { return upright_approach_at_start(volume, motion, triangle); },
                          [&](const Cone&) { return upright_approach_at_start(volume, motion, triangle); },
                          [&](const auto& shape) { return approach_of(query, shape); },
                      },
                      volume.shape);
}

// The most digits that a decision multiplies together: comparing two depths is of degree 10 in coordinates, each of
// which has been turned (twice the digits of the quaternion) and squashed (twice those of the dimensions).
constexpr int highest_degree = 10;

int digits_needed(const Volume& volume, const Motion& motion, const Triangle& triangle) noexcept {
    DigitSpan coordinates;
    for (const dvec3* point : {&motion.from, &motion.to, &triangle.a, &triangle.b, &triangle.c}) {
        coordinates.include(*point);
    }
    DigitSpan dimensions;
    std::visit(Overloaded{
                   [&](const Sphere&) {},
                   [&](const Ellipsoid& ellipsoid) { dimensions.include(ellipsoid.radii); },
                   [&](const Capsule& capsule) { coordinates.include(capsule.half_height); },
                   [&](const Box& box) { coordinates.include(box.half_extents); },
                   [&](const auto&) {},
               },
               volume.shape);
    DigitSpan turn;
    const dquat& q = volume.orientation;
    const bool turned = (q.x != 0 || q.y != 0 || q.z != 0) && !std::holds_alternative<Sphere>(volume.shape);
    if (turned) {
        turn.include(dvec3(q.x, q.y, q.z));
        turn.include(q.w);
    }
    return highest_degree * (coordinates.digits() + 2 * turn.digits() + 2 * dimensions.digits() + 4);
}

}  // namespace

Approach approach_at_start(const Volume& volume, const Motion& motion, const Triangle& triangle) noexcept {
    const int limbs = digits_needed(volume, motion, triangle) / 32 + 4;
    if (limbs <= 128) return approach_with<GameNumber>(volume, motion, triangle);
    if (limbs <= 640) return approach_with<AnyNumber>(volume, motion, triangle);
    return Approach::overflow;
}

Approach approach_to_front(const Motion& motion, const Triangle& triangle) noexcept {
    const Vec a = to_vec(triangle.a);
    const Vec ab = to_vec(triangle.b) - a;
    const Vec ac = to_vec(triangle.c) - a;
    const Vec along = to_vec(motion.to) - to_vec(motion.from);
    const double determinant = dot(cross(ab, ac), along);
    // Each difference is good to one rounding, each product of three to five more; 16 covers the sums too. What is near
    // the smallest numbers, where products lose digits, is left to exact arithmetic.
    const double bound = 16 * 0x1p-53 * norm1(ab) * norm1(ac) * norm1(along);
    if (bound > 0x1p-900 && determinant > bound) return Approach::no_closer;
    if (bound > 0x1p-900 && determinant < -bound) return Approach::deeper;
    // Degree 3 in coordinates of at most 1107 digits.
    using Number = ExactNumber<120>;
    const ExactQuery<Number> query(motion, triangle);
    return from_sign(dot(query.face_normal(), query.along));
}

}  // namespace surefoot::internal
