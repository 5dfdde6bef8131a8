#include "funnel.hpp"

namespace surefoot::navigation {
namespace {

bool same_place(const dvec3& a, const dvec3& b) {
    return a.x == b.x && a.z == b.z;
}

/// One side of the funnel: a corner of a portal that was crossed.
struct Side {
    dvec3 at;
    std::size_t portal = 0;
};

}  // namespace

std::vector<FunnelCorner> bends(const dvec3& from, std::span<const Portal> portals, const dvec3& to) {
    std::vector<FunnelCorner> found;
    dvec3 apex = from;
    Side left{from, 0};
    Side right{from, 0};
    const auto bend_at = [&](const Side& side, std::size_t& next) {
        apex = side.at;
        if (found.empty() || !same_place(found.back().position, apex)) found.push_back({apex, side.portal + 1});
        left = right = {apex, side.portal};
        next = side.portal;  // the loop goes on behind it
    };
    for (std::size_t i = 0; i <= portals.size(); ++i) {
        const Portal portal = i < portals.size() ? portals[i] : Portal{to, to};
        // The right side moves in if the new corner is not to the right of it...
        if (left_of(apex, right.at, portal.right) >= 0) {
            if (same_place(apex, right.at) || left_of(apex, left.at, portal.right) < 0) {
                right = {portal.right, i};
            } else {  // ...and if that takes it across the left one, the line bends there.
                bend_at(left, i);
                continue;
            }
        }
        if (left_of(apex, left.at, portal.left) <= 0) {
            if (same_place(apex, left.at) || left_of(apex, right.at, portal.left) > 0) {
                left = {portal.left, i};
            } else {
                bend_at(right, i);
                continue;
            }
        }
    }
    if (!found.empty() && same_place(found.back().position, to)) found.pop_back();
    return found;
}

}  // namespace surefoot::navigation
