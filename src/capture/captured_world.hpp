// The triangles of a capture as sources, and its bodies as a world.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include <surefoot/capture.hpp>
#include <surefoot/visited_source.hpp>
#include <surefoot/world.hpp>

namespace surefoot::internal {

/// The captured triangles of one body. Every question goes to all of them, so none can be passed over.
class CapturedTriangles {
public:
    CapturedTriangles(std::span<const CapturedTriangle> triangles, const Bounds& bounds) noexcept
        : triangles_(triangles), bounds_(bounds) {}

    [[nodiscard]] Bounds bounds() const noexcept { return bounds_; }
    void visit(const Bounds&, const TriangleSink& sink) const noexcept {
        for (const CapturedTriangle& one : triangles_) sink(one.triangle, one.id, one.surface);
    }
    [[nodiscard]] Triangle triangle(std::uint32_t id) const noexcept {
        const CapturedTriangle* const one = find(id);
        return one != nullptr ? one->triangle : Triangle{};
    }
    [[nodiscard]] std::uint32_t surface(std::uint32_t id) const noexcept {
        const CapturedTriangle* const one = find(id);
        return one != nullptr ? one->surface : 0;
    }

private:
    [[nodiscard]] const CapturedTriangle* find(std::uint32_t id) const noexcept {
        const auto place = std::lower_bound(triangles_.begin(), triangles_.end(), id,
                                            [](const CapturedTriangle& a, std::uint32_t b) { return a.id < b; });
        return place != triangles_.end() && place->id == id ? &*place : nullptr;
    }

    std::span<const CapturedTriangle> triangles_;
    Bounds bounds_;
};

/// A world of what was captured. The lists must outlive it, and be in order.
class CapturedWorld {
public:
    CapturedWorld(std::span<const CapturedTriangle> triangles, std::span<const CapturedBody> bodies);
    CapturedWorld(const CapturedWorld&) = delete;
    CapturedWorld& operator=(const CapturedWorld&) = delete;

    /// False if the bodies make no world: a number twice, a pose or a box that cannot be.
    [[nodiscard]] bool is_whole() const noexcept { return is_whole_; }
    [[nodiscard]] const World& get() const noexcept { return world_; }

private:
    std::vector<CapturedTriangles> triangles_;
    std::vector<VisitedSource> sources_;
    World world_;
    bool is_whole_ = true;
};

}  // namespace surefoot::internal
