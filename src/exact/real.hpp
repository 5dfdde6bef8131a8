// Real numbers to 512 binary digits, or to 2560, with division and square roots: for decisions about roots, where exact
// arithmetic would need algebraic numbers. Sums, differences and products of a few game numbers fit and are exact.
#pragma once

#include <cmath>

#include "exact/number.hpp"

namespace surefoot::internal {

template <int Limbs>
class RealOf {
public:
    RealOf() noexcept = default;
    RealOf(double value) noexcept : number_(value) {}  // NOLINT: as freely as a double

    [[nodiscard]] int sign() const noexcept { return number_.sign(); }

    friend RealOf operator-(const RealOf& a) noexcept { return RealOf(-a.number_); }
    friend RealOf operator+(const RealOf& a, const RealOf& b) noexcept { return sum(a, b.number_); }
    friend RealOf operator-(const RealOf& a, const RealOf& b) noexcept { return sum(a, -b.number_); }
    friend RealOf operator*(const RealOf& a, const RealOf& b) noexcept { return RealOf(a.number_ * b.number_); }

    /// Requires: b is not zero. Newton's iteration for 1 / b doubles the digits of a double each time, and is given no
    /// more of them than it can use.
    friend RealOf operator/(const RealOf& a, const RealOf& b) noexcept {
        const Number one_ish = b.number_.shifted(-b.number_.top());
        const Number two(2.0);
        Number inverse(1.0 / one_ish.leading());
        for (int digits = first_digits;; digits = next_digits(digits)) {
            const Number rest = two - one_ish.truncated(digits) * inverse;
            inverse = (inverse * rest.truncated(digits)).truncated(digits);
            if (digits == last_digits) break;
        }
        return RealOf(a.number_ * inverse.shifted(-b.number_.top()));
    }

    /// 0 for what is not positive.
    friend RealOf square_root(const RealOf& a) noexcept {
        if (a.sign() <= 0) return {};
        // An even number of limbs is taken out, so that the root is of whole limbs too.
        const int half = a.number_.top() / 2 + (a.number_.top() > 0 ? a.number_.top() % 2 : 0);
        const Number scaled = a.number_.shifted(-2 * half);
        double start = scaled.leading();
        for (int top = scaled.top(); top < 0; ++top) start *= 0x1p-32;
        const Number three(3.0);
        const Number one_half(0.5);
        Number inverse(1.0 / std::sqrt(start));
        for (int digits = first_digits;; digits = next_digits(digits)) {
            const Number square = (inverse * inverse).truncated(digits);
            const Number rest = three - (scaled.truncated(digits) * square).truncated(digits);
            inverse = ((inverse * rest.truncated(digits)).truncated(digits) * one_half).truncated(digits);
            if (digits == last_digits) break;
        }
        return RealOf((scaled * inverse).shifted(half));
    }

    friend bool operator<(const RealOf& a, const RealOf& b) noexcept { return (a - b).sign() < 0; }
    friend bool operator>(const RealOf& a, const RealOf& b) noexcept { return b < a; }

private:
    using Number = ExactNumber<2 * Limbs + 8>;
    static constexpr int limbs = Limbs;
    static constexpr int first_digits = 4;         // limbs, as are the next
    static constexpr int last_digits = Limbs + 2;  // two to spare
    static constexpr int next_digits(int digits) noexcept {
        return 2 * digits - 1 < last_digits ? 2 * digits - 1 : last_digits;
    }

    explicit RealOf(const Number& number) noexcept : number_(number.truncated(limbs)) {}

    // What lies wholly below the digits of the other is dropped.
    static RealOf sum(const RealOf& a, const Number& b) noexcept {
        if (a.sign() != 0 && b.sign() != 0) {
            if (a.number_.top() - b.top() > limbs + 2) return a;
            if (b.top() - a.number_.top() > limbs + 2) return RealOf(b);
        }
        return RealOf(a.number_ + b);
    }

    Number number_;
};

using Real = RealOf<16>;
/// Tells an ulp of zero (2^-1074) from nothing, next to 1e9.
using WideReal = RealOf<80>;

template <int Limbs>
int sign_of(const RealOf<Limbs>& a) noexcept {
    return a.sign();
}
inline int sign_of(double a) noexcept {
    return a > 0 ? 1 : (a < 0 ? -1 : 0);
}
inline double square_root(double a) noexcept {
    return a > 0 ? std::sqrt(a) : 0;
}

}  // namespace surefoot::internal
