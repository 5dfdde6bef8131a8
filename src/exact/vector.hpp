// Vectors of exact numbers.
#pragma once

#include "exact/number.hpp"
#include "vec.hpp"

namespace surefoot::internal {

template <typename Number>
struct ExactVec {
    Number x;
    Number y;
    Number z;
};

template <typename Number>
ExactVec<Number> to_exact(const Vec& v) noexcept {
    return {Number(v.x), Number(v.y), Number(v.z)};
}

template <typename Number>
ExactVec<Number> operator-(const ExactVec<Number>& a, const ExactVec<Number>& b) noexcept {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <typename Number>
ExactVec<Number> operator-(const ExactVec<Number>& a) noexcept {
    return {-a.x, -a.y, -a.z};
}

template <typename Number>
ExactVec<Number> operator+(const ExactVec<Number>& a, const ExactVec<Number>& b) noexcept {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <typename Number>
ExactVec<Number> operator*(const ExactVec<Number>& a, const Number& s) noexcept {
    return {a.x * s, a.y * s, a.z * s};
}

template <typename Number>
Number dot(const ExactVec<Number>& a, const ExactVec<Number>& b) noexcept {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <typename Number>
ExactVec<Number> cross(const ExactVec<Number>& a, const ExactVec<Number>& b) noexcept {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <typename Number>
bool is_zero(const ExactVec<Number>& a) noexcept {
    return a.x.sign() == 0 && a.y.sign() == 0 && a.z.sign() == 0;
}

}  // namespace surefoot::internal
