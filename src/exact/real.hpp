// Real numbers to 512 binary digits, with division and square roots: for decisions about roots, where exact arithmetic
// would need algebraic numbers. Sums, differences and products of a few game numbers fit and are exact.
#pragma once

#include <cmath>

#include "exact/number.hpp"

namespace surefoot::internal {

class Real {
public:
    Real() noexcept = default;
    Real(double value) noexcept : number_(value) {}  // NOLINT: as freely as a double

    [[nodiscard]] int sign() const noexcept { return number_.sign(); }

    friend Real operator-(const Real& a) noexcept { return Real(-a.number_); }
    friend Real operator+(const Real& a, const Real& b) noexcept { return sum(a, b.number_); }
    friend Real operator-(const Real& a, const Real& b) noexcept { return sum(a, -b.number_); }
    friend Real operator*(const Real& a, const Real& b) noexcept { return Real(a.number_ * b.number_); }

    /// Requires: b is not zero. Newton's iteration for 1 / b doubles the digits of a double each time, and is given no
    /// more of them than it can use.
    friend Real operator/(const Real& a, const Real& b) noexcept {
        const Number one_ish = b.number_.shifted(-b.number_.top());
        const Number two(2.0);
        Number inverse(1.0 / one_ish.leading());
        for (const int digits : steps) {
            const Number rest = two - one_ish.truncated(digits) * inverse;
            inverse = (inverse * rest.truncated(digits)).truncated(digits);
        }
        return Real(a.number_ * inverse.shifted(-b.number_.top()));
    }

    /// 0 for what is not positive.
    friend Real square_root(const Real& a) noexcept {
        if (a.sign() <= 0) return {};
        // An even number of limbs is taken out, so that the root is of whole limbs too.
        const int half = a.number_.top() / 2 + (a.number_.top() > 0 ? a.number_.top() % 2 : 0);
        const Number scaled = a.number_.shifted(-2 * half);
        double start = scaled.leading();
        for (int top = scaled.top(); top < 0; ++top) start *= 0x1p-32;
        const Number three(3.0);
        const Number one_half(0.5);
        Number inverse(1.0 / std::sqrt(start));
        for (const int digits : steps) {
            const Number square = (inverse * inverse).truncated(digits);
            const Number rest = three - (scaled.truncated(digits) * square).truncated(digits);
            inverse = ((inverse * rest.truncated(digits)).truncated(digits) * one_half).truncated(digits);
        }
        return Real((scaled * inverse).shifted(half));
    }

    friend bool operator<(const Real& a, const Real& b) noexcept { return (a - b).sign() < 0; }
    friend bool operator>(const Real& a, const Real& b) noexcept { return b < a; }

private:
    using Number = ExactNumber<40>;
    static constexpr int limbs = 16;
    static constexpr int steps[] = {4, 7, 13, 18};  // limbs, two of them to spare

    explicit Real(const Number& number) noexcept : number_(number.truncated(limbs)) {}

    // What lies wholly below the digits of the other is dropped.
    static Real sum(const Real& a, const Number& b) noexcept {
        if (a.sign() != 0 && b.sign() != 0) {
            if (a.number_.top() - b.top() > limbs + 2) return a;
            if (b.top() - a.number_.top() > limbs + 2) return Real(b);
        }
        return Real(a.number_ + b);
    }

    Number number_;
};

inline int sign_of(const Real& a) noexcept {
    return a.sign();
}
inline int sign_of(double a) noexcept {
    return a > 0 ? 1 : (a < 0 ? -1 : 0);
}
inline double square_root(double a) noexcept {
    return a > 0 ? std::sqrt(a) : 0;
}

}  // namespace surefoot::internal
