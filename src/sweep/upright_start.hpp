// Cylinder and cone at a touching start: the planes at which M can be least deep, and which of them the motion closes
// on. Written once for doubles, which decide the plain cases, and once for 640-digit reals, which decide the rest.
//
// The least depth of the origin in M is attained on a smooth patch of M: on a cap, on the triangle's plane, on the side
// against an edge or against a vertex, or on the rim against an edge. Seen along that edge the rim is an ellipse, and
// the nearest point of an ellipse is the one root of a convex, falling function: Eberly, "Distance from a Point to an
// Ellipse".
#pragma once

#include "exact/real.hpp"
#include "exact/vector.hpp"
#include "sweep/start.hpp"

namespace surefoot::internal {

/// Either shape, in the query's scale. The cylinder has two rims at +-height and a side that stands up straight; the
/// cone has one, at height, and its apex at the origin.
template <typename Scalar>
struct UprightShape {
    Scalar radius;
    Scalar height;
    bool is_cone = false;
};

template <typename Scalar>
class UprightStart {
public:
    UprightStart(const ExactVec<Scalar> (&corners)[3], const ExactVec<Scalar>& along, const UprightShape<Scalar>& shape,
                 const Scalar& axis_hair) noexcept
        : corners_{corners[0], corners[1], corners[2]}, along_(along), shape_(shape), axis_hair_(axis_hair) {}

    /// Proposes all planes, those of the rims last. With `skip_rims` they are left out.
    void propose(bool skip_rims) noexcept {
        const Scalar zero(0.0);
        const Scalar one(1.0);
        add_both({zero, one, zero});
        add_both(cross(corners_[1] - corners_[0], corners_[2] - corners_[0]));
        for (int i = 0; i < 3; ++i) {
            const ExactVec<Scalar> edge = corners_[(i + 1) % 3] - corners_[i];
            add_side_against_edge(edge);
            add_side_against_vertex(corners_[i]);
        }
        first_rim_ = count_;
        for (int i = 0; i < 3 && !skip_rims; ++i) {
            const ExactVec<Scalar> edge = corners_[(i + 1) % 3] - corners_[i];
            add_rim_against_edge(corners_[i], edge, shape_.height);
            if (!shape_.is_cone) add_rim_against_edge(corners_[i], edge, -shape_.height);
        }
    }

    struct Plane {
        ExactVec<Scalar> normal;  ///< unit
        Scalar gap;
        Scalar approach;
    };

    [[nodiscard]] int count() const noexcept { return count_; }
    /// Planes from here on are those of the rims.
    [[nodiscard]] int first_rim() const noexcept { return first_rim_; }
    [[nodiscard]] const Plane& plane(int i) const noexcept { return planes_[i]; }

    /// The combination of two planes that is perpendicular to the motion. Of a plane and its opposite nothing is left
    /// but rounding, so the approach of what comes out must be looked at too.
    [[nodiscard]] Plane combine(const Plane& closing, const Plane& opening) const noexcept {
        return make_plane(closing.normal * opening.approach - opening.normal * closing.approach);
    }

    /// The largest gap of all: minus the depth, if the origin is in M.
    [[nodiscard]] Scalar largest_gap() const noexcept {
        Scalar largest = planes_[0].gap;
        for (int i = 1; i < count_; ++i) {
            if (planes_[i].gap > largest) largest = planes_[i].gap;
        }
        return largest;
    }

private:
    void add_both(const ExactVec<Scalar>& normal) noexcept {
        add(normal);
        add({-normal.x, -normal.y, -normal.z});
    }

    void add(const ExactVec<Scalar>& normal) noexcept {
        if (sign_of(normal.x) == 0 && sign_of(normal.y) == 0 && sign_of(normal.z) == 0) return;
        if (count_ < most) planes_[count_++] = make_plane(normal);
    }

    [[nodiscard]] Plane make_plane(const ExactVec<Scalar>& direction) const noexcept {
        const Scalar size = square_root(dot(direction, direction));
        const ExactVec<Scalar> normal{direction.x / size, direction.y / size, direction.z / size};
        Scalar top = dot(normal, corners_[0]);
        for (int i = 1; i < 3; ++i) {
            const Scalar other = dot(normal, corners_[i]);
            if (other > top) top = other;
        }
        const Scalar sideways = square_root(normal.x * normal.x + normal.z * normal.z) * shape_.radius;
        Scalar reach;
        if (shape_.is_cone) {
            reach = sideways - normal.y * shape_.height;
            if (sign_of(reach) < 0) reach = Scalar(0.0);
        } else {
            const Scalar upright = normal.y * shape_.height;
            reach = sideways + (sign_of(upright) < 0 ? -upright : upright);
        }
        return {normal, -top - reach, dot(normal, along_)};
    }

    // The side's normal whose sideways part is along (x, z).
    void add_side(const Scalar& x, const Scalar& z) noexcept {
        const Scalar size = square_root(x * x + z * z);
        if (sign_of(size) == 0) return;
        if (shape_.is_cone) {
            add({x / size * shape_.height, shape_.radius, z / size * shape_.height});
        } else {
            add({x, Scalar(0.0), z});
        }
    }

    // On the axis all sides are as near; the one that the motion leaves the most counts.
    [[nodiscard]] bool is_on_axis(const ExactVec<Scalar>& corner) const noexcept {
        return !(corner.x * corner.x + corner.z * corner.z > axis_hair_ * axis_hair_);
    }

    void add_side_against_vertex(const ExactVec<Scalar>& corner) noexcept {
        if (is_on_axis(corner)) add_side(along_.x, along_.z);
        add_side(-corner.x, -corner.z);
    }

    void add_side_against_edge(const ExactVec<Scalar>& edge) noexcept {
        if (!shape_.is_cone) {
            add_both({-edge.z, Scalar(0.0), edge.x});
            return;
        }
        // h . edge_h * height = -edge.y * radius
        const Scalar squared = edge.x * edge.x + edge.z * edge.z;
        const Scalar lean = -shape_.radius * edge.y / shape_.height;
        const Scalar rest = squared - lean * lean;
        if (sign_of(squared) == 0 || sign_of(rest) < 0) return;
        const Scalar other = square_root(rest);
        add_side(lean * edge.x - other * edge.z, lean * edge.z + other * edge.x);
        add_side(lean * edge.x + other * edge.z, lean * edge.z - other * edge.x);
    }

    // Seen along the edge, the rim is an ellipse with half axes r across the climb of the edge and r |e.y| / |e| along
    // it, and the edge is a point; (across, upward) are its coordinates from the ellipse's centre.
    void add_rim_against_edge(const ExactVec<Scalar>& corner, const ExactVec<Scalar>& edge,
                              const Scalar& rim) noexcept {
        const Scalar sideways2 = edge.x * edge.x + edge.z * edge.z;
        const Scalar edge2 = sideways2 + edge.y * edge.y;
        if (sign_of(edge.y) == 0) return;
        if (sign_of(sideways2) == 0) {
            // Seen along an upright edge the rim is the circle that it is.
            if (is_on_axis(corner)) add({along_.x, Scalar(0.0), along_.z});
            add({-corner.x, Scalar(0.0), -corner.z});
            return;
        }
        const Scalar sideways = square_root(sideways2);
        const Scalar size = square_root(edge2);
        const ExactVec<Scalar> across{-edge.z / sideways, Scalar(0.0), edge.x / sideways};
        const Scalar tilt = edge.y / size;
        const Scalar slope = sideways / size;
        const ExactVec<Scalar> upward{-edge.x / sideways * tilt, slope, -edge.z / sideways * tilt};
        const ExactVec<Scalar> point{corner.x, corner.y - rim, corner.z};
        const Scalar u = dot(point, across);
        const Scalar v = dot(point, upward);
        const Scalar a2 = shape_.radius * shape_.radius;
        const Scalar c2 = a2 * tilt * tilt;
        const auto add_normal = [&](const Scalar& along_across, const Scalar& along_upward) {
            add(-(across * along_across + upward * along_upward));
        };
        if (sign_of(v) == 0) {
            // On the long axis: straight out along it, or the two points where the ellipse is nearest, side by side.
            add_normal(u, Scalar(0.0));
            const Scalar share = u / (a2 * slope * slope);
            const Scalar rest = Scalar(1.0) - a2 * share * share;
            if (sign_of(rest) < 0) return;
            const Scalar other = square_root(rest / c2);
            add_normal(share, other);
            add_normal(share, -other);
            return;
        }
        // The points of the ellipse whose normal runs through the edge are those with
        //     a2 u^2 / (b2 + w)^2 + c2 v^2 / w^2 = 1,      b2 = a2 - c2
        // The positive root is the nearest point. The root between -b2 and 0 that is nearer to 0 is the nearest on the
        // other side of the long axis; it counts where the triangle keeps the shape from leaving to the near side. Each
        // start has one term equal to 1, which leaves the sum above 1 and the root on the side to which Newton's method
        // moves. (Counted from 0 here, not from -c2: for an edge close to the long axis w is tiny, and must keep its
        // digits.)
        const Scalar b2 = a2 * slope * slope;
        const Scalar abs_u = sign_of(u) < 0 ? -u : u;
        const Scalar abs_v = sign_of(v) < 0 ? -v : v;
        const Scalar c_v = square_root(c2) * abs_v;
        const Scalar from_u = shape_.radius * abs_u - b2;
        const auto add_root = [&](Scalar w, bool is_far) {
            for (int step = 0; step < newton_steps; ++step) {
                const Scalar p = u / (b2 + w);
                const Scalar q = v / w;
                const Scalar value = a2 * p * p + c2 * q * q - Scalar(1.0);
                const Scalar falling = Scalar(2.0) * (a2 * p * p / (b2 + w) + c2 * q * q / w);
                if (is_far && sign_of(falling) >= 0) return;
                if (sign_of(falling) == 0) break;
                w = w + value / falling;
                if (is_far && sign_of(b2 + w) <= 0) return;
            }
            add_normal(u / (b2 + w), v / w);
        };
        add_root(from_u > c_v ? from_u : c_v, false);
        if (b2 > c_v) add_root(-c_v, true);
    }

    static constexpr int most = 48;
    static constexpr int newton_steps = 18;

    ExactVec<Scalar> corners_[3];
    ExactVec<Scalar> along_;
    UprightShape<Scalar> shape_;
    Scalar axis_hair_;  // how near the axis counts as on it
    Plane planes_[most];
    int count_ = 0;
    int first_rim_ = 0;
};

/// Requires as in approach_at_start, and a cylinder or a cone.
[[nodiscard]] Approach upright_approach_at_start(const Volume& volume, const Motion& motion,
                                                 const Triangle& triangle) noexcept;

}  // namespace surefoot::internal
