/// Three numbers of any kind (interval, dyadic or float) and what is computed of them.
#pragma once

#include <cmath>
#include <type_traits>

#include "query.hpp"

namespace judge {

/// The answer of a number that may not know its own sign.
inline constexpr int unsure = 2;

template <class N>
struct V3 {
    N x, y, z;
};

template <class N>
V3<N> operator+(const V3<N>& a, const V3<N>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class N>
V3<N> operator-(const V3<N>& a, const V3<N>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class N>
V3<N> operator-(const V3<N>& a) {
    return {-a.x, -a.y, -a.z};
}
template <class N>
V3<N> scaled(const V3<N>& a, const N& by) {
    return {a.x * by, a.y * by, a.z * by};
}
template <class N>
N dot(const V3<N>& a, const V3<N>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class N>
V3<N> cross(const V3<N>& a, const V3<N>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class N>
V3<N> lift(const Vec& v) {
    return {N(v.x), N(v.y), N(v.z)};
}

/// The matrix of v -> q* v q, which is |q|^2 times the turn from the world into the shape's frame: rows of `m`.
template <class N>
struct Turn {
    V3<N> row[3];
    N s;  ///< |q|^2
    bool none = false;

    explicit Turn(const Query& query) : s(1.0) {
        // Floats are spared overflow by a power of two, which changes nothing; exact numbers need no such care.
        const double by = std::is_floating_point_v<N> ? power_for(query) : 1;
        const N w(query.qw * by), x(query.qx * by), y(query.qy * by), z(query.qz * by);
        const N two(2.0);
        s = w * w + x * x + y * y + z * z;
        none = query.qw == 1 && query.qx == 0 && query.qy == 0 && query.qz == 0;
        row[0] = {w * w + x * x - y * y - z * z, two * (x * y + w * z), two * (x * z - w * y)};
        row[1] = {two * (x * y - w * z), w * w - x * x + y * y - z * z, two * (y * z + w * x)};
        row[2] = {two * (x * z + w * y), two * (y * z - w * x), w * w - x * x - y * y + z * z};
    }
    [[nodiscard]] V3<N> into_frame(const V3<N>& v) const {
        if (none) return v;
        return {dot(row[0], v), dot(row[1], v), dot(row[2], v)};
    }
    [[nodiscard]] V3<N> into_world(const V3<N>& v) const {
        if (none) return v;
        return scaled(row[0], v.x) + scaled(row[1], v.y) + scaled(row[2], v.z);
    }

private:
    static double power_for(const Query& query) {
        const double size = std::fmax(std::fmax(std::fabs(query.qw), std::fabs(query.qx)),
                                      std::fmax(std::fabs(query.qy), std::fabs(query.qz)));
        const int exponent = std::ilogb(size);
        return exponent > 64 || exponent < -64 ? std::ldexp(1.0, -exponent) : 1;
    }
};

}  // namespace judge
