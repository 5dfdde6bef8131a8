// Three doubles and what is done with them. Every answer is decided with these functions and not with GLM's: an inline
// function of a header may be replaced at link time by the caller's copy of it, compiled with other flags.
#pragma once

#include <cmath>

#include <surefoot/math.hpp>

namespace surefoot::internal {

struct Vec {
    double x = 0;
    double y = 0;
    double z = 0;

    friend constexpr bool operator==(const Vec&, const Vec&) = default;
};

constexpr Vec to_vec(const dvec3& v) noexcept {
    return {v.x, v.y, v.z};
}
constexpr dvec3 to_dvec3(const Vec& v) noexcept {
    return dvec3(v.x, v.y, v.z);
}

constexpr Vec operator+(const Vec& a, const Vec& b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
constexpr Vec operator-(const Vec& a, const Vec& b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
constexpr Vec operator-(const Vec& a) noexcept {
    return {-a.x, -a.y, -a.z};
}
constexpr Vec operator*(const Vec& a, double s) noexcept {
    return {a.x * s, a.y * s, a.z * s};
}
constexpr Vec operator*(double s, const Vec& a) noexcept {
    return a * s;
}
constexpr Vec operator/(const Vec& a, double s) noexcept {
    return {a.x / s, a.y / s, a.z / s};
}

constexpr double dot(const Vec& a, const Vec& b) noexcept {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
constexpr Vec cross(const Vec& a, const Vec& b) noexcept {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
constexpr Vec multiply_each(const Vec& a, const Vec& b) noexcept {
    return {a.x * b.x, a.y * b.y, a.z * b.z};
}
constexpr Vec divide_each(const Vec& a, const Vec& b) noexcept {
    return {a.x / b.x, a.y / b.y, a.z / b.z};
}

constexpr double absolute(double s) noexcept {
    return s < 0 ? -s : s;
}
constexpr double larger(double a, double b) noexcept {
    return a < b ? b : a;
}
constexpr double smaller(double a, double b) noexcept {
    return b < a ? b : a;
}

/// |x| + |y| + |z|: at least the length, at most sqrt(3) of it, and without a root.
constexpr double norm1(const Vec& a) noexcept {
    return absolute(a.x) + absolute(a.y) + absolute(a.z);
}
constexpr double largest(const Vec& a) noexcept {
    return larger(absolute(a.x), larger(absolute(a.y), absolute(a.z)));
}

inline double length(const Vec& a) noexcept {
    return std::sqrt(dot(a, a));
}

/// Is `a` ordered before `b`, by x, then y, then z?
constexpr bool lexicographically_less(const Vec& a, const Vec& b) noexcept {
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z < b.z;
}

}  // namespace surefoot::internal
