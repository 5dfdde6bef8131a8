// A polytope M given by the normals of its facets, exactly: capsule cores and boxes against a triangle.
#pragma once

#include "sweep/exact_query.hpp"
#include "sweep/start.hpp"

namespace surefoot::internal {

template <typename Number>
Number exact_absolute(const Number& a) noexcept {
    return a.sign() < 0 ? -a : a;
}

template <typename Number>
struct ExactPlane {
    ExactVec<Number> normal;
    Number gap;       ///< at `from`, times |normal|
    Number approach;  ///< normal . along

    /// `reach` gives the largest of -normal . k over the points k of the shape, in the query's scale.
    template <typename Reach>
    ExactPlane(const ExactQuery<Number>& query, const ExactVec<Number>& plane_normal, const Reach& reach) noexcept
        : normal(plane_normal), approach(dot(plane_normal, query.along)) {
        Number top = dot(normal, query.corners[0]);
        for (int i = 1; i < 3; ++i) {
            const Number height = dot(normal, query.corners[i]);
            if (compare(height, top) > 0) top = height;
        }
        gap = -top - reach(normal);
    }
    ExactPlane() noexcept = default;

    /// Less deep than the other, both with gap <= 0: -1, 0, 1 as in `compare` of the depths.
    [[nodiscard]] int compare_depth(const ExactPlane& other) const noexcept {
        return compare(gap * gap * dot(other.normal, other.normal), other.gap * other.gap * dot(normal, normal));
    }
};

/// The planes of M: up to the 13 pairs that a box has. Only the normals are kept; planes are made when asked for, since
/// exact numbers take room on the stack.
template <typename Number, typename Reach>
class ExactFacets {
public:
    ExactFacets(const ExactQuery<Number>& query, const Reach& reach) noexcept : query_(query), reach_(reach) {}

    void add_both(const ExactVec<Number>& normal) noexcept {
        if (is_zero(normal)) return;
        normals_[count_++] = normal;
        outside_ = outside_ || plane(2 * count_ - 2).gap.sign() > 0 || plane(2 * count_ - 1).gap.sign() > 0;
    }

    [[nodiscard]] bool origin_is_outside() const noexcept { return outside_; }

    /// With the origin in M: the facets at the least depth decide, all of them.
    [[nodiscard]] Approach approach_inside() const noexcept {
        ExactPlane<Number> least;
        bool some_not_closing = true;
        for (int i = 0; i < 2 * count_; ++i) {
            const ExactPlane<Number> candidate = plane(i);
            const int order = i == 0 ? -1 : candidate.compare_depth(least);
            if (order > 0) continue;
            if (order < 0) {
                least = candidate;
                some_not_closing = false;
            }
            some_not_closing = some_not_closing || candidate.approach.sign() >= 0;
        }
        return some_not_closing ? Approach::no_closer : Approach::deeper;
    }

    /// With the origin outside M by a hair: is there a plane, or a combination of two that is perpendicular to the
    /// motion, with a gap that does not close?
    [[nodiscard]] Approach approach_outside() const noexcept {
        for (int i = 0; i < 2 * count_; ++i) {
            const ExactPlane<Number> candidate = plane(i);
            if (candidate.gap.sign() > 0 && candidate.approach.sign() >= 0) return Approach::no_closer;
        }
        for (int i = 0; i < 2 * count_; ++i) {
            const ExactPlane<Number> closing = plane(i);
            if (closing.gap.sign() <= 0) continue;
            for (int j = 0; j < 2 * count_; ++j) {
                const ExactPlane<Number> opening = plane(j);
                if (opening.approach.sign() <= 0) continue;
                const ExactVec<Number> normal = closing.normal * opening.approach - opening.normal * closing.approach;
                if (ExactPlane<Number>(query_, normal, reach_).gap.sign() > 0) return Approach::no_closer;
            }
        }
        return Approach::deeper;
    }

private:
    [[nodiscard]] ExactPlane<Number> plane(int i) const noexcept {
        const ExactVec<Number>& normal = normals_[i / 2];
        return ExactPlane<Number>(query_, i % 2 == 0 ? normal : -normal, reach_);
    }

    const ExactQuery<Number>& query_;
    const Reach& reach_;
    ExactVec<Number> normals_[13];
    int count_ = 0;
    bool outside_ = false;
};

}  // namespace surefoot::internal
