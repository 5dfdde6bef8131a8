// Sphere and ellipsoid: M is the triangle, thickened. Its patches are the face moved out by the radius (a plane), a
// cylinder about each edge, a ball about each vertex.
//
// The ellipsoid is the classic change of space: divided by its radii it is the unit ball, the triangle is another
// triangle, and straight lines stay straight with the same t. Only the touch is computed there. A normal m of that
// space is the normal m / radii of the world, and the plane it stands for is judged in the world. Fauerby, "Improved
// Collision Detection and Response" (2003), has the change of space and the three cases.
#include "fault.hpp"
#include "sweep/candidates.hpp"
#include "sweep/round_features.hpp"

namespace surefoot::internal {

namespace {

// For a sphere `ball.squash` is 1 and the ball keeps its radius.
void propose_round_planes(const SweepQuery& query, const Ball& ball, Planes& planes) noexcept {
    const auto squash = [&](const Vec& v) { return divide_each(v, ball.squash); };
    const auto with = [&](const Hairs& hairs) { return Ball{ball.radius, hairs, ball.squash}; };
    const auto consider = [&](const RoundNormals& normals) {
        planes.consider_pass({squash(normals.entry), squash(normals.exit), squash(normals.passing),
                              squash(normals.grazing_entry), squash(normals.grazing_exit)});
    };
    const Vec along = squash(query.along);
    if (!has_fault(Fault::face_dropped)) planes.consider_both(query.face_normal());
    const bool skip_edges =
        has_fault(Fault::parallel_skipped) && absolute(dot(unit(query.face_normal()), unit(query.along))) < 0x1p-20;
    for (int i = has_fault(Fault::first_edge_dropped) ? 1 : 0; i < 3 && !skip_edges; ++i) {
        if (planes.has_free_plane()) return;
        consider(ball_against_line(squash(query.edge_start(i)), squash(query.edge_direction(i)), along,
                                   with(query.edge_hairs(i))));
    }
    if (has_fault(Fault::vertices_dropped)) return;
    for (int i = 0; i < 3; ++i) {
        if (planes.has_free_plane()) return;
        consider(ball_against_point(squash(query.corners[i]), along, with(query.corner_hairs(i))));
    }
}

}  // namespace

void propose_planes(const SweepQuery& query, const Sphere& sphere, Planes& planes) noexcept {
    propose_round_planes(query, {.radius = sphere.radius, .hairs = {}}, planes);
}

void propose_planes(const SweepQuery& query, const Ellipsoid& ellipsoid, Planes& planes) noexcept {
    propose_round_planes(query, {.radius = 1, .hairs = {}, .squash = to_vec(ellipsoid.radii)}, planes);
}

}  // namespace surefoot::internal
