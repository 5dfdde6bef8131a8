/// The floats that propose: double, a quadruple, and GMP's floats of 2560 bits. Proposals need not be right, so nothing
/// here is rigorous; what they propose is checked in intervals and exact numbers.
#pragma once

#include <cmath>
#include <gmpxx.h>

#include "dyadic.hpp"

namespace judge {

#if defined(__SIZEOF_FLOAT128__)
__extension__ using Quad = __float128;
#else
using Quad = long double;
#endif

inline double to_double(double a) {
    return a;
}
inline double root_of(double a) {
    return a > 0 ? std::sqrt(a) : 0;
}

inline double to_double(long double a) {
    return static_cast<double>(a);
}
inline long double root_of(long double a) {
    return a > 0 ? std::sqrt(a) : 0;
}

#if defined(__SIZEOF_FLOAT128__)
inline double to_double(Quad a) {
    return static_cast<double>(a);
}
inline Quad root_of(Quad a) {
    if (!(a > 0)) return 0;
    const double guess = std::sqrt(static_cast<double>(a));
    if (!(guess > 0)) return 0;
    Quad r = static_cast<Quad>(guess);
    for (int i = 0; i < 2; ++i) r = (r + a / r) / 2;
    return r;
}
#endif

/// A float of 2560 bits that behaves like a built-in one.
class Big {
public:
    static constexpr mp_bitcnt_t bits = 2560;
    Big() : v_(0, bits) {}
    Big(double a) : v_(a, bits) {}
    explicit Big(const mpf_class& v) : v_(v, bits) {}
    explicit Big(const Dyadic& a) : v_(0, bits) {
        mpf_set_z(v_.get_mpf_t(), a.mantissa().get_mpz_t());
        if (a.exponent() >= 0)
            mpf_mul_2exp(v_.get_mpf_t(), v_.get_mpf_t(), static_cast<mp_bitcnt_t>(a.exponent()));
        else
            mpf_div_2exp(v_.get_mpf_t(), v_.get_mpf_t(), static_cast<mp_bitcnt_t>(-a.exponent()));
    }
    friend Big operator+(const Big& a, const Big& b) { return Big(mpf_class(a.v_ + b.v_)); }
    friend Big operator-(const Big& a, const Big& b) { return Big(mpf_class(a.v_ - b.v_)); }
    friend Big operator*(const Big& a, const Big& b) { return Big(mpf_class(a.v_ * b.v_)); }
    /// By zero: zero, as GMP would end the program; a proposal from it is as good as none.
    friend Big operator/(const Big& a, const Big& b) { return sgn(b.v_) == 0 ? Big() : Big(mpf_class(a.v_ / b.v_)); }
    friend Big operator-(const Big& a) { return Big(mpf_class(-a.v_)); }
    friend bool operator<(const Big& a, const Big& b) { return a.v_ < b.v_; }
    friend bool operator>(const Big& a, const Big& b) { return a.v_ > b.v_; }
    friend bool operator<=(const Big& a, const Big& b) { return a.v_ <= b.v_; }
    friend bool operator>=(const Big& a, const Big& b) { return a.v_ >= b.v_; }
    friend bool operator==(const Big& a, const Big& b) { return a.v_ == b.v_; }
    friend double to_double(const Big& a) { return a.v_.get_d(); }
    friend Big root_of(const Big& a) {
        Big r;
        if (sgn(a.v_) > 0) mpf_sqrt(r.v_.get_mpf_t(), a.v_.get_mpf_t());
        return r;
    }

    /// Exactly.
    friend Dyadic exact(const Big& a) {
        mpf_class shifted(0, 2 * bits);
        long power = 0;
        mpf_get_d_2exp(&power, a.v_.get_mpf_t());
        // Two limbs more than the precision are kept, so that twice the digits leave no fraction.
        const long up = static_cast<long>(2 * bits) - power;
        if (up >= 0)
            mpf_mul_2exp(shifted.get_mpf_t(), a.v_.get_mpf_t(), static_cast<mp_bitcnt_t>(up));
        else
            mpf_div_2exp(shifted.get_mpf_t(), a.v_.get_mpf_t(), static_cast<mp_bitcnt_t>(-up));
        return Dyadic(mpz_class(shifted), -up);
    }

private:
    mpf_class v_;
};

template <class F>
F magnitude(const F& a) {
    return a < F(0) ? -a : a;
}

template <class F>
F length(const V3<F>& v) {
    return root_of(dot(v, v));
}

/// A float as an exact number; of a wider one, the first 159 bits.
template <class F>
Dyadic exact(F a) {
    double parts[3];
    for (double& part : parts) {
        part = to_double(a);
        a = a - F(part);
    }
    return Dyadic::sum(parts, 3);
}

template <class F>
V3<Dyadic> exact(const V3<F>& v) {
    return {exact(v.x), exact(v.y), exact(v.z)};
}

/// The question in the shape's own frame in floats, true to scale.
template <class F>
struct Local {
    Kind kind;
    V3<F> w[3];
    V3<F> d;
    V3<F> size;

    explicit Local(const Query& query) : kind(query.kind), size(lift<F>(query.size)) {
        const Turn<F> turn(query);
        const F one_over = F(1.0) / turn.s;
        const V3<F> from = lift<F>(query.from);
        const auto carry = [&](const V3<F>& v) { return turn.none ? v : scaled(turn.into_frame(v), one_over); };
        w[0] = carry(from - lift<F>(query.a));
        w[1] = carry(from - lift<F>(query.b));
        w[2] = carry(from - lift<F>(query.c));
        d = carry(lift<F>(query.to) - from);
    }
};

}  // namespace judge
