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
    const internal::OrderedTriangle world = internal::ordered(triangle);
    const internal::TriangleProblem problem = internal::seen_by(frame, world, internal::to_vec(position));
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
