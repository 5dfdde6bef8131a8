// The one idea of every overlap here. Let M be all positions of the reference point at which the shape K touches the
// triangle T: M is the convex set T (+) (-K). Along a unit direction n
//
//     depth(n) = max over corners v of n.v + h_K(-n)          (h_K the support function, v relative to the shape)
//
// is how far the shape must move along n to have T wholly behind a plane: always enough, whatever n is. The shortest
// way out is the least depth over all n, and a negative depth is a plane that separates. So each shape proposes the
// normals that its smooth patches of M can have, and none of them needs to be tested for being "the right case": the
// least depth picks it.
#pragma once

#include "overlap/problem.hpp"

namespace surefoot::internal {

/// `Support` is `double support(const Vec& n)`: h_K(n), the shape's extent along a unit n from its reference point.
template <typename Support>
class Ways {
public:
    Ways(const TriangleProblem& triangle, const Support& support, double shape_size) noexcept
        : triangle_(triangle), support_(support), hair_(touching_hair * larger(triangle.scale, shape_size)) {}

    /// Considers `direction`, of any length, and its opposite. The first of two equally good ways is kept.
    void both(const Vec& direction) noexcept {
        const Vec n = unit(direction);
        if (n == Vec{}) return;
        const double a = dot(n, triangle_.corner[0]);
        const double b = dot(n, triangle_.corner[1]);
        const double c = dot(n, triangle_.corner[2]);
        keep(n, larger(a, larger(b, c)) + support_(-n));
        keep(-n, support_(n) - smaller(a, smaller(b, c)));
    }

    /// Considers `direction`, of any length, alone.
    void one(const Vec& direction) noexcept {
        const Vec n = unit(direction);
        if (n == Vec{}) return;
        const double far = larger(dot(n, triangle_.corner[0]),  //
                                  larger(dot(n, triangle_.corner[1]), dot(n, triangle_.corner[2])));
        keep(n, far + support_(-n));
    }

    [[nodiscard]] bool touches() const noexcept { return least_ >= -hair_; }
    [[nodiscard]] double hair() const noexcept { return hair_; }

    /// The least depth, with the point left for the shape to find.
    [[nodiscard]] WayOut best() const noexcept {
        WayOut way;
        way.normal = normal_;
        way.depth = depth_;
        way.touches = touches();
        return way;
    }

private:
    // A later way has to be better by more than rounding: so the front of a face wins for a centre on its plane.
    void keep(const Vec& n, double depth) noexcept {
        least_ = smaller(least_, depth);
        if (depth < depth_ - hair_) {
            depth_ = depth;
            normal_ = n;
        }
    }

    const TriangleProblem& triangle_;
    const Support& support_;
    double hair_;
    double least_ = 1e300;
    double depth_ = 1e300;
    Vec normal_;
};

}  // namespace surefoot::internal
