/// Exact numbers m 2^e with an integer m of any size (GMP). Every double is one; sums and products of them are, too.
/// They need no common denominators, which makes them far faster than general rationals.
#pragma once

#include <cmath>
#include <cstdint>
#include <gmpxx.h>
#include <utility>

#include "vec.hpp"

namespace judge {

class Dyadic {
public:
    Dyadic() = default;
    /// Requires: `value` is finite.
    explicit Dyadic(double value) {
        if (value == 0) return;
        int exponent = 0;
        const double mantissa = std::frexp(value, &exponent);
        auto whole = static_cast<std::int64_t>(std::ldexp(mantissa, 53));
        const int zeros = __builtin_ctzll(static_cast<unsigned long long>(whole));
        m_ = static_cast<long>(whole >> zeros);
        e_ = exponent - 53 + zeros;
    }
    /// m 2^e.
    Dyadic(mpz_class m, long e) : m_(std::move(m)), e_(e) {}
    /// Exactly the sum of the parts, which are finite: the way in for wider floats.
    static Dyadic sum(const double* parts, int count) {
        Dyadic total;
        for (int i = 0; i < count; ++i) total = total + Dyadic(parts[i]);
        return total;
    }

    friend Dyadic operator+(const Dyadic& a, const Dyadic& b) {
        if (sgn(a.m_) == 0) return b;
        if (sgn(b.m_) == 0) return a;
        const bool a_is_finer = a.e_ <= b.e_;
        const Dyadic& fine = a_is_finer ? a : b;
        const Dyadic& coarse = a_is_finer ? b : a;
        Dyadic result;
        result.e_ = fine.e_;
        mpz_mul_2exp(result.m_.get_mpz_t(), coarse.m_.get_mpz_t(), static_cast<mp_bitcnt_t>(coarse.e_ - fine.e_));
        mpz_add(result.m_.get_mpz_t(), result.m_.get_mpz_t(), fine.m_.get_mpz_t());
        return result;
    }
    friend Dyadic operator-(Dyadic a) {
        mpz_neg(a.m_.get_mpz_t(), a.m_.get_mpz_t());
        return a;
    }
    friend Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + (-b); }
    friend Dyadic operator*(const Dyadic& a, const Dyadic& b) {
        Dyadic result;
        mpz_mul(result.m_.get_mpz_t(), a.m_.get_mpz_t(), b.m_.get_mpz_t());
        result.e_ = a.e_ + b.e_;
        return result;
    }
    friend Dyadic abs(Dyadic a) {
        mpz_abs(a.m_.get_mpz_t(), a.m_.get_mpz_t());
        return a;
    }
    friend Dyadic square(const Dyadic& a) { return a * a; }
    friend int sign_of(const Dyadic& a) { return sgn(a.m_); }
    friend double to_double(const Dyadic& a) {
        long exponent = 0;
        const double mantissa = mpz_get_d_2exp(&exponent, a.m_.get_mpz_t());
        return std::ldexp(mantissa, static_cast<int>(exponent + a.e_));
    }
    [[nodiscard]] const mpz_class& mantissa() const { return m_; }
    [[nodiscard]] long exponent() const { return e_; }

private:
    mpz_class m_;
    long e_ = 0;
};

}  // namespace judge
