// Many triangles, one answer: what every source does with the answers of its triangles. Whatever the order in which
// they arrive, the result is the same.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include <surefoot/hit.hpp>
#include <surefoot/overlap.hpp>
#include <surefoot/query.hpp>

#include "vec.hpp"

namespace surefoot::internal {

/// The first of many hits: the lowest t, then the lowest body, then the lowest triangle.
class FirstHit {
public:
    void offer(const std::optional<Hit>& hit) noexcept {
        if (hit && (!first_ || is_before(*hit, *first_))) first_ = hit;
    }
    /// What begins later than this cannot matter any more.
    [[nodiscard]] double limit() const noexcept { return first_ ? first_->t : 1.0; }
    [[nodiscard]] const std::optional<Hit>& get() const noexcept { return first_; }

private:
    static bool is_before(const Hit& a, const Hit& b) noexcept {
        if (a.t != b.t) return a.t < b.t;
        return a.body != b.body ? a.body < b.body : a.triangle < b.triangle;
    }
    std::optional<Hit> first_;
};

/// Overlaps into the caller's room by (body, triangle). The last one falls out when there is no more room.
class OverlapsInOrder {
public:
    explicit OverlapsInOrder(std::span<Overlap> room) noexcept : room_(room) {}
    void add(const Overlap& overlap) noexcept;
    /// How many there were, which may be more than found room.
    [[nodiscard]] std::size_t count() const noexcept { return count_; }

private:
    std::span<Overlap> room_;
    std::size_t count_ = 0;
};

/// Puts the first `count` of gathered triangles in the order of (body, id). Never allocates.
void sort_gathered(std::span<SourceTriangle> found) noexcept;

/// The nearest of many points: the least distance, then the lowest body, then the lowest triangle.
class NearestOfAll {
public:
    /// Nothing beyond `farthest` [m] counts.
    NearestOfAll(const dvec3& point, double farthest) noexcept : point_(to_vec(point)), limit_(farthest) {}
    void offer(const SourceTriangle& triangle) noexcept;
    /// What is farther than this cannot matter any more [m].
    [[nodiscard]] double limit() const noexcept { return limit_; }
    [[nodiscard]] const std::optional<NearestPoint>& get() const noexcept { return nearest_; }

private:
    Vec point_;
    double limit_;
    std::optional<NearestPoint> nearest_;
};

}  // namespace surefoot::internal
