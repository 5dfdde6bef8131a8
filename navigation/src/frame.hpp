// The frame in which a navigation mesh lives: floats about an origin of its own, with +Y up, as Recast wants it.
#pragma once

#include <cmath>

#include <surefoot/bounds.hpp>
#include <surefoot/math.hpp>

namespace surefoot::navigation {

inline double dot(const dvec3& a, const dvec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline dvec3 cross(const dvec3& a, const dvec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const dvec3& a) {
    return std::sqrt(dot(a, a));
}

struct Frame {
    dvec3 origin{0, 0, 0};  ///< in the world
    dvec3 x{1, 0, 0};       ///< the mesh's own axes, unit, in the world
    dvec3 y{0, 1, 0};
    dvec3 z{0, 0, 1};

    /// With `up` as its y. With +Y the axes are the world's own, to the last bit.
    [[nodiscard]] static Frame about(const dvec3& origin, const dvec3& up) {
        Frame frame;
        frame.origin = origin;
        if (up.x == 0 && up.z == 0 && up.y > 0) return frame;
        frame.y = up / length(up);
        const dvec3 aside = std::abs(frame.y.z) < 0.9 ? dvec3{0, 0, 1} : dvec3{1, 0, 0};
        frame.x = cross(frame.y, aside);
        frame.x /= length(frame.x);
        frame.z = cross(frame.x, frame.y);
        return frame;
    }

    [[nodiscard]] dvec3 turned_in(const dvec3& v) const { return {dot(v, x), dot(v, y), dot(v, z)}; }
    [[nodiscard]] dvec3 turned_out(const dvec3& v) const { return v.x * x + v.y * y + v.z * z; }
    [[nodiscard]] vec3 in(const dvec3& place) const { return vec3(turned_in(place - origin)); }
    [[nodiscard]] dvec3 out(const dvec3& place) const { return origin + turned_out(place); }
    [[nodiscard]] dvec3 out(const float* place) const { return out(dvec3{place[0], place[1], place[2]}); }
};

/// The smallest box of the world around a box of the frame.
[[nodiscard]] inline Bounds bounds_out(const Frame& frame, const dvec3& min, const dvec3& max) {
    const dvec3 middle = frame.out((min + max) * 0.5);
    const dvec3 half = (max - min) * 0.5;
    dvec3 reach;
    for (int axis = 0; axis < 3; ++axis)
        reach[axis] =
            std::abs(frame.x[axis]) * half.x + std::abs(frame.y[axis]) * half.y + std::abs(frame.z[axis]) * half.z;
    return {middle - reach, middle + reach};
}

}  // namespace surefoot::navigation
