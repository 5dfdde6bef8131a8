// A source that passes every question on to another, and remembers which triangles could be met: so a capture knows
// what a step saw, whatever the step asks.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <surefoot/source.hpp>

namespace surefoot::internal {

class Listener {
public:
    explicit Listener(const SourceView& source) noexcept : source_(source) {}

    [[nodiscard]] bool was_asked() const noexcept { return was_asked_; }

    /// In order, each once.
    [[nodiscard]] std::vector<std::uint32_t> heard() const {
        std::vector<std::uint32_t> ids = ids_;
        std::sort(ids.begin(), ids.end());
        ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
        return ids;
    }

    [[nodiscard]] Bounds bounds() const noexcept { return source_.bounds(); }
    [[nodiscard]] std::optional<Hit> sweep(const Volume& volume, const Motion& motion,
                                           const QueryOptions& options) const noexcept {
        listen(options, [&](const QueryOptions& all) { static_cast<void>(source_.sweep(volume, motion, all)); });
        return source_.sweep(volume, motion, options);
    }
    [[nodiscard]] bool sweep_any(const Volume& volume, const Motion& motion,
                                 const QueryOptions& options) const noexcept {
        listen(options, [&](const QueryOptions& all) { static_cast<void>(source_.sweep_any(volume, motion, all)); });
        return source_.sweep_any(volume, motion, options);
    }
    [[nodiscard]] std::optional<Hit> ray(const Motion& motion, const QueryOptions& options) const noexcept {
        listen(options, [&](const QueryOptions& all) { static_cast<void>(source_.ray(motion, all)); });
        return source_.ray(motion, options);
    }
    [[nodiscard]] bool ray_any(const Motion& motion, const QueryOptions& options) const noexcept {
        listen(options, [&](const QueryOptions& all) { static_cast<void>(source_.ray_any(motion, all)); });
        return source_.ray_any(motion, options);
    }
    std::size_t overlap(const Volume& volume, const dvec3& position, std::span<Overlap> found,
                        const QueryOptions& options) const noexcept {
        listen(options, [&](const QueryOptions& all) { source_.overlap(volume, position, {}, all); });
        return source_.overlap(volume, position, found, options);
    }
    [[nodiscard]] std::optional<NearestPoint> nearest(const dvec3& point, double farthest,
                                                      const QueryOptions& options) const noexcept {
        listen(options, [&](const QueryOptions& all) { static_cast<void>(source_.nearest(point, farthest, all)); });
        return source_.nearest(point, farthest, options);
    }
    std::size_t gather(const Bounds& near, std::span<SourceTriangle> found,
                       const QueryOptions& options) const noexcept {
        listen(options, [&](const QueryOptions& all) { source_.gather(near, {}, all); });
        return source_.gather(near, found, options);
    }
    [[nodiscard]] Triangle triangle(std::uint32_t id) const noexcept {
        ids_.push_back(id);
        return source_.triangle(id);
    }
    [[nodiscard]] std::uint32_t surface(std::uint32_t id) const noexcept { return source_.surface(id); }

private:
    // The question is asked with no triangle existing, so that no hit ends the search early: all of the way is seen.
    template <typename Ask>
    void listen(const QueryOptions& options, const Ask& ask) const noexcept {
        was_asked_ = true;
        const auto look = [&](std::uint32_t id, std::uint32_t surface) {
            if (options.filter(id, surface)) ids_.push_back(id);
            return false;
        };
        ask(QueryOptions{.one_sided = options.one_sided, .search = Search::scalar_tree, .filter = look});
    }

    SourceView source_;
    // A source is asked as a constant, but what it is asked is what is to be learned from it.
    mutable std::vector<std::uint32_t> ids_;
    mutable bool was_asked_ = false;
};

}  // namespace surefoot::internal
