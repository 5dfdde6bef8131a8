#include <surefoot/pose.hpp>

#include "frame.hpp"
#include "ieee_guard.hpp"
#include "limits.hpp"
#include "quat.hpp"

namespace surefoot {
inline namespace v0 {

using namespace internal;

bool is_valid(const Pose& pose) noexcept {
    const IeeeGuard guard;
    const dquat& q = pose.orientation;
    const double largest_part = larger(largest({q.x, q.y, q.z}), absolute(q.w));
    // A maximum forgets NaN, a sum does not.
    const double sum = absolute(q.x) + absolute(q.y) + absolute(q.z) + absolute(q.w);
    return is_valid_point(pose.position) && sum <= 0x1p502 && largest_part <= 0x1p500 && largest_part >= 0x1p-500;
}

Pose pose_between(const Pose& start, const Pose& end, double at) noexcept {
    const IeeeGuard guard;
    if (at <= 0) return start;
    if (at >= 1) return end;
    const Turn turn(start.orientation, end.orientation);
    return {to_dvec3(mix(to_vec(start.position), to_vec(end.position), at)),
            turn.turns() ? to_dquat(turn.at(at)) : start.orientation};
}

dvec3 to_world(const Pose& pose, const dvec3& point) noexcept {
    const IeeeGuard guard;
    return to_dvec3(to_vec(pose.position) + Frame(pose.orientation).to_world(to_vec(point)));
}

dvec3 to_body(const Pose& pose, const dvec3& place) noexcept {
    const IeeeGuard guard;
    return to_dvec3(Frame(pose.orientation).to_local(to_vec(place) - to_vec(pose.position)));
}

}  // namespace v0
}  // namespace surefoot
