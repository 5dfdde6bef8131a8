// One sweep in exact numbers, in the shape's frame and scaled by |q|^2, which turns the rotation v -> q* v q / |q|^2
// into a polynomial. Lengths of the shape must be multiplied by `scale` to go with it.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include <surefoot/math.hpp>

#include "exact/vector.hpp"

namespace surefoot::internal {

template <typename Number>
struct ExactQuery {
    ExactVec<Number> corners[3];  ///< relative to `from`
    ExactVec<Number> along;
    Number scale{1.0};

    ExactQuery(const Motion& motion, const Triangle& triangle) noexcept {
        const auto from = to_exact<Number>(to_vec(motion.from));
        corners[0] = to_exact<Number>(to_vec(triangle.a)) - from;
        corners[1] = to_exact<Number>(to_vec(triangle.b)) - from;
        corners[2] = to_exact<Number>(to_vec(triangle.c)) - from;
        along = to_exact<Number>(to_vec(motion.to)) - from;
    }

    void turn_into_frame(const dquat& orientation) noexcept {
        if (orientation.x == 0 && orientation.y == 0 && orientation.z == 0) return;
        const Number x(orientation.x);
        const Number y(orientation.y);
        const Number z(orientation.z);
        const Number w(orientation.w);
        const Number two(2.0);
        const Number xx = x * x;
        const Number yy = y * y;
        const Number zz = z * z;
        const Number ww = w * w;
        const ExactVec<Number> x_axis{ww + xx - yy - zz, two * (x * y + w * z), two * (x * z - w * y)};
        const ExactVec<Number> y_axis{two * (x * y - w * z), ww - xx + yy - zz, two * (y * z + w * x)};
        const ExactVec<Number> z_axis{two * (x * z + w * y), two * (y * z - w * x), ww - xx - yy + zz};
        const auto turn = [&](ExactVec<Number>& v) { v = {dot(x_axis, v), dot(y_axis, v), dot(z_axis, v)}; };
        for (auto& corner : corners) turn(corner);
        turn(along);
        scale = ww + xx + yy + zz;
    }

    [[nodiscard]] ExactVec<Number> edge(int i) const noexcept { return corners[(i + 1) % 3] - corners[i]; }
    [[nodiscard]] ExactVec<Number> face_normal() const noexcept { return cross(edge(0), corners[2] - corners[0]); }
};

/// The binary digits that a set of doubles spans, from the lowest that is set in any to the highest.
class DigitSpan {
public:
    void include(double value) noexcept {
        const auto bits = std::bit_cast<std::uint64_t>(value) & 0x7fffffffffffffffULL;
        if (bits == 0) return;
        const auto biased = static_cast<int>(bits >> 52);
        const std::uint64_t mantissa = (bits & 0x000fffffffffffffULL) | (biased == 0 ? 0 : 0x0010000000000000ULL);
        const int power = biased == 0 ? 1 : biased;
        lowest_ = std::min(lowest_, power + std::countr_zero(mantissa));
        highest_ = std::max(highest_, power + 64 - std::countl_zero(mantissa));
    }
    void include(const dvec3& v) noexcept {
        include(v.x);
        include(v.y);
        include(v.z);
    }
    [[nodiscard]] int digits() const noexcept { return highest_ < lowest_ ? 0 : highest_ - lowest_ + 2; }

private:
    int lowest_ = 100000;
    int highest_ = -100000;
};

/// Room for the numbers of games (coordinates and quaternions of 60 digits or so), and room for nearly any doubles
/// within the limits (2^-1074 next to 1e9).
using GameNumber = ExactNumber<128>;
using AnyNumber = ExactNumber<640>;

}  // namespace surefoot::internal
