// The sum of two shapes of this family is again one body: a box, with a level disc around it, with a ball around that.
//
//     sphere    no box, no disc, ball r           box        box, no disc, no ball
//     capsule   box (0, H, 0), no disc, ball r    cylinder   box (0, H, 0), disc r, no ball
//
// Half extents add, discs add and balls add, so ten pairs are one formula: two shapes touch when the point x, the one's
// reference point seen from the other's, is in box (+) disc (+) ball. With q = |x| - half extents, level and upright
// parts of the way out of the box are
//
//     level = sqrt(max(qx,0)^2 + max(qz,0)^2) - disc   (the larger of qx, qz inside)      upright = qy
//
// and the signed distance is sqrt(level^2 + upright^2) - ball where both are positive, else the larger of them - ball.
#include "pair/upright.hpp"

#include <utility>

#include "exact/products.hpp"
#include "overloaded.hpp"

namespace surefoot::internal {

namespace {

// Parallel to rounding: four units in the last place of a rotation matrix.
constexpr double parallel_hair = 0x1p-50;

bool are_along_one_line(const Vec& a, const Vec& b) noexcept {
    return largest(cross(a, b)) <= parallel_hair;
}

bool is_round_about_axis(const Shape& shape) noexcept {
    return std::holds_alternative<Capsule>(shape) || std::holds_alternative<Cylinder>(shape);
}

bool is_box(const Shape& shape) noexcept {
    return std::holds_alternative<Box>(shape);
}
bool is_sphere(const Shape& shape) noexcept {
    return std::holds_alternative<Sphere>(shape);
}

}  // namespace

bool UprightPair::add(const Placed& placed) noexcept {
    const Vec x = frame_.to_world({1, 0, 0});
    const Vec y = frame_.to_world({0, 1, 0});
    const bool axis_agrees = are_along_one_line(y, placed.axis());
    return std::visit(Overloaded{
                          [&](const Sphere& s) noexcept {
                              ball_ += s.radius;
                              return true;
                          },
                          [&](const Capsule& s) noexcept {
                              half_.y += s.half_height;
                              ball_ += s.radius;
                              return axis_agrees;
                          },
                          [&](const Box& s) noexcept {
                              half_ = half_ + to_vec(s.half_extents);
                              return axis_agrees && are_along_one_line(x, placed.frame().to_world({1, 0, 0}));
                          },
                          [&](const Cylinder& s) noexcept {
                              half_.y += s.half_height;
                              disc_ += s.radius;
                              return axis_agrees;
                          },
                          [&](const auto&) noexcept { return false; },
                      },
                      placed.shape());
}

std::optional<UprightPair> UprightPair::of(const PlacedPair& pair) noexcept {
    // The box, if there is one, says where its sides are; then whoever has an axis.
    const auto rank = [](const Placed& p) noexcept {
        return is_box(p.shape()) ? 2 : is_round_about_axis(p.shape()) ? 1 : is_sphere(p.shape()) ? 0 : 3;
    };
    UprightPair sum(rank(pair.a) > rank(pair.b) ? pair.a.frame() : pair.b.frame());
    if (!sum.add(pair.a) || !sum.add(pair.b)) return std::nullopt;
    return sum;
}

Gap UprightPair::gap_at(const Vec& x) const noexcept {
    const Vec p = frame_.to_local(x);
    const Vec q{absolute(p.x) - half_.x, absolute(p.y) - half_.y, absolute(p.z) - half_.z};
    const Vec sign{p.x < 0 ? -1.0 : 1.0, p.y < 0 ? -1.0 : 1.0, p.z < 0 ? -1.0 : 1.0};
    const Vec corner{larger(q.x, 0), 0, larger(q.z, 0)};
    const double corner_length = std::sqrt(corner.x * corner.x + corner.z * corner.z);
    double level = 0;
    Vec level_normal;
    if (corner_length > 0) {
        level = corner_length - disc_;
        level_normal = {sign.x * corner.x / corner_length, 0, sign.z * corner.z / corner_length};
    } else {
        level = larger(q.x, q.z) - disc_;
        level_normal = q.x >= q.z ? Vec{sign.x, 0, 0} : Vec{0, 0, sign.z};
    }
    const Vec up{0, sign.y, 0};
    Gap gap;
    if (level > 0 && q.y > 0) {
        const double distance = std::sqrt(level * level + q.y * q.y);
        gap.least = distance - ball_;
        gap.normal = level_normal * (level / distance) + up * (q.y / distance);
    } else {
        gap.least = larger(level, q.y) - ball_;
        gap.normal = q.y >= level ? up : level_normal;
    }
    gap.most = gap.least;
    gap.normal = frame_.to_world(gap.normal);
    return gap;
}

// The six planes of the box's faces cut the motion into at most seven pieces. On each of them the distance is one
// formula: linear against a face, a square root of a quadratic against an edge or corner of the box. The torus of a
// disc with a ball is left to the caller's planes, which then start from the piece's beginning.
double UprightPair::guess_entry(const Vec& from, const Vec& motion) const noexcept {
    const Vec local_from = frame_.to_local(from);
    const Vec local_motion = frame_.to_local(motion);
    const double x[3] = {local_from.x, local_from.y, local_from.z};
    const double v[3] = {local_motion.x, local_motion.y, local_motion.z};
    const double half[3] = {half_.x, half_.y, half_.z};
    double cuts[8] = {0};
    int count = 1;
    for (int i = 0; i < 3; ++i) {
        for (const double side : {-half[i], half[i]}) {
            const double t = v[i] != 0 ? (side - x[i]) / v[i] : 0;
            if (!(t > 0 && t < 1)) continue;
            int place = count++;
            for (; place > 1 && cuts[place - 1] > t; --place) cuts[place] = cuts[place - 1];
            cuts[place] = t;
        }
    }
    cuts[count] = 1;
    for (int piece = 0; piece < count; ++piece) {
        const double middle = (cuts[piece] + cuts[piece + 1]) / 2;
        // |level|^2 = a t^2 + 2 b t + c over the level axes that the motion is beyond, and the upright one added to it.
        double a = 0;
        double b = 0;
        double c = 0;
        const auto add_axis = [&](int i) noexcept {
            const double at = x[i] + v[i] * middle;
            if (absolute(at) <= half[i]) return false;
            const double sign = at < 0 ? -1 : 1;
            const double over = sign * x[i] - half[i];
            a += v[i] * v[i];
            b += sign * v[i] * over;
            c += over * over;
            return true;
        };
        const bool beyond_x = add_axis(0);
        const bool beyond_z = add_axis(2);
        const bool is_level = beyond_x || beyond_z;
        double radius = disc_ + ball_;
        if (absolute(x[1] + v[1] * middle) > half[1]) {
            if (!(ball_ > 0)) continue;
            if (is_level && disc_ > 0) return cuts[piece];
            add_axis(1);
            radius = ball_;
        } else if (!is_level) {
            return cuts[piece];
        }
        if (!(a > 0) || !(b < 0)) {
            if (c <= radius * radius) return cuts[piece];
            continue;
        }
        const double discriminant = difference_of_products(b, b, a, c - radius * radius);
        if (discriminant < 0) continue;
        const double t = (c - radius * radius) / (std::sqrt(discriminant) - b);
        if (t <= cuts[piece + 1]) return larger(t, cuts[piece]);
    }
    return 0;
}

}  // namespace surefoot::internal
