/// A triangle source out of what you have: your broad phase finds triangles near a box, and this makes every query of
/// it.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <surefoot/bounds.hpp>
#include <surefoot/hit.hpp>
#include <surefoot/math.hpp>
#include <surefoot/overlap.hpp>
#include <surefoot/query.hpp>
#include <surefoot/shapes.hpp>

namespace [[gnu::visibility("default")]] surefoot {
inline namespace v0 {

/// Where a visit hands its triangles. Lives as long as the visit.
class TriangleSink {
public:
    /// `target` is handed to `take` with every triangle.
    constexpr TriangleSink(void* target, void (*take)(void*, const SourceTriangle&) noexcept) noexcept
        : target_(target), take_(take) {}

    void operator()(const Triangle& triangle, std::uint32_t id, std::uint32_t surface = 0) const noexcept {
        take_(target_, SourceTriangle{.triangle = triangle, .id = id, .surface = surface});
    }
    void operator()(const SourceTriangle& triangle) const noexcept { take_(target_, triangle); }

private:
    void* target_;
    void (*take_)(void*, const SourceTriangle&) noexcept;
};

/// What your side has to offer.
///  - `bounds()`: a box around all triangles, each coordinate within +-1e9.
///  - `visit(near, sink)`: hands every triangle that may touch the box `near` to the sink, in any order. More triangles
///    than that are fine and only cost time, but none may come twice in one visit. `near` reaches beyond your bounds.
///  - `triangle(id)` and `surface(id)`: the same as came with that id.
/// None may throw, and all must be safe from as many threads as ask at once.
template <typename T>
concept VisitsTriangles = requires(const T& mine, const Bounds& near, const TriangleSink& sink, std::uint32_t id) {
    { mine.bounds() } -> std::convertible_to<Bounds>;
    mine.visit(near, sink);
    { mine.triangle(id) } -> std::convertible_to<Triangle>;
    { mine.surface(id) } -> std::convertible_to<std::uint32_t>;
};

/// Every query of a source from your `visit`. Non-owning: what it is made of must outlive it.
///
/// The queries are those of `Mesh`, and their answers are those of a mesh with the same triangles, bit for bit. A long
/// sweep visits piece after piece of its way and ends at the piece in which it hits. A triangle with a coordinate
/// beyond 1e9 m blocks with status `invalid`. Allocates nothing itself; threads: as safe as what it is made of.
class VisitedSource {
public:
    template <VisitsTriangles Mine>
    explicit VisitedSource(const Mine& mine) noexcept
        : mine_(&mine),
          bounds_([](const void* m) noexcept -> Bounds { return static_cast<const Mine*>(m)->bounds(); }),
          visit_([](const void* m, const Bounds& near, const TriangleSink& sink) noexcept {
              static_cast<const Mine*>(m)->visit(near, sink);
          }),
          triangle_([](const void* m, std::uint32_t id) noexcept -> Triangle {
              return static_cast<const Mine*>(m)->triangle(id);
          }),
          surface_([](const void* m, std::uint32_t id) noexcept -> std::uint32_t {
              return static_cast<const Mine*>(m)->surface(id);
          }) {}
    template <VisitsTriangles Mine>
    explicit VisitedSource(const Mine&& does_not_live_long_enough) = delete;

    /// See Mesh; ties go to the lowest id.
    [[nodiscard]] std::optional<Hit> sweep(const Volume& volume, const Motion& motion,
                                           const QueryOptions& options = {}) const noexcept;
    [[nodiscard]] bool sweep_any(const Volume& volume, const Motion& motion,
                                 const QueryOptions& options = {}) const noexcept;
    [[nodiscard]] std::optional<Hit> ray(const Motion& motion, const QueryOptions& options = {}) const noexcept;
    [[nodiscard]] bool ray_any(const Motion& motion, const QueryOptions& options = {}) const noexcept;
    std::size_t overlap(const Volume& volume, const dvec3& position, std::span<Overlap> found,
                        const QueryOptions& options = {}) const noexcept;
    [[nodiscard]] std::optional<NearestPoint> nearest(const dvec3& point, double farthest,
                                                      const QueryOptions& options = {}) const noexcept;
    /// As for Mesh, but the kinds of edges are those that you hand out.
    std::size_t gather(const Bounds& near, std::span<SourceTriangle> found,
                       const QueryOptions& options = {}) const noexcept;

    [[nodiscard]] Bounds bounds() const noexcept { return bounds_(mine_); }
    [[nodiscard]] Triangle triangle(std::uint32_t id) const noexcept { return triangle_(mine_, id); }
    [[nodiscard]] std::uint32_t surface(std::uint32_t id) const noexcept { return surface_(mine_, id); }

private:
    class Finder;

    const void* mine_;
    Bounds (*bounds_)(const void*) noexcept;
    void (*visit_)(const void*, const Bounds&, const TriangleSink&) noexcept;
    Triangle (*triangle_)(const void*, std::uint32_t) noexcept;
    std::uint32_t (*surface_)(const void*, std::uint32_t) noexcept;
};

}  // namespace v0
}  // namespace surefoot
