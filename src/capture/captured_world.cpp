#include "capture/captured_world.hpp"

#include <cmath>

namespace surefoot::internal {

namespace {

bool is_box(const Bounds& bounds) noexcept {
    const auto in_order = [](double low, double high) {
        return std::isfinite(low) && std::isfinite(high) && low <= high;
    };
    return in_order(bounds.min.x, bounds.max.x) && in_order(bounds.min.y, bounds.max.y) &&
           in_order(bounds.min.z, bounds.max.z);
}

}  // namespace

CapturedWorld::CapturedWorld(std::span<const CapturedTriangle> triangles, std::span<const CapturedBody> bodies) {
    triangles_.reserve(bodies.size());
    sources_.reserve(bodies.size());  // the world refers to them
    for (const CapturedBody& body : bodies) {
        const auto [begin, end] =
            std::equal_range(triangles.begin(), triangles.end(), CapturedTriangle{.body = body.body},
                             [](const CapturedTriangle& a, const CapturedTriangle& b) { return a.body < b.body; });
        sources_.emplace_back(triangles_.emplace_back(std::span(begin, end), body.bounds));
        is_whole_ = is_whole_ && body.body != lowest_free_body && is_box(body.bounds);
        if (!is_whole_) return;
        const auto handle = world_.add(sources_.back(), {.pose = body.start, .body = body.body});
        is_whole_ = handle && world_.move(*handle, body.start, body.end);
        if (!is_whole_) return;
    }
}

}  // namespace surefoot::internal
