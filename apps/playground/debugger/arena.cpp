#include "debugger/arena.hpp"

#include <algorithm>
#include <glm/common.hpp>

#include <surefoot/overlap.hpp>
#include <surefoot/ray.hpp>
#include <surefoot/sweep.hpp>

#include "debugger/support.hpp"

namespace surefoot::debugger {

namespace {

void take_earlier(std::optional<Hit>& first, std::optional<Hit> hit, std::size_t triangle) {
    if (!hit || (first && first->t <= hit->t)) return;
    hit->triangle = static_cast<std::uint32_t>(triangle);
    first = hit;
}

void take_deeper(std::optional<Overlap>& deepest, const std::optional<Overlap>& overlap) {
    if (overlap && (!deepest || overlap->depth > deepest->depth)) deepest = overlap;
}

/// How many touches at one place are looked at, of a level.
constexpr std::size_t most_touches = 256;

}  // namespace

std::optional<Hit> Arena::sweep(const Volume& volume, const Motion& motion, bool one_sided) const {
    if (mesh_) return mesh_->sweep(volume, motion, {.one_sided = one_sided});
    std::optional<Hit> first;
    for (std::size_t i = 0; i < triangles_.size(); ++i)
        take_earlier(first, surefoot::sweep(volume, motion, triangles_[i], {.one_sided = one_sided}), i);
    return first;
}

std::optional<Overlap> Arena::deepest(const Volume& volume, const dvec3& position, bool one_sided) const {
    std::optional<Overlap> deepest;
    if (mesh_) {
        std::vector<Overlap> found(most_touches);
        const std::size_t count = mesh_->overlap(volume, position, found, {.one_sided = one_sided});
        for (std::size_t i = 0; i < std::min(count, most_touches); ++i) take_deeper(deepest, found[i]);
        return deepest;
    }
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        auto overlap = surefoot::overlap(volume, position, triangles_[i], {.one_sided = one_sided});
        if (overlap) overlap->triangle = static_cast<std::uint32_t>(i);
        take_deeper(deepest, overlap);
    }
    return deepest;
}

bool Arena::touches(const Volume& volume, const dvec3& position, bool one_sided) const {
    return deepest(volume, position, one_sided).has_value();
}

std::optional<double> Arena::drop(const dvec3& point, double farthest) const {
    const Motion down{point, point - dvec3(0, farthest, 0)};
    std::optional<Hit> first;
    if (mesh_) {
        first = mesh_->ray(down);
    } else {
        for (std::size_t i = 0; i < triangles_.size(); ++i) take_earlier(first, surefoot::ray(down, triangles_[i]), i);
    }
    if (!first) return std::nullopt;
    return first->t * farthest;
}

std::vector<Triangle> Arena::along(const Volume& volume, const Motion& motion) const {
    if (!mesh_) return triangles_;
    const Bounds at_start = bounds_of(volume, motion.from);
    const Bounds at_end = bounds_of(volume, motion.to);
    const Bounds near{glm::min(at_start.min, at_end.min), glm::max(at_start.max, at_end.max)};
    std::vector<SourceTriangle> found(mesh_->gather(near, {}));
    const std::size_t count = mesh_->gather(near, found);
    std::vector<Triangle> triangles;
    for (std::size_t i = 0; i < std::min(count, found.size()); ++i) triangles.push_back(found[i].triangle);
    return triangles;
}

}  // namespace surefoot::debugger
