// Turns the fuzzer's bytes into the arguments of queries.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>

#include <surefoot/surefoot.hpp>

#include "asking.hpp"

namespace fuzz {

// Not assert: it must hold in every build.
inline void require(bool condition, const char* promise) {
    if (condition) return;
    std::fprintf(stderr, "broken promise: %s\n", promise);
    Asking::save(promise);
    std::abort();
}

class Bytes {
public:
    explicit Bytes(std::span<const std::uint8_t> bytes) : rest_(bytes) {}

    bool empty() const { return rest_.empty(); }

    // Zeros once the bytes have run out.
    template <typename T>
    T take() {
        T value{};
        const std::size_t size = sizeof(T) < rest_.size() ? sizeof(T) : rest_.size();
        if (size != 0) std::memcpy(&value, rest_.data(), size);
        rest_ = rest_.subspan(size);
        return value;
    }

    // Raw bits reach NaN, infinity and denormals; small eighths reach exact touches, which raw bits never find.
    double number(bool raw) { return raw ? take<double>() : take<std::int8_t>() * 0.125; }

    surefoot::dvec3 vector(bool raw) {
        const double x = number(raw);
        const double y = number(raw);
        return {x, y, number(raw)};
    }

    surefoot::Volume volume(bool raw) {
        const auto kind = take<std::uint8_t>();
        const surefoot::dvec3 size = vector(raw);
        surefoot::dquat turned(1, 0, 0, 0);
        if ((kind & 0x80) != 0) {
            const surefoot::dvec3 axis = vector(raw);
            turned = surefoot::dquat(number(raw), axis.x, axis.y, axis.z);
        }
        switch (kind % 6) {
            case 0:
                return {surefoot::Sphere{.radius = size.x}, turned};
            case 1:
                return {surefoot::Ellipsoid{.radii = size}, turned};
            case 2:
                return {surefoot::Capsule{.radius = size.x, .half_height = size.y}, turned};
            case 3:
                return {surefoot::Box{.half_extents = size}, turned};
            case 4:
                return {surefoot::Cylinder{.radius = size.x, .half_height = size.y}, turned};
            default:
                return {surefoot::Cone{.radius = size.x, .height = size.y}, turned};
        }
    }

private:
    std::span<const std::uint8_t> rest_;
};

inline bool is_finite(const surefoot::dvec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline bool is_within_limits(const surefoot::dvec3& v) {
    return is_finite(v) && std::abs(v.x) <= 1e9 && std::abs(v.y) <= 1e9 && std::abs(v.z) <= 1e9;
}

inline bool is_within_limits(const surefoot::Motion& motion) {
    return is_within_limits(motion.from) && is_within_limits(motion.to);
}

inline bool is_within_limits(const surefoot::Triangle& triangle) {
    return is_within_limits(triangle.a) && is_within_limits(triangle.b) && is_within_limits(triangle.c);
}

inline bool is_about_unit(const surefoot::dvec3& v) {
    return std::abs(v.x * v.x + v.y * v.y + v.z * v.z - 1) < 1e-9;
}

// What every hit keeps to, whatever was asked.
inline void require_sound(const surefoot::Hit& hit, bool valid_input) {
    require(hit.t >= 0 && hit.t <= 1, "t is within [0, 1]");
    require(is_finite(hit.point) && is_finite(hit.normal), "no NaN and no infinity in an answer");
    if (!valid_input) {
        require(hit.status == surefoot::HitStatus::invalid, "data outside the limits says invalid");
        require(hit.t == 0, "what is invalid blocks at t = 0");
        require(hit.normal == surefoot::dvec3(0, 0, 0), "what is invalid has no normal");
        return;
    }
    require(hit.status == surefoot::HitStatus::ok, "data within the limits are answered");
    require(is_about_unit(hit.normal), "a normal has unit length");
    require(!hit.started_inside || hit.t == 0, "a start inside is at t = 0");
}

}  // namespace fuzz
