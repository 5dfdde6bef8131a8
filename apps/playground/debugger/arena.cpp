#include "debugger/arena.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include <surefoot/overlap.hpp>
#include <surefoot/ray.hpp>
#include <surefoot/sweep.hpp>
#include <surefoot/visited_source.hpp>

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

/// A few triangles as they are typed, to whoever asks: all of them, whatever is near.
struct FewTriangles {
    std::vector<Triangle> all;

    [[nodiscard]] Bounds bounds() const noexcept {
        if (all.empty()) return {};
        Bounds box{all[0].a, all[0].a};
        for (const Triangle& triangle : all) {
            for (const dvec3& corner : corners_of(triangle)) {
                box.min = glm::min(box.min, corner);
                box.max = glm::max(box.max, corner);
            }
        }
        return box;
    }
    void visit(const Bounds& /*near*/, const TriangleSink& sink) const noexcept {
        for (std::size_t i = 0; i < all.size(); ++i) sink(all[i], static_cast<std::uint32_t>(i));
    }
    [[nodiscard]] Triangle triangle(std::uint32_t id) const noexcept { return id < all.size() ? all[id] : Triangle{}; }
    [[nodiscard]] std::uint32_t surface(std::uint32_t /*id*/) const noexcept { return 0; }
};

bool are_numbers(const Bounds& box) {
    constexpr double farthest = 1e9;  // that a source may reach [m]
    const auto within = [](const dvec3& p) {
        return std::abs(p.x) <= farthest && std::abs(p.y) <= farthest && std::abs(p.z) <= farthest;
    };
    return within(box.min) && within(box.max);
}

}  // namespace

struct Arena::Stage {
    FewTriangles few;
    VisitedSource source{few};
    World world;

    // What is no number makes no world; then a step meets nothing, as the question is refused in words.
    explicit Stage(const std::vector<Triangle>& triangles) : few{triangles} {
        if (!few.all.empty() && are_numbers(few.bounds())) static_cast<void>(world.add(source));
    }
    explicit Stage(const Mesh& mesh) { static_cast<void>(world.add(mesh)); }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
};

Arena::Arena(std::vector<Triangle> triangles)
    : triangles_(std::move(triangles)), stage_(std::make_shared<const Stage>(triangles_)) {}

Arena::Arena(Mesh mesh) : mesh_(std::move(mesh)), stage_(std::make_shared<const Stage>(*mesh_)) {}

const World& Arena::world() const {
    return stage_->world;
}

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
