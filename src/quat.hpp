// Quaternions, as far as poses need them: products, and the way from one to another.
#pragma once

#include <cmath>

#include <surefoot/math.hpp>

#include "exact/products.hpp"
#include "vec.hpp"

namespace surefoot::internal {

struct Quat {
    double w = 1;
    Vec v;  ///< x, y, z
};

/// Brought to a largest component in [1, 2) by a power of two: the same rotation to the last digit.
inline Quat scaled_to_one(const dquat& q) noexcept {
    const double scale = power_of_two_of(larger(largest({q.x, q.y, q.z}), absolute(q.w)));
    return scale > 0 ? Quat{q.w / scale, Vec{q.x, q.y, q.z} / scale} : Quat{};
}
inline dquat to_dquat(const Quat& q) noexcept {
    return dquat(q.w, q.v.x, q.v.y, q.v.z);
}
constexpr double dot(const Quat& a, const Quat& b) noexcept {
    return a.w * b.w + dot(a.v, b.v);
}
constexpr Quat operator-(const Quat& a, const Quat& b) noexcept {
    return {a.w - b.w, a.v - b.v};
}
constexpr Quat operator*(const Quat& a, double s) noexcept {
    return {a.w * s, a.v * s};
}
constexpr Quat conjugate(const Quat& q) noexcept {
    return {q.w, -q.v};
}
constexpr Quat product(const Quat& a, const Quat& b) noexcept {
    return {a.w * b.w - dot(a.v, b.v), b.v * a.w + a.v * b.w + cross(a.v, b.v)};
}
inline Quat unit(const Quat& q) noexcept {
    return q * (1 / std::sqrt(dot(q, q)));
}

/// Straight from a to b, each of them exact at its end.
constexpr Vec mix(const Vec& a, const Vec& b, double at) noexcept {
    if (at <= 0 || a == b) return a;
    return at >= 1 ? b : a * (1 - at) + b * at;
}
constexpr Quat mix(const Quat& a, const Quat& b, double at) noexcept {
    if (at <= 0) return a;
    return at >= 1 ? b : Quat{a.w * (1 - at) + b.w * at, mix(a.v, b.v, at)};
}

/// The turn of a body during a tick, by the shorter way. The mix of two unit quaternions turns about one axis.
class Turn {
public:
    Turn(const dquat& start, const dquat& end) noexcept : Turn(scaled_to_one(start), scaled_to_one(end)) {}

    [[nodiscard]] bool turns() const noexcept { return turns_; }
    /// Not of unit length, but at least sqrt(1/2) long; where nothing turns, the start, scaled by a power of two.
    [[nodiscard]] Quat at(double time) const noexcept { return turns_ ? mix(start_, end_, time) : start_; }

private:
    Turn(const Quat& start, const Quat& end) noexcept : start_(start), end_(end) {
        turns_ = !(start.w == end.w && start.v == end.v) && !(start.w == -end.w && start.v == -end.v);
        if (!turns_) return;
        start_ = unit(start);
        end_ = unit(end);
        if (dot(start_, end_) < 0) end_ = end_ * -1;
        turns_ = !(start_.w == end_.w && start_.v == end_.v);
    }

    Quat start_;
    Quat end_;
    bool turns_ = false;
};

}  // namespace surefoot::internal
