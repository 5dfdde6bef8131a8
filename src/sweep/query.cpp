#include "sweep/query.hpp"

#include <utility>

#include "exact/products.hpp"
#include "fault.hpp"
#include "overloaded.hpp"

namespace surefoot::internal {

namespace {

// A sphere has no orientation; not turning it saves its rounding.
dquat orientation_used(const Volume& volume) noexcept {
    const bool is_sphere = std::holds_alternative<Sphere>(volume.shape);
    return is_sphere || has_fault(Fault::squash_without_rotation) ? dquat(1, 0, 0, 0) : volume.orientation;
}

}  // namespace

SweepQuery::SweepQuery(const Volume& volume, const Motion& motion, const Triangle& triangle, std::uint32_t id) noexcept
    : shape(volume.shape), frame(orientation_used(volume)), triangle_id(id) {
    // The canonical order is that of the world coordinates, so that two triangles that share an edge walk it alike.
    const Vec world[3] = {to_vec(triangle.a), to_vec(triangle.b), to_vec(triangle.c)};
    original[0] = 0;
    original[1] = 1;
    original[2] = 2;
    const auto order = [&](int i, int j) {
        if (lexicographically_less(world[original[j]], world[original[i]])) std::swap(original[i], original[j]);
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);

    const Vec from = to_vec(motion.from);
    for (int i = 0; i < 3; ++i) {
        corners[i] = frame.to_local(world[original[i]] - from);
        corner_slack[i] = rounding_share * norm1(corners[i]);
    }
    along = frame.to_local(to_vec(motion.to) - from);
    shape_slack = rounding_share * (norm1(along) + size_of(shape));
}

Vec SweepQuery::face_normal() const noexcept {
    // From the two shorter edges: the cross product of a sliver loses the least that way.
    const Vec edges[3] = {edge_direction(0), edge_direction(1), edge_direction(2)};
    int longest = 0;
    for (int i = 1; i < 3; ++i) {
        if (norm1(edges[i]) > norm1(edges[longest])) longest = i;
    }
    return accurate_cross(scaled_to_one(edges[(longest + 1) % 3]), scaled_to_one(edges[(longest + 2) % 3]));
}

double reach_against(const Shape& shape, const Vec& normal) noexcept {
    const auto sideways = [&]() { return std::sqrt(normal.x * normal.x + normal.z * normal.z); };
    return std::visit(
        Overloaded{
            [&](const Sphere& sphere) { return sphere.radius; },
            [&](const Ellipsoid& ellipsoid) { return length(multiply_each(normal, to_vec(ellipsoid.radii))); },
            [&](const Capsule& capsule) { return absolute(normal.y) * capsule.half_height + capsule.radius; },
            [&](const Box& box) {
                return absolute(normal.x) * box.half_extents.x + absolute(normal.y) * box.half_extents.y +
                       absolute(normal.z) * box.half_extents.z;
            },
            [&](const Cylinder& cylinder) {
                return absolute(normal.y) * cylinder.half_height + sideways() * cylinder.radius;
            },
            [&](const Cone& cone) { return larger(0, sideways() * cone.radius - normal.y * cone.height); },
        },
        shape);
}

double size_of(const Shape& shape) noexcept {
    return std::visit(Overloaded{
                          [](const Sphere& sphere) { return 2 * sphere.radius; },
                          [](const Ellipsoid& ellipsoid) { return norm1(to_vec(ellipsoid.radii)); },
                          [](const Capsule& capsule) { return 2 * capsule.radius + capsule.half_height; },
                          [](const Box& box) { return norm1(to_vec(box.half_extents)); },
                          [](const Cylinder& cylinder) { return 2 * cylinder.radius + cylinder.half_height; },
                          [](const Cone& cone) { return 2 * cone.radius + cone.height; },
                      },
                      shape);
}

}  // namespace surefoot::internal
