#include "world/body.hpp"

namespace surefoot::internal {

namespace {

// The box around a box that is turned: its middle turned, and the sum of what its half sizes reach along each axis.
Box3 turned(const Box3& box, const Frame& frame) noexcept {
    const Vec middle = frame.to_world((box.min + box.max) * 0.5);
    const Vec half = (box.max - box.min) * 0.5;
    Vec reach;
    for (const Vec& side : {Vec{half.x, 0, 0}, Vec{0, half.y, 0}, Vec{0, 0, half.z}}) {
        const Vec along = frame.to_world(side);
        reach = reach + Vec{absolute(along.x), absolute(along.y), absolute(along.z)};
    }
    return {middle - reach, middle + reach};
}

Box3 grown(const Box3& box, double by) noexcept {
    return {box.min - Vec{by, by, by}, box.max + Vec{by, by, by}};
}

}  // namespace

void WorldBody::place(const Pose& new_start, const Pose& new_end) noexcept {
    start = new_start;
    end = new_end;
    turn_ = Turn(start.orientation, end.orientation);
    moves_ = turn_.turns() || !(to_vec(start.position) == to_vec(end.position));
    reach();
}

void WorldBody::measure() noexcept {
    const Bounds bounds = source.bounds();
    own_box_ = {to_vec(bounds.min), to_vec(bounds.max)};
    reach();
}

void WorldBody::reach() noexcept {
    const Vec from = to_vec(start.position);
    const Vec to = to_vec(end.position);
    const Quat first = turn_.at(0);
    const bool stands_at_origin = !moves_ && from == Vec{} && first.v == Vec{};
    if (stands_at_origin) {
        box_ = own_box_;
        return;
    }
    Box3 box = turned(own_box_, Frame(to_dquat(first)));
    const double farthest = norm1({larger(absolute(own_box_.min.x), absolute(own_box_.max.x)),
                                   larger(absolute(own_box_.min.y), absolute(own_box_.max.y)),
                                   larger(absolute(own_box_.min.z), absolute(own_box_.max.z))});
    if (turn_.turns()) {
        // Each point goes along an arc of at most half a circle. The arc leaves its chord by r (1 - cos(angle / 2)) at
        // most, and cos(angle / 2) is the dot product of the two unit quaternions: 1 - dot is half of |q1 - q0|^2.
        const Quat last = turn_.at(1);
        const Quat chord = last - first;
        box.include(turned(own_box_, Frame(to_dquat(last))));
        box = grown(box, farthest * dot(chord, chord) / 2);
    }
    const Box3 way{{smaller(from.x, to.x), smaller(from.y, to.y), smaller(from.z, to.z)},
                   {larger(from.x, to.x), larger(from.y, to.y), larger(from.z, to.z)}};
    // Rounding here, and what the roundest pose rounds in a query, with a cone of 1 : 10000 grown by it.
    const double margin = 0x1p-30 * (magnitude_of(way) + farthest);
    box_ = grown({box.min + way.min, box.max + way.max}, margin);
}

}  // namespace surefoot::internal
