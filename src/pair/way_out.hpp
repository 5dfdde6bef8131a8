// What starts in touch or inside: does it go deeper, and how does it get out?
#pragma once

#include <optional>

#include "pair/advance.hpp"
#include "pair/general.hpp"

namespace surefoot::internal {

/// Calls `visit(n)` with unit normals that often part two shapes: their axes, the cross products of these, and the line
/// between them.
template <typename Visit>
void visit_usual_normals(const PlacedPair& pair, const Vec& x, const Visit& visit) noexcept {
    const auto offer = [&](const Vec& direction) noexcept {
        const Vec n = unit(direction);
        if (n == Vec{}) return;
        visit(n);
        visit(-n);
    };
    const Vec axes[3] = {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}};
    for (const Vec& axis : axes) {
        offer(pair.b.frame().to_world(axis));
        offer(pair.a.frame().to_world(axis));
    }
    for (const Vec& of_a : axes) {
        for (const Vec& of_b : axes)
            offer(accurate_cross(pair.a.frame().to_world(of_a), pair.b.frame().to_world(of_b)));
    }
    offer(x);
    // The sides of a cone, from eight of their directions.
    constexpr double diagonal = 0.70710678118654752440;
    const Vec around[8] = {{1, 0, 0},  {diagonal, 0, diagonal},   {0, 0, 1},  {-diagonal, 0, diagonal},
                           {-1, 0, 0}, {-diagonal, 0, -diagonal}, {0, 0, -1}, {diagonal, 0, -diagonal}};
    for (const Placed* placed : {&pair.a, &pair.b}) {
        const auto* cone = std::get_if<Cone>(&placed->shape());
        if (cone == nullptr) continue;
        for (const Vec& u : around) offer(placed->frame().to_world(u * cone->height - Vec{0, cone->radius, 0}));
    }
}

/// Does `motion` take the first shape deeper by more than `hair`? `gap` is the one at `x`. No, if one plane can be
/// found that is as good as the gap there and that the motion does not approach: that plane proves it for the whole
/// motion.
template <typename Pairing>
bool goes_deeper(const Pairing& pairing, const PlacedPair& pair, const Vec& x, const Vec& motion, const Gap& gap,
                 double hair) noexcept {
    const double speed = length(motion);
    if (!(speed > 0) || dot(gap.normal, motion) >= 0) return false;
    bool deeper = true;
    const auto consider = [&](const Vec& n) noexcept {
        if (dot(n, motion) >= -0x1p-40 * speed && pair.gap_along(n, x) >= gap.least - hair) deeper = false;
    };
    const auto with_tangent = [&](const Vec& n) noexcept {
        consider(n);
        const Vec along = motion / speed;
        const Vec tangent = unit(n - along * dot(n, along));
        if (!(tangent == Vec{})) consider(tangent);
    };
    with_tangent(gap.normal);
    // At an edge of the sum of the two several planes touch; the one that counts is that of the place it moves to.
    const double step = smaller(speed, 0x1p-20 * (pair.a.size() + pair.b.size()));
    const Gap ahead = pairing.gap_at(x + motion * (step / speed));
    if (!ahead.is_deep) with_tangent(ahead.normal);
    if (deeper) visit_usual_normals(pair, x, consider);
    return deeper;
}

/// The way out of two cores that overlap: from the best of the usual normals downhill by planes, then by touches. Going
/// out along n the shapes part at a touch whose own normal is never worse: the plane there is no farther than the way
/// that led to it. That is repeated while it helps. Nothing if no touch was found within the bound on the work.
std::optional<Gap> way_out(const GeneralPair& pairing, const PlacedPair& pair, const Vec& x, double hair) noexcept;

}  // namespace surefoot::internal
