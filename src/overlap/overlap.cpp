#include <utility>

#include <surefoot/overlap.hpp>

#include "frame.hpp"
#include "ieee_guard.hpp"
#include "limits.hpp"
#include "overlap/problem.hpp"
#include "overlap/side.hpp"
#include "overloaded.hpp"

namespace surefoot {
inline namespace v0 {

namespace {

using internal::Vec;

// The corners in an order of their own, so that the caller's order changes no bit of the answer but the front.
struct OrderedTriangle {
    Vec corner[3];  ///< in the world
    bool mirrored = false;
};

OrderedTriangle ordered(const Triangle& triangle) noexcept {
    OrderedTriangle result{{internal::to_vec(triangle.a), internal::to_vec(triangle.b), internal::to_vec(triangle.c)}};
    const auto order = [&](int i, int j) noexcept {
        if (internal::lexicographically_less(result.corner[j], result.corner[i])) {
            std::swap(result.corner[i], result.corner[j]);
            result.mirrored = !result.mirrored;
        }
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    return result;
}

internal::TriangleProblem seen_by(const internal::Frame& frame, const OrderedTriangle& world,
                                  const Vec& position) noexcept {
    internal::TriangleProblem problem;
    problem.winding = world.mirrored ? -1 : 1;
    int longest = 0;
    for (int i = 0; i < 3; ++i) {
        problem.corner[i] = frame.to_local(world.corner[i] - position);
        problem.edge[i] = frame.to_local(world.corner[i == 2 ? 0 : i + 1] - world.corner[i]);
        problem.scale = internal::larger(problem.scale, internal::largest(problem.corner[i]));
        if (norm1(problem.edge[i]) > norm1(problem.edge[longest])) longest = i;
    }
    // From the two shorter edges: of a sliver they keep the most of its direction.
    const int second = longest == 2 ? 0 : longest + 1;
    const int third = second == 2 ? 0 : second + 1;
    problem.normal = internal::unit(internal::accurate_cross(internal::scaled_to_one(problem.edge[second]),
                                                             internal::scaled_to_one(problem.edge[third])));
    problem.normal = problem.normal * problem.winding;
    if (problem.normal == Vec{}) {
        // A segment has no normal, but whoever sits on it needs some way out across it; a point may be left upwards.
        const Vec& e = problem.edge[longest];
        const bool is_steep =
            internal::absolute(e.y) >= internal::larger(internal::absolute(e.x), internal::absolute(e.z));
        problem.normal = e == Vec{} ? Vec{0, 1, 0}
                                    : internal::unit(is_steep ? Vec{e.y, -e.x, 0}
                                                              : Vec{-e.y * e.x, e.x * e.x + e.z * e.z, -e.y * e.z});
    }
    return problem;
}

Overlap blocked() noexcept {
    Overlap result;
    result.status = HitStatus::invalid;
    return result;
}

}  // namespace

std::optional<Overlap> overlap(const Volume& volume, const dvec3& position, const Triangle& triangle,
                               const OverlapOptions& options) noexcept {
    const internal::IeeeGuard guard;
    if (!is_valid(volume) || !internal::is_valid_point(position) || !internal::is_valid_triangle(triangle)) {
        return blocked();
    }
    if (options.one_sided && internal::side_of_plane(triangle, position) < 0) return std::nullopt;

    const internal::Frame frame(volume.orientation);
    const OrderedTriangle world = ordered(triangle);
    const internal::TriangleProblem problem = seen_by(frame, world, internal::to_vec(position));
    const internal::WayOut way =
        std::visit(internal::Overloaded{
                       [&](const Sphere& shape) noexcept { return overlap_sphere(shape, problem); },
                       [&](const Ellipsoid& shape) noexcept { return overlap_ellipsoid(shape, problem); },
                       [&](const Capsule& shape) noexcept { return overlap_capsule(shape, problem); },
                       [&](const Box& shape) noexcept { return overlap_box(shape, problem); },
                       [&](const Cylinder& shape) noexcept { return overlap_cylinder(shape, problem); },
                       [&](const Cone& shape) noexcept { return overlap_cone(shape, problem); },
                   },
                   volume.shape);
    if (!way.touches) return std::nullopt;

    Overlap result;
    result.depth = internal::larger(0, way.depth);
    result.normal = internal::to_dvec3(internal::unit(frame.to_world(way.normal)));
    result.feature = way.feature;
    result.point = way.corner >= 0 ? internal::to_dvec3(world.corner[way.corner])
                                   : internal::to_dvec3(internal::to_vec(position) + frame.to_world(way.point));
    return result;
}

}  // namespace v0
}  // namespace surefoot
