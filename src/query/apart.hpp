// Throwing out triangles that a moving shape certainly does not meet, before the exact test is asked. A few directions
// are tried; along any of them a gap that stays open proves it, however the direction was found.
#pragma once

#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

#include "exact/products.hpp"
#include "frame.hpp"
#include "query/reach.hpp"
#include "sweep/query.hpp"
#include "vec.hpp"

namespace surefoot::internal {

class ApartTest {
public:
    /// Requires: valid arguments; `extent` from extent_of, whose margin is that of this test too.
    ApartTest(const Volume& volume, const Motion& motion, const Box3& extent, double margin) noexcept
        : shape_(volume.shape),
          frame_(volume.orientation),
          from_(to_vec(motion.from)),
          along_(to_vec(motion.to) - from_),
          middle_((extent.min + extent.max) * 0.5),
          margin_(margin) {}

    /// True only if the shape keeps away from the triangle from time 0 to `end`.
    [[nodiscard]] bool operator()(const Triangle& triangle, double end) const noexcept {
        const Vec corners[3] = {to_vec(triangle.a) - from_, to_vec(triangle.b) - from_, to_vec(triangle.c) - from_};
        const Vec way = along_ * smaller(end, 1);
        const Vec normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
        if (keeps_apart(dot(normal, middle_ - corners[0]) < 0 ? -normal : normal, corners, way)) return true;
        const Vec away = middle_ - nearest(corners, normal);
        if (keeps_apart(away, corners, way)) return true;
        // Passing by: what is left of it across the motion.
        const double squared = dot(way, way);
        return squared > 0 && keeps_apart(away - way * (dot(away, way) / squared), corners, way);
    }

private:
    [[nodiscard]] bool keeps_apart(const Vec& direction, const Vec (&corners)[3], const Vec& way) const noexcept {
        const double size = length(direction);
        if (!(size > 0)) return false;
        const Vec n = direction / size;
        const double triangle = larger(dot(n, corners[0]), larger(dot(n, corners[1]), dot(n, corners[2])));
        const double nearest_of_way = smaller(0, dot(n, way));
        return nearest_of_way - triangle - margin_ > reach_against(shape_, unit(frame_.to_local(n)));
    }

    /// A point of the triangle near the one that is nearest to the middle (Ericson, Real-Time Collision
    /// Detection, 5.1).
    [[nodiscard]] Vec nearest(const Vec (&corners)[3], const Vec& normal) const noexcept {
        Vec best = corners[0];
        double least = never_near;
        bool inside = true;
        for (int i = 0; i < 3; ++i) {
            const Vec& a = corners[i];
            const Vec edge = corners[i == 2 ? 0 : i + 1] - a;
            const Vec from_a = middle_ - a;
            if (dot(cross(normal, edge), from_a) >= 0) continue;
            inside = false;
            const double share = dot(from_a, edge) / larger(dot(edge, edge), 1e-300);
            const Vec point = a + edge * larger(0, smaller(1, share));
            const Vec to_point = middle_ - point;
            if (dot(to_point, to_point) < least) {
                least = dot(to_point, to_point);
                best = point;
            }
        }
        if (!inside) return best;
        return middle_ - normal * (dot(normal, middle_ - corners[0]) / larger(dot(normal, normal), 1e-300));
    }

    static constexpr double never_near = 1e300;

    const Shape& shape_;
    Frame frame_;
    Vec from_;
    Vec along_;
    Vec middle_;  // of the shape, about its reference point
    double margin_;
};

}  // namespace surefoot::internal
