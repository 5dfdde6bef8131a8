/// A triangle source: anything that holds triangles with stable ids and can be asked where a shape meets them. Meshes,
/// height fields and voxels are sources; your own broad phase can be one.
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

/// What a source has to offer; the functions mean what they mean for `Mesh`. Every answer must be that of the source's
/// triangles asked one by one, whatever the search, and const calls must be safe from any number of threads.
template <typename T>
concept TriangleSource = requires(const T& source, const Volume& volume, const Motion& motion, const dvec3& point,
                                  double farthest, const Bounds& near, std::span<Overlap> overlaps,
                                  std::span<SourceTriangle> triangles, std::uint32_t id, const QueryOptions& options) {
    { source.bounds() }
    noexcept->std::same_as<Bounds>;
    { source.sweep(volume, motion, options) }
    noexcept->std::same_as<std::optional<Hit>>;
    { source.sweep_any(volume, motion, options) }
    noexcept->std::same_as<bool>;
    { source.ray(motion, options) }
    noexcept->std::same_as<std::optional<Hit>>;
    { source.ray_any(motion, options) }
    noexcept->std::same_as<bool>;
    { source.overlap(volume, point, overlaps, options) }
    noexcept->std::same_as<std::size_t>;
    { source.nearest(point, farthest, options) }
    noexcept->std::same_as<std::optional<NearestPoint>>;
    { source.gather(near, triangles, options) }
    noexcept->std::same_as<std::size_t>;
    { source.triangle(id) }
    noexcept->std::same_as<Triangle>;
    { source.surface(id) }
    noexcept->std::same_as<std::uint32_t>;
};

/// A view of any source, the size of two pointers. Non-owning: the source must outlive it.
class SourceView {
public:
    template <TriangleSource Source>
    requires(!std::same_as<Source, SourceView>) SourceView(const Source& source)
    noexcept : source_(&source), calls_(&calls_of<Source>) {}

    [[nodiscard]] Bounds bounds() const noexcept { return calls_->bounds(source_); }
    [[nodiscard]] std::optional<Hit> sweep(const Volume& volume, const Motion& motion,
                                           const QueryOptions& options = {}) const noexcept {
        return calls_->sweep(source_, volume, motion, options);
    }
    [[nodiscard]] bool sweep_any(const Volume& volume, const Motion& motion,
                                 const QueryOptions& options = {}) const noexcept {
        return calls_->sweep_any(source_, volume, motion, options);
    }
    [[nodiscard]] std::optional<Hit> ray(const Motion& motion, const QueryOptions& options = {}) const noexcept {
        return calls_->ray(source_, motion, options);
    }
    [[nodiscard]] bool ray_any(const Motion& motion, const QueryOptions& options = {}) const noexcept {
        return calls_->ray_any(source_, motion, options);
    }
    std::size_t overlap(const Volume& volume, const dvec3& position, std::span<Overlap> found,
                        const QueryOptions& options = {}) const noexcept {
        return calls_->overlap(source_, volume, position, found, options);
    }
    [[nodiscard]] std::optional<NearestPoint> nearest(const dvec3& point, double farthest,
                                                      const QueryOptions& options = {}) const noexcept {
        return calls_->nearest(source_, point, farthest, options);
    }
    std::size_t gather(const Bounds& near, std::span<SourceTriangle> found,
                       const QueryOptions& options = {}) const noexcept {
        return calls_->gather(source_, near, found, options);
    }
    [[nodiscard]] Triangle triangle(std::uint32_t id) const noexcept { return calls_->triangle(source_, id); }
    [[nodiscard]] std::uint32_t surface(std::uint32_t id) const noexcept { return calls_->surface(source_, id); }

private:
    struct Calls {
        Bounds (*bounds)(const void*) noexcept;
        std::optional<Hit> (*sweep)(const void*, const Volume&, const Motion&, const QueryOptions&) noexcept;
        bool (*sweep_any)(const void*, const Volume&, const Motion&, const QueryOptions&) noexcept;
        std::optional<Hit> (*ray)(const void*, const Motion&, const QueryOptions&) noexcept;
        bool (*ray_any)(const void*, const Motion&, const QueryOptions&) noexcept;
        std::size_t (*overlap)(const void*, const Volume&, const dvec3&, std::span<Overlap>,
                               const QueryOptions&) noexcept;
        std::optional<NearestPoint> (*nearest)(const void*, const dvec3&, double, const QueryOptions&) noexcept;
        std::size_t (*gather)(const void*, const Bounds&, std::span<SourceTriangle>, const QueryOptions&) noexcept;
        Triangle (*triangle)(const void*, std::uint32_t) noexcept;
        std::uint32_t (*surface)(const void*, std::uint32_t) noexcept;
    };

    template <typename Source>
    static const Source& as(const void* source) noexcept {
        return *static_cast<const Source*>(source);
    }

    template <typename Source>
    static constexpr Calls calls_of{
        [](const void* s) noexcept { return as<Source>(s).bounds(); },
        [](const void* s, const Volume& volume, const Motion& motion, const QueryOptions& options) noexcept {
            return as<Source>(s).sweep(volume, motion, options);
        },
        [](const void* s, const Volume& volume, const Motion& motion, const QueryOptions& options) noexcept {
            return as<Source>(s).sweep_any(volume, motion, options);
        },
        [](const void* s, const Motion& motion, const QueryOptions& options) noexcept {
            return as<Source>(s).ray(motion, options);
        },
        [](const void* s, const Motion& motion, const QueryOptions& options) noexcept {
            return as<Source>(s).ray_any(motion, options);
        },
        [](const void* s, const Volume& volume, const dvec3& position, std::span<Overlap> found,
           const QueryOptions& options) noexcept { return as<Source>(s).overlap(volume, position, found, options); },
        [](const void* s, const dvec3& point, double farthest, const QueryOptions& options) noexcept {
            return as<Source>(s).nearest(point, farthest, options);
        },
        [](const void* s, const Bounds& near, std::span<SourceTriangle> found, const QueryOptions& options) noexcept {
            return as<Source>(s).gather(near, found, options);
        },
        [](const void* s, std::uint32_t id) noexcept { return as<Source>(s).triangle(id); },
        [](const void* s, std::uint32_t id) noexcept { return as<Source>(s).surface(id); }};

    const void* source_;
    const Calls* calls_;
};

}  // namespace v0
}  // namespace surefoot
