/// Random numbers and what the families have in common. The generator is our own (xoshiro256++, Blackman and Vigna), so
/// that a seed means the same queries on every machine.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>

#include "../query.hpp"

namespace judge {

inline Vec operator+(const Vec& a, const Vec& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline Vec operator-(const Vec& a, const Vec& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline Vec operator-(const Vec& a) {
    return {-a.x, -a.y, -a.z};
}
inline Vec operator*(const Vec& a, double k) {
    return {a.x * k, a.y * k, a.z * k};
}
inline double dot(const Vec& a, const Vec& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline Vec cross(const Vec& a, const Vec& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec& a) {
    return std::sqrt(dot(a, a));
}

class Draw {
public:
    explicit Draw(std::uint64_t seed) {
        for (std::uint64_t& word : state_) {  // splitmix64
            std::uint64_t z = (seed += 0x9e3779b97f4a7c15);
            z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
            z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
            word = z ^ (z >> 31);
        }
    }
    std::uint64_t next() {
        const std::uint64_t result = rotated(state_[0] + state_[3], 23) + state_[0];
        const std::uint64_t t = state_[1] << 17;
        state_[2] ^= state_[0];
        state_[3] ^= state_[1];
        state_[1] ^= state_[2];
        state_[0] ^= state_[3];
        state_[2] ^= t;
        state_[3] = rotated(state_[3], 45);
        return result;
    }

    int pick(int count) { return static_cast<int>(next() % static_cast<std::uint64_t>(count)); }
    bool coin() { return (next() >> 40 & 1) != 0; }
    bool one_in(int count) { return pick(count) == 0; }
    double pick(std::initializer_list<double> values) { return values.begin()[pick(static_cast<int>(values.size()))]; }
    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
    }
    /// Evenly spread over the orders of magnitude between low and high.
    double magnitude(double low, double high) {
        const int first = std::ilogb(low), last = std::ilogb(high);
        const double mantissa = uniform(1, 2);
        const double value = std::ldexp(mantissa, first + pick(last - first + 1));
        return value < low ? low : (value > high ? high : value);
    }
    int integer(int low, int high) { return low + pick(high - low + 1); }
    Vec box(double half) { return {uniform(-half, half), uniform(-half, half), uniform(-half, half)}; }
    Vec direction() {
        for (;;) {
            const Vec v = box(1);
            const double size = dot(v, v);
            if (size > 0.01 && size <= 1) return v * (1 / std::sqrt(size));
        }
    }
    /// A direction and a length of any magnitude between low and high. (One call a statement: the order in which C++
    /// evaluates the two sides of a product is the compiler's choice.)
    Vec arrow(double low, double high) {
        const Vec way = direction();
        const double size = magnitude(low, high);
        return {way.x * size, way.y * size, way.z * size};
    }
    /// Moves one number by `count` ulps.
    static double ulps(double value, int count) {
        for (; count > 0; --count) value = std::nextafter(value, INFINITY);
        for (; count < 0; ++count) value = std::nextafter(value, -INFINITY);
        return value;
    }
    double& any_part(Vec& v) {
        const int i = pick(3);
        return i == 0 ? v.x : (i == 1 ? v.y : v.z);
    }

private:
    static std::uint64_t rotated(std::uint64_t x, int by) { return (x << by) | (x >> (64 - by)); }
    std::uint64_t state_[4];
};

/// v turned by the orientation of the query, in doubles.
[[nodiscard]] Vec turned(const Query& query, const Vec& v);

/// Sizes drawn evenly over the magnitudes between low and high.
void draw_size(Draw& draw, Query& query, double low, double high);
/// Upright, a quarter turn, hand-written and not of unit length, or any.
void draw_orientation(Draw& draw, Query& query);
/// A triangle of about `low` to `high` within `spread` of `origin`.
void draw_triangle_near(Draw& draw, Query& query, const Vec& origin, double spread, double low, double high);
/// A triangle of about this size around `centre`, with corners rounded to floats as those of a mesh are (mostly).
void draw_triangle(Draw& draw, Query& query, const Vec& centre, double size);
/// A motion of about `length` that passes the triangle at about the distance of the shape's surface: as often a hit as
/// a miss.
void aim(Draw& draw, Query& query, double length);
/// Rounds to what a float holds: a position, or the triangle of a query.
void to_floats(Vec& v);
void to_floats(Query& query);
/// The largest dimension of the shape.
[[nodiscard]] double reach_of(const Query& query);

}  // namespace judge
