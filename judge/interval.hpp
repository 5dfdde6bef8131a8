/// Rigorous intervals of doubles: the fast first look. Every result is widened outwards by more than its rounding
/// error, so a sign that an interval is sure of is the true sign; otherwise exact numbers decide.
#pragma once

#include <cmath>

#include "vec.hpp"

namespace judge {

class Interval {
public:
    Interval() = default;
    explicit Interval(double value) : low_(value), high_(value) {}
    Interval(double low, double high) : low_(low), high_(high) {}

    [[nodiscard]] double low() const { return low_; }
    [[nodiscard]] double high() const { return high_; }

    friend Interval operator+(const Interval& a, const Interval& b) {
        return {down(a.low_ + b.low_), up(a.high_ + b.high_)};
    }
    friend Interval operator-(const Interval& a, const Interval& b) {
        return {down(a.low_ - b.high_), up(a.high_ - b.low_)};
    }
    friend Interval operator-(const Interval& a) { return {-a.high_, -a.low_}; }
    friend Interval operator*(const Interval& a, const Interval& b) {
        const double p = a.low_ * b.low_, q = a.low_ * b.high_, r = a.high_ * b.low_, s = a.high_ * b.high_;
        // A NaN (infinity times zero) must spread to both ends, so that nothing is ever concluded from it.
        const double poison = (p + q + r + s) * 0;
        return {down(least(least(p, q), least(r, s))) + poison, up(most(most(p, q), most(r, s))) + poison};
    }
    friend Interval abs(const Interval& a) {
        if (a.low_ >= 0) return a;
        if (a.high_ <= 0) return -a;
        return {0, most(-a.low_, a.high_) + a.low_ * 0};
    }
    friend Interval square(const Interval& a) {
        const Interval b = abs(a);
        return {most(0, down(b.low_ * b.low_)), up(b.high_ * b.high_)};
    }
    friend int sign_of(const Interval& a) {
        if (a.low_ > 0 && a.high_ < unbounded) return 1;
        if (a.high_ < 0 && a.low_ > -unbounded) return -1;
        return a.low_ == 0 && a.high_ == 0 ? 0 : unsure;
    }
    friend double to_double(const Interval& a) { return a.low_ + 0.5 * (a.high_ - a.low_); }

private:
    static constexpr double unbounded = 1e300;
    // Half an ulp of x is at most |x| 2^-53; the smallest normal number covers what underflows.
    static double down(double x) { return x == 0 ? -0x1p-1022 : x - (std::fabs(x) * 0x1p-52 + 0x1p-1022); }
    static double up(double x) { return x == 0 ? 0x1p-1022 : x + (std::fabs(x) * 0x1p-52 + 0x1p-1022); }
    static double least(double a, double b) { return a < b ? a : b; }
    static double most(double a, double b) { return a > b ? a : b; }

    double low_ = 0, high_ = 0;
};

}  // namespace judge
