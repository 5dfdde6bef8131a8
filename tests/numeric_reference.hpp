// What the tests of overlap, march and pair measure the library against: a small generator of random questions and
// slow, dense searches in long double that share nothing with the library but the definition of the shapes.
#pragma once

#include <cmath>
#include <cstdint>
#include <variant>
#include <vector>

#include <surefoot/math.hpp>
#include <surefoot/shapes.hpp>

#include "splitmix.hpp"

namespace surefoot::tests {

using Real = long double;

struct Point {
    Real x = 0;
    Real y = 0;
    Real z = 0;
};

inline Point point(const dvec3& v) {
    return {v.x, v.y, v.z};
}
inline Point operator+(const Point& a, const Point& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Point operator-(const Point& a, const Point& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Point operator-(const Point& a) {
    return {-a.x, -a.y, -a.z};
}
inline Point operator*(const Point& a, Real s) {
    return {a.x * s, a.y * s, a.z * s};
}
inline Real dot(const Point& a, const Point& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Point cross(const Point& a, const Point& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Real length(const Point& a) {
    return std::sqrt(dot(a, a));
}
inline Point unit(const Point& a) {
    return a * (1 / length(a));
}

/// v -> q v q* / |q|^2.
inline Point turn(const dquat& q, const Point& v) {
    const Point axis{q.x, q.y, q.z};
    const Real w = q.w;
    const Point inner = cross(axis, v) + v * w;
    return (cross(axis, inner) * 2 + v * (w * w + dot(axis, axis))) * (1 / (w * w + dot(axis, axis)));
}
inline Point turn_back(const dquat& q, const Point& v) {
    return turn(dquat(q.w, -q.x, -q.y, -q.z), v);
}

/// The largest n.k over the points k of the shape, relative to its reference point, by the words of shapes.hpp.
inline Real reach(const Volume& volume, const Point& direction) {
    const Point n = turn_back(volume.orientation, direction);
    const Real level = std::sqrt(n.x * n.x + n.z * n.z);
    if (const auto* s = std::get_if<Sphere>(&volume.shape)) return s->radius * length(n);
    if (const auto* s = std::get_if<Ellipsoid>(&volume.shape)) {
        return length({n.x * s->radii.x, n.y * s->radii.y, n.z * s->radii.z});
    }
    if (const auto* s = std::get_if<Capsule>(&volume.shape))
        return s->radius * length(n) + s->half_height * std::abs(n.y);
    if (const auto* s = std::get_if<Box>(&volume.shape)) {
        return s->half_extents.x * std::abs(n.x) + s->half_extents.y * std::abs(n.y) +
               s->half_extents.z * std::abs(n.z);
    }
    if (const auto* s = std::get_if<Cylinder>(&volume.shape)) return s->radius * level + s->half_height * std::abs(n.y);
    const auto& cone = std::get<Cone>(volume.shape);
    return std::max<Real>(0, cone.radius * level + cone.height * n.y);
}

/// Is `p`, relative to the reference point, within the shape shrunk by `margin` [a share of its size]?
inline bool is_within(const Volume& volume, const Point& p, Real margin = 0) {
    const Point v = turn_back(volume.orientation, p) * (1 / (1 - margin));
    const Real level = std::sqrt(v.x * v.x + v.z * v.z);
    if (const auto* s = std::get_if<Sphere>(&volume.shape)) return length(v) <= s->radius;
    if (const auto* s = std::get_if<Ellipsoid>(&volume.shape)) {
        return length({v.x / s->radii.x, v.y / s->radii.y, v.z / s->radii.z}) <= 1;
    }
    if (const auto* s = std::get_if<Capsule>(&volume.shape)) {
        const Real over = std::max<Real>(0, std::abs(v.y) - s->half_height);
        return std::sqrt(level * level + over * over) <= s->radius;
    }
    if (const auto* s = std::get_if<Box>(&volume.shape)) {
        return std::abs(v.x) <= s->half_extents.x && std::abs(v.y) <= s->half_extents.y &&
               std::abs(v.z) <= s->half_extents.z;
    }
    if (const auto* s = std::get_if<Cylinder>(&volume.shape)) {
        return level <= s->radius && std::abs(v.y) <= s->half_height;
    }
    const auto& cone = std::get<Cone>(volume.shape);
    const Real slope = static_cast<Real>(cone.radius) / cone.height;
    // Shrunk towards a point of its axis, not towards its apex, which is on its surface.
    const Real middle = static_cast<Real>(cone.height) / 2;
    const Real y = turn_back(volume.orientation, p).y;
    const Real shrunk = middle + (y - middle) / (1 - margin);
    return shrunk <= cone.height && level <= slope * shrunk;
}

/// Random numbers for questions about shapes.
class Random : public SplitMix {
public:
    using SplitMix::SplitMix;

    /// Equally likely in every octave.
    double octaves(double low, double high) { return low * std::exp2(in(0, std::log2(high / low))); }
    int below(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }
    /// Upright, spun about the vertical, or turned any way.
    dquat orientation() {
        const int kind = below(4);
        if (kind == 0) return dquat(1, 0, 0, 0);
        if (kind == 1) return dquat(1, 0, in(-1, 1), 0);
        return turn();
    }
};

/// One of the six shapes by number, with dimensions of 0.1 to 2.
inline Shape some_shape(Random& random, int kind) {
    const auto size = [&] { return random.octaves(0.1, 2); };
    switch (kind) {
        case 0:
            return Sphere{size()};
        case 1:
            return Ellipsoid{{size(), size(), size()}};
        case 2:
            return Capsule{size(), size()};
        case 3:
            return Box{{size(), size(), size()}};
        case 4:
            return Cylinder{size(), size()};
        default:
            return Cone{size(), size()};
    }
}

/// Twice as large in all directions.
inline Shape twice(const Shape& shape) {
    if (const auto* s = std::get_if<Sphere>(&shape)) return Sphere{2 * s->radius};
    if (const auto* s = std::get_if<Ellipsoid>(&shape)) return Ellipsoid{s->radii * 2.0};
    if (const auto* s = std::get_if<Capsule>(&shape)) return Capsule{2 * s->radius, 2 * s->half_height};
    if (const auto* s = std::get_if<Box>(&shape)) return Box{s->half_extents * 2.0};
    if (const auto* s = std::get_if<Cylinder>(&shape)) return Cylinder{2 * s->radius, 2 * s->half_height};
    const auto& cone = std::get<Cone>(shape);
    return Cone{2 * cone.radius, 2 * cone.height};
}

inline const char* shape_name(int kind) {
    const char* names[] = {"sphere", "ellipsoid", "capsule", "box", "cylinder", "cone"};
    return names[kind];
}

/// Makes `f(unit n)` as small as it can: looks at `count` directions and at `hints`, then walks downhill from the best
/// few with shrinking steps. An upper bound on the least value, and usually close to it.
template <typename Function>
Real least_over_directions(const Function& f, const std::vector<Point>& hints = {}, int count = 400) {
    struct Start {
        Point n;
        Real value;
    };
    std::vector<Start> starts;
    const auto look = [&](const Point& direction) {
        if (!(length(direction) > 0)) return;
        const Point n = unit(direction);
        starts.push_back({n, f(n)});
    };
    for (int i = 0; i < count; ++i) {
        const Real y = 1 - (2 * i + 1) / static_cast<Real>(count);
        const Real level = std::sqrt(1 - y * y);
        const Real angle = 2.39996322972865332L * i;
        look({level * std::cos(angle), y, level * std::sin(angle)});
    }
    for (const Point& hint : hints) {
        look(hint);
        look(-hint);
    }
    Real best = 1e300L;
    for (int round = 0; round < 3; ++round) {
        std::size_t from = 0;
        for (std::size_t i = 1; i < starts.size(); ++i) {
            if (starts[i].value < starts[from].value) from = i;
        }
        Start at = starts[from];
        starts[from].value = 1e300L;
        // Exact bits do not matter here; the number of looks does: it is bounded, whatever `f` is.
        Real step = 0.1L;
        for (int looks = 0; looks < 120 && step > 1e-11L; ++looks) {
            const Point side = unit(std::abs(at.n.x) < 0.7L ? cross(at.n, {1, 0, 0}) : cross(at.n, {0, 1, 0}));
            const Point other = cross(at.n, side);
            Start next = at;
            for (int k = 0; k < 8; ++k) {
                const Real angle = 0.78539816339744830962L * k + static_cast<Real>(looks);
                const Point n = unit(at.n + (side * std::cos(angle) + other * std::sin(angle)) * step);
                const Real value = f(n);
                if (value < next.value) next = {n, value};
            }
            if (!(next.value < at.value)) step *= 0.5L;
            at = next;
        }
        best = std::min(best, at.value);
    }
    return best;
}

}  // namespace surefoot::tests
