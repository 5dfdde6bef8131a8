#include "sweep/rim.hpp"

#include "exact/products.hpp"

namespace surefoot::internal {

RoundNormals rim_against_line(const Vec& point, const Vec& edge_direction, const Vec& along, double radius,
                              const Hairs& hairs) noexcept {
    const Vec edge = scaled_to_one(edge_direction);
    const Vec motion = scaled_to_one(along);
    if (edge.y == 0) return {};
    const double climb_sign = edge.y < 0 ? -1.0 : 1.0;

    // From a direction in the plane of the rim to the normal perpendicular to the edge that has it as its sideways
    // part.
    const auto raised = [&](const Vec& sideways) {
        return Vec{sideways.x * absolute(edge.y), -climb_sign * (sideways.x * edge.x + sideways.z * edge.z),
                   sideways.z * absolute(edge.y)};
    };

    const Vec travel{difference_of_products(motion.x, edge.y, motion.y, edge.x), 0,
                     difference_of_products(motion.z, edge.y, motion.y, edge.z)};
    const Vec onward = unit(travel) * climb_sign;
    if (onward == Vec{}) {
        // Along the edge: the crossing stands still.
        const double share = point.y / edge.y;
        RoundNormals standing;
        standing.passing = raised({edge.x * share - point.x, 0, edge.z * share - point.z});
        return standing;
    }
    const Vec across{-onward.z, 0, onward.x};
    // across . crossing, with across . edge_h rewritten by G so that nothing is divided by the climb.
    const double turn = difference_of_products(edge.z, motion.x, edge.x, motion.z) / length(travel) * climb_sign;
    const double offset = -(dot(point, across) - point.y * turn);
    // A hair along the normal is more of one in the plane of the rim.
    const Vec steep = raised(across);
    const double scale = inflation * length(steep) / std::sqrt(steep.x * steep.x + steep.z * steep.z);
    const Hairs flat_hairs{smaller(radius, hairs.own * scale), smaller(radius, hairs.triangle * scale)};
    const RoundNormals flat = normals_of_pass(across * offset, onward, radius, flat_hairs);
    return {raised(flat.entry), raised(flat.exit), raised(flat.passing), raised(flat.grazing_entry),
            raised(flat.grazing_exit)};
}

}  // namespace surefoot::internal
