#include "crowd_grid.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace surefoot::navigation {

std::int32_t CrowdGrid::cell(float along) const {
    constexpr float most = 1e9F;
    return static_cast<std::int32_t>(std::floor(std::clamp(along / range_, -most, most)));
}

void CrowdGrid::fill(std::span<const vec3> places, float range) {
    range_ = range;
    const auto buckets = std::bit_ceil(std::max<std::size_t>(2 * places.size(), 16));
    mask_ = static_cast<std::uint32_t>(buckets - 1);
    first_.assign(buckets + 2, 0);
    sorted_.resize(places.size());
    // Counted two places ahead, so that filling leaves each beginning where it belongs.
    for (const vec3& place : places) ++first_[bucket(cell(place.x), cell(place.z)) + 2];
    for (std::size_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
    for (std::size_t i = 0; i < places.size(); ++i)
        sorted_[first_[bucket(cell(places[i].x), cell(places[i].z)) + 1]++] = static_cast<std::uint32_t>(i);
}

}  // namespace surefoot::navigation
