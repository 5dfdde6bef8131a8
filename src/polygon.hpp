// A convex polygon, such as a triangle clipped by planes.
#pragma once

#include "vec.hpp"

namespace surefoot::internal {

/// A triangle clipped by the six planes of a box has at most nine corners.
struct Polygon {
    static constexpr int most = 9;

    Vec points[most];
    int count = 0;

    void add(const Vec& point) noexcept {
        if (count < most) points[count++] = point;
    }

    /// Requires: count > 0.
    [[nodiscard]] Vec middle() const noexcept {
        Vec sum;
        for (int i = 0; i < count; ++i) sum = sum + points[i];
        return sum / count;
    }

    /// What lies at or below `bound` along `outward` (Sutherland and Hodgman, 1974).
    [[nodiscard]] Polygon clipped(const Vec& outward, double bound) const noexcept {
        Polygon kept;
        for (int i = 0; i < count; ++i) {
            const Vec& here = points[i];
            const Vec& next = points[i + 1 == count ? 0 : i + 1];
            const double over = dot(outward, here) - bound;
            const double over_next = dot(outward, next) - bound;
            if (over <= 0) kept.add(here);
            if ((over < 0 && over_next > 0) || (over > 0 && over_next < 0)) {
                kept.add(here + (next - here) * (over / (over - over_next)));
            }
        }
        return kept;
    }
};

}  // namespace surefoot::internal
