// Seeded queries whose every number is the same on any machine and under any flags: integers are drawn, and each is
// made a double by one exact step. A generator that added or multiplied doubles would itself change under -ffast-math,
// and the golden hashes could not tell its changes from the library's.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include <surefoot/surefoot.hpp>

namespace golden {

// Steele, Lea, Flood: Fast Splittable Pseudorandom Number Generators (2014), the finaliser known as splitmix64.
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31);
    }

    // Uniform enough: the bias of a remainder is below 2^-40 for every span used here.
    std::int64_t between(std::int64_t low, std::int64_t high) {
        return low + static_cast<std::int64_t>(bits() % static_cast<std::uint64_t>(high - low + 1));
    }

private:
    std::uint64_t state_;
};

// 2^exponent from its bits, since ldexp is another library's.
inline double power_of_two(int exponent) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(exponent + 1023) << 52);
}

// How the numbers of a query are drawn. Every coordinate is an integer of at most 53 bits times a power of two.
struct Family {
    std::int64_t span;         // triangles and motions lie within +-span grid steps of the origin
    int exponent;              // one grid step is 2^exponent metres
    std::int64_t offset;       // everything is moved by this many steps along x
    std::int64_t smallest;     // radii and half extents are drawn between these two, in steps
    std::int64_t largest;      //
    bool flat;                 // squeeze the triangle to a sliver, an edge or a point
    std::int64_t largest_arm;  // the triangle's extent in steps
};

inline constexpr std::array<Family, 7> families{{
    {32, -3, 0, 1, 12, false, 24},                                                 // a coarse grid: exact touches
    {1ll << 50, -48, 0, 1ll << 45, 1ll << 50, false, 1ll << 51},                   // random: all bits of a double
    {1ll << 26, -24, 10'000'000ll << 24, 1ll << 20, 1ll << 25, false, 1ll << 26},  // 1e7 m from the origin
    {48, -3, 0, 1, 12, true, 24},                                                  // without area, on the grid
    {1ll << 50, -48, 0, 1ll << 45, 1ll << 50, true, 1ll << 51},                    // slivers
    {1ll << 40, -58, 0, 1ll << 39, 1ll << 42, false, 1ll << 41},                   // micrometres
    {1ll << 40, -24, 0, 1ll << 34, 1ll << 39, false, 1ll << 41},                   // kilometres
}};

class Queries {
public:
    explicit Queries(std::uint64_t seed) : random_(seed) {}

    void next_family() { family_ = &families[static_cast<std::size_t>(random_.between(0, families.size() - 1))]; }

    double metres(std::int64_t steps) const { return static_cast<double>(steps) * power_of_two(family_->exponent); }

    double radius() { return metres(random_.between(family_->smallest, family_->largest)); }

    surefoot::dvec3 position() {
        const Steps steps = anywhere(family_->span);
        return point(steps);
    }

    surefoot::Motion motion() {
        const Steps from = anywhere(family_->span);
        Steps to = anywhere(family_->span);
        switch (random_.between(0, 7)) {
            case 0:
                to = from;
                break;  // standing still
            case 1:
                to = {from[0], to[1], from[2]};
                break;  // along one axis
            case 2:
                to = {to[0], from[1], to[2]};
                break;  // within one plane
            default:
                break;
        }
        return {point(from), point(to)};
    }

    surefoot::Triangle triangle() {
        const Steps a = anywhere(family_->span);
        Steps b = near(a);
        Steps c = near(a);
        if (family_->flat) {
            switch (random_.between(0, 3)) {
                case 0:
                    c = b;
                    break;
                case 1:
                    b = c = a;
                    break;
                case 2:
                    c = {2 * b[0] - a[0], 2 * b[1] - a[1], 2 * b[2] - a[2]};
                    break;
                default:
                    c = {b[0] + random_.between(-1, 1), b[1] + random_.between(-1, 1), b[2]};
                    break;
            }
        } else if (random_.between(0, 3) == 0) {
            b[1] = c[1] = a[1];  // a level floor
        }
        return {point(a), point(b), point(c)};
    }

    surefoot::dquat orientation() {
        const auto component = [this](std::int64_t limit, int exponent) {
            return static_cast<double>(random_.between(-limit, limit)) * power_of_two(exponent);
        };
        switch (random_.between(0, 3)) {
            case 0:
                return {static_cast<double>(random_.between(1, 3)), component(3, 0), component(3, 0), component(3, 0)};
            case 1:
                return {component(1ll << 50, -50), component(1ll << 50, -50), component(1ll << 50, -50), 0.5};
            default:
                return {1, 0, 0, 0};
        }
    }

    // `kind` is the index of the shape in surefoot::Shape.
    surefoot::Volume volume(std::size_t kind) {
        const surefoot::dquat turned = orientation();
        const double a = radius();
        const double b = radius();
        const double c = radius();
        switch (kind) {
            case 0:
                return {surefoot::Sphere{.radius = a}, turned};
            case 1:
                return {surefoot::Ellipsoid{.radii = {a, b, c}}, turned};
            case 2:
                return {surefoot::Capsule{.radius = a, .half_height = b}, turned};
            case 3:
                return {surefoot::Box{.half_extents = {a, b, c}}, turned};
            case 4:
                return {surefoot::Cylinder{.radius = a, .half_height = b}, turned};
            default:
                return {surefoot::Cone{.radius = a, .height = b}, turned};
        }
    }

    bool coin() { return random_.between(0, 1) == 1; }
    Random& random() { return random_; }

private:
    using Steps = std::array<std::int64_t, 3>;

    Steps anywhere(std::int64_t span) {
        const std::int64_t x = random_.between(-span, span);
        const std::int64_t y = random_.between(-span, span);
        return {x, y, random_.between(-span, span)};
    }

    Steps near(const Steps& centre) {
        const Steps arm = anywhere(family_->largest_arm);
        return {centre[0] + arm[0], centre[1] + arm[1], centre[2] + arm[2]};
    }

    surefoot::dvec3 point(const Steps& steps) const {
        return {metres(steps[0] + family_->offset), metres(steps[1]), metres(steps[2])};
    }

    Random random_;
    const Family* family_ = families.data();
};

}  // namespace golden
