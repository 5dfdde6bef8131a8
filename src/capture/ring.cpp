#include <cassert>

#include <surefoot/capture_session.hpp>

namespace surefoot {
inline namespace v0 {

void StepRing::push(const CharacterInput& input, double dt, const CharacterState& before,
                    std::span<const BodyPose> moved, std::span<const Neighbour> neighbours) noexcept {
    if (ticks_.empty()) return;
    if (moved.size() > poses_.size() ||
        neighbours.size() > neighbours_.size()) {  // no room for even this one: what is before it would end in a hole
        pushed_ = 0;
        return;
    }
    ticks_[pushed_ % ticks_.size()] = {
        input, dt, before, poses_pushed_, moved.size(), neighbours_pushed_, neighbours.size()};
    for (const BodyPose& pose : moved) poses_[poses_pushed_++ % poses_.size()] = pose;
    for (const Neighbour& one : neighbours) neighbours_[neighbours_pushed_++ % neighbours_.size()] = one;
    ++pushed_;
}

std::size_t StepRing::size() const noexcept {
    std::size_t count = pushed_ < ticks_.size() ? static_cast<std::size_t>(pushed_) : ticks_.size();
    const auto is_kept = [](std::uint64_t first, std::uint64_t number, std::uint64_t pushed, std::uint64_t room) {
        return number == 0 || first + room >= pushed;
    };
    for (; count > 0; --count) {
        const RingTick& tick = ticks_[(pushed_ - count) % ticks_.size()];
        if (is_kept(tick.first_pose, tick.pose_count, poses_pushed_, poses_.size()) &&
            is_kept(tick.first_neighbour, tick.neighbour_count, neighbours_pushed_, neighbours_.size())) {
            break;
        }
    }
    return count;
}

const RingTick& StepRing::operator[](std::size_t index) const noexcept {
    const std::size_t count = size();
    assert(index < count && "StepRing: there is no such tick; ask size() first");
    return ticks_[(pushed_ - count + index) % ticks_.size()];
}

const BodyPose& StepRing::pose(const RingTick& tick, std::size_t pose) const noexcept {
    assert(pose < tick.pose_count && "StepRing: the tick has no such pose");
    return poses_[(tick.first_pose + pose) % poses_.size()];
}

const Neighbour& StepRing::neighbour(const RingTick& tick, std::size_t neighbour) const noexcept {
    assert(neighbour < tick.neighbour_count && "StepRing: the tick has no such neighbour");
    return neighbours_[(tick.first_neighbour + neighbour) % neighbours_.size()];
}

Session session_of(const StepRing& ring, const World& world, const CharacterSettings& settings,
                   const CharacterState& now) {
    const std::size_t count = ring.size();
    Session session = begin_session(world, settings, count > 0 ? ring[0].before : now);
    for (std::size_t i = 0; i < count; ++i) {
        const RingTick& tick = ring[i];
        std::vector<BodyPose> moved;
        for (std::size_t k = 0; k < tick.pose_count; ++k) moved.push_back(ring.pose(tick, k));
        std::vector<Neighbour> neighbours;
        for (std::size_t k = 0; k < tick.neighbour_count; ++k) neighbours.push_back(ring.neighbour(tick, k));
        record(session, tick.input, tick.dt, i + 1 < count ? ring[i + 1].before : now, moved, neighbours);
    }
    return session;
}

}  // namespace v0
}  // namespace surefoot
