/// A few words about vectors that the rules and the bots use everywhere: level is x and z, up is +Y, as in the levels.
#pragma once

#include <cmath>

#include <surefoot/math.hpp>

namespace surefoot::game {

[[nodiscard]] inline dvec3 flat(const dvec3& v) {
    return {v.x, 0, v.z};
}
[[nodiscard]] inline double length(const dvec3& v) {
    return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
}
[[nodiscard]] inline double flat_length(const dvec3& v) {
    return std::sqrt(v.x * v.x + v.z * v.z);
}
/// Unit; zero stays zero.
[[nodiscard]] inline dvec3 unit(const dvec3& v) {
    const double size = length(v);
    return size > 1e-9 ? v / size : dvec3{0, 0, 0};
}
[[nodiscard]] inline double dot(const dvec3& a, const dvec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

}  // namespace surefoot::game
