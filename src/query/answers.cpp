#include "query/answers.hpp"

#include <algorithm>

#include "overlap/closest.hpp"

namespace surefoot::internal {

void OverlapsInOrder::add(const Overlap& overlap) noexcept {
    const auto is_after = [&](const Overlap& other) {
        return other.body != overlap.body ? other.body > overlap.body : other.triangle > overlap.triangle;
    };
    std::size_t place = std::min(count_, room_.size());
    while (place > 0 && is_after(room_[place - 1])) {
        if (place < room_.size()) room_[place] = room_[place - 1];
        --place;
    }
    if (place < room_.size()) room_[place] = overlap;
    ++count_;
}

void sort_gathered(std::span<SourceTriangle> found) noexcept {
    std::sort(found.begin(), found.end(), [](const SourceTriangle& a, const SourceTriangle& b) {
        return a.body != b.body ? a.body < b.body : a.id < b.id;
    });
}

void NearestOfAll::offer(const SourceTriangle& candidate) noexcept {
    const OrderedTriangle world = ordered(candidate.triangle);
    const ClosestPoint found = closest_to_point(seen_by(Frame(dquat(1, 0, 0, 0)), world, point_), {});
    const double distance = found.distance;
    if (!(distance <= limit_)) return;
    if (nearest_ && distance == nearest_->distance) {
        const bool is_lower =
            candidate.body != nearest_->body ? candidate.body < nearest_->body : candidate.id < nearest_->triangle;
        if (!is_lower) return;
    }
    limit_ = distance;
    nearest_ = NearestPoint{.point = to_dvec3(found.corner >= 0 ? world.corner[found.corner] : point_ + found.point),
                            .distance = distance,
                            .triangle = candidate.id,
                            .surface = candidate.surface,
                            .body = candidate.body,
                            .feature = found.feature};
}

}  // namespace surefoot::internal
