// Products whose rounding error is kept, without fused multiply-add, so that a difference of products keeps its digits.
// Dekker, "A floating-point technique for extending the available precision" (1971); Knuth's two-sum.
#pragma once

#include <bit>
#include <cstdint>

#include "vec.hpp"

namespace surefoot::internal {

struct Sum {
    double high = 0;
    double low = 0;
};

/// high + low == a + b exactly (short of overflow).
constexpr Sum two_sum(double a, double b) noexcept {
    const double high = a + b;
    const double b_part = high - a;
    return {high, (a - (high - b_part)) + (b - b_part)};
}

/// high + low == a * b exactly (short of overflow and underflow).
constexpr Sum two_product(double a, double b) noexcept {
    constexpr double splitter = 134217729.0;  // 2^27 + 1
    const double high = a * b;
    const double a_shift = splitter * a;
    const double a_high = a_shift - (a_shift - a);
    const double a_low = a - a_high;
    const double b_shift = splitter * b;
    const double b_high = b_shift - (b_shift - b);
    const double b_low = b - b_high;
    return {high, ((a_high * b_high - high) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

/// a * b - c * d, to nearly the last digit however much of it cancels.
constexpr double difference_of_products(double a, double b, double c, double d) noexcept {
    const Sum ab = two_product(a, b);
    const Sum cd = two_product(c, d);
    const Sum high = two_sum(ab.high, -cd.high);
    return high.high + (high.low + (ab.low - cd.low));
}

/// A cross product that keeps its direction for nearly parallel vectors (slivers, grazing motions).
constexpr Vec accurate_cross(const Vec& a, const Vec& b) noexcept {
    return {difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
            difference_of_products(a.x, b.y, a.y, b.x)};
}

/// The power of two at or below |s|; 0 for zero and for numbers below 2^-1022.
inline double power_of_two_of(double s) noexcept {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(s) & 0x7ff0000000000000ULL);
}

/// `a` brought to a largest component in [1, 2) by a power of two, which changes no digit; zero for a vector whose
/// components are all below 2^-1000, which is zero next to any radius that is allowed.
inline Vec scaled_to_one(const Vec& a) noexcept {
    const double scale = power_of_two_of(largest(a));
    return scale < 0x1p-1000 ? Vec{} : a / scale;
}

/// The same direction, far enough from the end of the doubles' range not to be lost where it is scaled to one.
inline Vec enlarged(const Vec& a) noexcept {
    return largest(a) < 0x1p-900 ? a * 0x1p1000 : a;
}

/// Unit length, or zero for zero and for what is less than 2^-1000.
inline Vec unit(const Vec& a) noexcept {
    const Vec scaled = scaled_to_one(a);
    const double size = length(scaled);
    return size > 0 ? scaled / size : Vec{};
}

}  // namespace surefoot::internal
