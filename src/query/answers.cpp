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
    const auto is_before = [](const SourceTriangle& a, const SourceTriangle& b) {
        return a.body != b.body ? a.body < b.body : a.id < b.id;
    };
    // By insertion: a few dozen triangles that come in runs, leaf by leaf; or sorted already, from the only body.
    constexpr std::size_t few = 64;
    if (found.size() > few) {
        if (!std::is_sorted(found.begin(), found.end(), is_before)) std::sort(found.begin(), found.end(), is_before);
        return;
    }
    for (std::size_t i = 1; i < found.size(); ++i) {
        if (!is_before(found[i], found[i - 1])) continue;
        const SourceTriangle moved = found[i];
        std::size_t place = i;
        for (; place > 0 && is_before(moved, found[place - 1]); --place) found[place] = found[place - 1];
        found[place] = moved;
    }
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
