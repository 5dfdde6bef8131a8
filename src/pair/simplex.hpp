// Up to four points of the difference a - b of two shapes, and the point of their hull that is closest to the origin.
#pragma once

#include "vec.hpp"

namespace surefoot::internal {

struct Simplex {
    struct Corner {
        Vec at;    ///< on_a - on_b
        Vec on_a;  ///< farthest points of the two cores that made it
        Vec on_b;
        double weight = 0;
    };

    Corner corner[4];
    int count = 0;
    bool holds_origin = false;

    void add(const Vec& on_a, const Vec& on_b) noexcept { corner[count++] = {on_a - on_b, on_a, on_b, 0}; }
    [[nodiscard]] bool has(const Vec& at) const noexcept;

    /// Drops the corners that the closest point does not need and weighs the others; returns the closest point.
    Vec reduce() noexcept;
};

}  // namespace surefoot::internal
