// Cylinder and cone at a touching start: the planes at which M can be least deep, and which of them the motion closes
// on. Written once for doubles, which decide the plain cases, and once for 512-digit reals, which decide the rest.
//
// The least depth of the origin in M is attained on a smooth patch of M: on a cap, on the triangle's plane, on the side
// against an edge or against a vertex, or on the rim against an edge. Seen along that edge the rim is an ellipse, and
// the nearest point of an ellipse is the one root of a convex, falling function: Eberly, "Distance from a Point to an
// Ellipse".
#pragma once

#include <cstdint>
#include <type_traits>

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

/// Names the planes: two caps, two faces, and then for each edge two sides against it, the side against its first
/// corner, any side about its first corner on the axis, and the two rims against it.
struct UprightSlot {
    static constexpr int cap = 0;
    static constexpr int face = 2;
    static constexpr int first_edge = 4;
    static constexpr int per_edge = 6;
    static constexpr int count = first_edge + 3 * per_edge;
    static constexpr int side_of_edge = 0;
    static constexpr int side_of_vertex = 2;
    static constexpr int about_axis = 3;
    static constexpr int rim = 4;
    static constexpr int outside = count;  ///< what only a shape that is apart can be nearest along
    static constexpr std::uint32_t all = (1U << count) - 1;

    [[nodiscard]] static constexpr int of_edge(int edge, int which) noexcept {
        return first_edge + per_edge * edge + which;
    }
};

/// Where doubles found the roots of the rims, as a share of the squared radius; 0 for none.
struct RimRoots {
    double near_[6] = {};
    double far_[6] = {};
};

template <typename Scalar>
class UprightStart {
public:
    /// `hair`: how near the axis counts as on it; in doubles, also the rounding in corners and gaps.
    UprightStart(const ExactVec<Scalar> (&corners)[3], const ExactVec<Scalar>& along, const UprightShape<Scalar>& shape,
                 const Scalar& hair) noexcept
        : corners_{corners[0], corners[1], corners[2]}, along_(along), shape_(shape), hair_(hair) {}

    /// Proposes the planes whose slot is in the set `wanted`. Newton's method starts from `roots` if there are any.
    void propose(std::uint32_t wanted = UprightSlot::all, const RimRoots* roots = nullptr) noexcept {
        const Scalar zero(0.0);
        const Scalar one(1.0);
        const auto wants = [&](int slot) {
            slot_ = slot;
            doubt_ = 0;
            return ((wanted >> slot) & 1U) != 0;
        };
        start_from_ = roots;
        if (wants(UprightSlot::cap)) add({zero, one, zero});
        if (wants(UprightSlot::cap + 1)) add({zero, -one, zero});
        const ExactVec<Scalar> first = corners_[1] - corners_[0];
        const ExactVec<Scalar> second = corners_[2] - corners_[0];
        for (const int side : {0, 1}) {
            if (!wants(UprightSlot::face + side)) continue;
            const ExactVec<Scalar> normal = cross(first, second);
            doubt(size_in_doubles(first) + size_in_doubles(second), size_in_doubles(normal));
            add(side == 0 ? normal : -normal);
        }
        for (int i = 0; i < 3; ++i) {
            const auto slot = [&](int which) { return UprightSlot::of_edge(i, which); };
            const ExactVec<Scalar> edge = corners_[(i + 1) % 3] - corners_[i];
            for (const int side : {0, 1}) {
                if (wants(slot(UprightSlot::side_of_edge + side))) add_side_against_edge(edge, side == 0);
            }
            const ExactVec<Scalar> level{corners_[i].x, zero, corners_[i].z};
            doubt(1, size_in_doubles(level));
            if (wants(slot(UprightSlot::side_of_vertex))) {
                doubt(1, size_in_doubles(level));
                add_side(-level.x, -level.z);
            }
            // On the axis all sides are as near; the one that the motion leaves the most counts.
            if (wants(slot(UprightSlot::about_axis)) && is_on_axis(level)) {
                doubt_ = 1;
                add_side(along_.x, along_.z);
            }
            for (const int rim : {0, 1}) {
                if (!wants(slot(UprightSlot::rim + rim)) || (rim == 1 && shape_.is_cone)) continue;
                rim_ = 2 * i + rim;
                add_rim_against_edge(corners_[i], edge, rim == 0 ? shape_.height : -shape_.height);
            }
        }
    }

    /// Proposes the normals along which a shape that is apart can be nearest and one in touch cannot be the least deep:
    /// a cone's apex against corners and edges, and the rims against corners and level edges.
    void propose_outside() noexcept {
        slot_ = UprightSlot::outside;
        doubt_ = 1;
        for (int i = 0; i < 3; ++i) {
            const ExactVec<Scalar>& corner = corners_[i];
            if (shape_.is_cone) {
                add(-corner);
                const ExactVec<Scalar> edge = corners_[(i + 1) % 3] - corner;
                const Scalar share = dot(corner, edge);
                add(edge * share - corner * dot(edge, edge));
            }
            add_rims_against_level_edge(corner, corners_[(i + 1) % 3] - corner);
            const Scalar sideways = square_root(corner.x * corner.x + corner.z * corner.z);
            if (sign_of(sideways) == 0) continue;
            const Scalar inward = shape_.radius / sideways - Scalar(1.0);
            add({corner.x * inward, shape_.height - corner.y, corner.z * inward});
            if (!shape_.is_cone) add({corner.x * inward, -shape_.height - corner.y, corner.z * inward});
        }
    }

    struct Plane {
        ExactVec<Scalar> normal;  ///< unit
        Scalar gap;
        Scalar approach;
        int slot = 0;
        double doubt = 0;  ///< in doubles: how far the normal may be turned [rad]
    };

    [[nodiscard]] int count() const noexcept { return count_; }
    [[nodiscard]] const Plane& plane(int i) const noexcept { return planes_[i]; }
    [[nodiscard]] const RimRoots& roots() const noexcept { return roots_; }

    /// The plane with the largest gap of all. Requires: count() > 0.
    [[nodiscard]] const Plane& nearest() const noexcept {
        int largest = 0;
        for (int i = 1; i < count_; ++i) {
            if (planes_[i].gap > planes_[largest].gap) largest = i;
        }
        return planes_[largest];
    }

private:
    static constexpr bool is_rough = std::is_same_v<Scalar, double>;

    static double size_in_doubles(const ExactVec<Scalar>& v) noexcept {
        if constexpr (is_rough) return square_root(dot(v, v));
        return 1;
    }

    // The normal is turned by at most so many hairs over a length.
    void doubt(double hairs, double length) noexcept {
        if constexpr (is_rough) {
            const double turn = 2 * hairs * hair_ / length;
            doubt_ = turn < 1 ? turn : 1;
        }
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
        return {normal, -top - reach, dot(normal, along_), slot_, doubt_};
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

    [[nodiscard]] bool is_on_axis(const ExactVec<Scalar>& corner) const noexcept {
        return !(corner.x * corner.x + corner.z * corner.z > hair_ * hair_);
    }

    void add_side_against_edge(const ExactVec<Scalar>& edge, bool is_first) noexcept {
        const ExactVec<Scalar> level{edge.x, Scalar(0.0), edge.z};
        doubt(2, size_in_doubles(level));
        if (!shape_.is_cone) {
            add(is_first ? ExactVec<Scalar>{-edge.z, Scalar(0.0), edge.x}
                         : ExactVec<Scalar>{edge.z, Scalar(0.0), -edge.x});
            return;
        }
        // h . edge_h * height = -edge.y * radius
        const Scalar squared = edge.x * edge.x + edge.z * edge.z;
        const Scalar lean = -shape_.radius * edge.y / shape_.height;
        Scalar rest = squared - lean * lean;
        if (sign_of(squared) == 0) return;
        if constexpr (is_rough) {
            const double blur = 2 * (size_in_doubles(level) + absolute(lean)) *
                                (hair_ * (1 + shape_.radius / shape_.height) + 0x1p-50 * size_in_doubles(level));
            if (rest < -blur) return;
            doubt_ = rest > 2 * blur ? smaller(1, doubt_ + blur / rest) : 1;
            rest = larger(rest, 0);
        }
        if (sign_of(rest) < 0) return;
        const Scalar other = is_first ? square_root(rest) : -square_root(rest);
        add_side(lean * edge.x - other * edge.z, lean * edge.z + other * edge.x);
    }

    // Seen along a level edge a rim is a line, which the shape has an end of on either side of its axis.
    void add_rims_against_level_edge(const ExactVec<Scalar>& corner, const ExactVec<Scalar>& edge) noexcept {
        const Scalar length = square_root(edge.x * edge.x + edge.z * edge.z);
        if (sign_of(edge.y) != 0 || sign_of(length) == 0) return;
        const ExactVec<Scalar> across{-edge.z / length, Scalar(0.0), edge.x / length};
        const Scalar u = dot(corner, across);
        const Scalar inward = sign_of(u) < 0 ? -shape_.radius - u : shape_.radius - u;
        add({across.x * inward, shape_.height - corner.y, across.z * inward});
        if (!shape_.is_cone) add({across.x * inward, -shape_.height - corner.y, across.z * inward});
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
            doubt_ = 1;
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
            if constexpr (is_rough) doubt_ = doubt_of_rim(u, v, a2, c2, along_across, along_upward, sideways, edge.y);
            add(-(across * along_across + upward * along_upward));
        };
        if (is_rough ? sign_of(v) == 0 : !(v > hair_) && !(v < -hair_)) {
            // On the long axis: straight out along it, or the two points where the ellipse is nearest, side by side.
            add_normal(u, Scalar(0.0));
            const Scalar share = u / (a2 * slope * slope);
            Scalar rest = Scalar(1.0) - a2 * share * share;
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
        const auto add_root = [&](const Scalar& safe, double known, bool is_far) {
            const auto leaves = [&](const Scalar& w) {
                return is_far ? sign_of(b2 + w) <= 0 || sign_of(w) >= 0 : sign_of(w) <= 0;
            };
            bool is_safe = known == 0;
            Scalar w = is_safe ? safe : a2 * Scalar(known);
            for (int step = 0; step < newton_steps; ++step) {
                const Scalar over_u = Scalar(1.0) / (b2 + w);
                const Scalar over_v = Scalar(1.0) / w;
                const Scalar p = u * over_u;
                const Scalar q = v * over_v;
                const Scalar from_p = a2 * p * p;
                const Scalar from_q = c2 * q * q;
                const Scalar falling = Scalar(2.0) * (from_p * over_u + from_q * over_v);
                const bool lost = is_far && sign_of(falling) >= 0;
                if (!lost && sign_of(falling) == 0) break;
                const Scalar change = lost ? Scalar(0.0) : (from_p + from_q - Scalar(1.0)) / falling;
                if (lost || leaves(w + change)) {
                    if (is_safe) return;
                    is_safe = true;
                    w = safe;
                    continue;
                }
                w = w + change;
                const Scalar least = w * least_change();
                const Scalar size_of_least = sign_of(least) < 0 ? -least : least;
                if (!(change > size_of_least) && !(-change > size_of_least)) break;
            }
            if constexpr (is_rough) (is_far ? roots_.far_ : roots_.near_)[rim_] = w / a2;
            add_normal(u / (b2 + w), v / w);
        };
        const RimRoots none;
        const RimRoots& known = start_from_ != nullptr ? *start_from_ : none;
        add_root(from_u > c_v ? from_u : c_v, known.near_[rim_], false);
        if (!(c_v > b2)) add_root(-c_v, known.far_[rim_], true);
    }

    // How far doubles may have turned a rim's normal: its slope along the ellipse and the rounding in it, over the
    // curvature of the gap. Where that is hardly curved (three roots meet on the axes) nothing is known.
    [[nodiscard]] double doubt_of_rim(double u, double v, double a2, double c2, double x, double y, double sideways,
                                      double climb) const noexcept {
        const double size = std::sqrt(x * x + y * y);
        const double edge = std::sqrt(sideways * sideways + climb * climb);
        const double nx = -x / size;
        const double ny = -y / size;
        const double h2 = a2 * nx * nx + c2 * ny * ny;
        const double h = std::sqrt(h2);
        const double bend = a2 * c2 / (h * h2);
        const double reach = std::sqrt(u * u + v * v) + shape_.radius;
        const double curvature = bend - (u * nx + v * ny) - h;
        const double blur = 2 * hair_ * (1 + reach / edge + reach / sideways + shape_.radius / absolute(climb));
        const double slope = absolute(u * ny - v * nx - (c2 - a2) * nx * ny / h);
        const double turn = (slope + blur) / curvature;
        const bool is_sound = curvature > 0 && 8 * turn * (3 * bend * a2 / h2 + reach) < curvature;
        return is_sound ? smaller(1, 2 * (turn + 2 * hair_ / sideways)) : 1;
    }

    // A share of the root: Newton's method has settled.
    static Scalar least_change() noexcept {
        if constexpr (is_rough) return 0x1p-51;
        if constexpr (std::is_same_v<Scalar, WideReal>) return Scalar(0x1p-1000) * Scalar(0x1p-1000);
        return Scalar(0x1p-440);
    }

    static constexpr int most = 48;
    static constexpr int newton_steps = 64;

    ExactVec<Scalar> corners_[3];
    ExactVec<Scalar> along_;
    UprightShape<Scalar> shape_;
    Scalar hair_;
    Plane planes_[most];
    RimRoots roots_;
    const RimRoots* start_from_ = nullptr;
    int count_ = 0;
    int slot_ = 0;
    int rim_ = 0;
    double doubt_ = 0;
};

/// Requires as in approach_at_start, and a cylinder or a cone.
[[nodiscard]] Approach upright_approach_at_start(const Volume& volume, const Motion& motion,
                                                 const Triangle& triangle) noexcept;

}  // namespace surefoot::internal
