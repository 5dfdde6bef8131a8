#include "debugger/side_by_side.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace surefoot::debugger {

namespace {

constexpr double width = 3;  ///< half the width of floors and stairs [m]

/// A rectangle from `a`, along x and y, as wide as everything; its front to the left of that direction.
void add_strip(std::vector<Triangle>& triangles, const dvec3& a, const dvec3& b, double half) {
    const dvec3 near(0, 0, half);
    triangles.push_back({a + near, b + near, b - near});
    triangles.push_back({a + near, b - near, a - near});
}

CharacterState upright_at(const Shape& shape, double x, double foot) {
    CharacterState state;
    state.position = {x, foot - foot_of(shape), 0};
    return state;
}

struct StandOff {
    double tan;
    double cos;

    double operator()(const Sphere& s) const { return s.radius / cos - s.radius; }
    double operator()(const Ellipsoid& s) const {
        return std::sqrt(s.radii.x * s.radii.x * tan * tan + s.radii.y * s.radii.y) - s.radii.y;
    }
    double operator()(const Capsule& s) const { return s.radius / cos - s.radius; }
    double operator()(const Box& s) const { return s.half_extents.x * tan; }
    double operator()(const Cylinder& s) const { return s.radius * tan; }
    double operator()(const Cone& s) const { return std::max(0.0, s.radius * tan - s.height); }
};

struct Overhang {
    double sink;

    double operator()(const Sphere& s) const { return of_circle(s.radius); }
    double operator()(const Ellipsoid& s) const {
        const double left = 1 - sink / s.radii.y;
        return s.radii.x * std::sqrt(1 - left * left);
    }
    double operator()(const Capsule& s) const { return of_circle(s.radius); }
    double operator()(const Box& s) const { return s.half_extents.x; }
    double operator()(const Cylinder& s) const { return s.radius; }
    double operator()(const Cone& s) const { return sink * s.radius / s.height; }

private:
    [[nodiscard]] double of_circle(double radius) const {
        return std::sqrt(radius * radius - (radius - sink) * (radius - sink));
    }
};

}  // namespace

std::array<Contestant, 5> contestants(double half_width, double half_height) {
    const dvec3 half(half_width, half_height, half_width);
    return {{{"box", Box{half}},
             {"cylinder", Cylinder{half_width, half_height}},
             {"cone", Cone{half_width, 2 * half_height}},
             {"ellipsoid", Ellipsoid{half}},
             {"capsule", Capsule{half_width, half_height - half_width}}}};
}

double foot_of(const Shape& shape) {
    struct Foot {
        double operator()(const Sphere& s) const { return -s.radius; }
        double operator()(const Ellipsoid& s) const { return -s.radii.y; }
        double operator()(const Capsule& s) const { return -s.half_height - s.radius; }
        double operator()(const Box& s) const { return -s.half_extents.y; }
        double operator()(const Cylinder& s) const { return -s.half_height; }
        double operator()(const Cone&) const { return 0; }
    };
    return std::visit(Foot{}, shape);
}

CharacterSettings walker(const Shape& shape) {
    CharacterSettings settings;
    settings.volume = shape;
    return settings;
}

std::vector<CharacterState> track(const World& world, const CharacterSettings& settings, const CharacterState& start,
                                  const dvec3& wish, int ticks) {
    std::vector<CharacterState> places{start};
    for (int i = 0; i < ticks; ++i)
        places.push_back(step(world, settings, {.wish = wish}, contest_tick, places.back()).state);
    return places;
}

std::vector<Triangle> slope(double angle) {
    std::vector<Triangle> triangles;
    const dvec3 far(40 * std::cos(angle), 40 * std::sin(angle), 0);
    add_strip(triangles, -far, far, 40);
    return triangles;
}

double stand_off(const Shape& shape, double angle) {
    return std::visit(StandOff{std::tan(angle), std::cos(angle)}, shape);
}

SlopeReading read_slope(const Shape& shape, double angle, int ticks) {
    const Arena arena(slope(angle));
    CharacterSettings settings = walker(shape);
    settings.slope_limit_deg = lesson_slope_limit_deg;
    const CharacterState above = upright_at(shape, 0, stand_off(shape, angle) + 0.5);
    const CharacterState rests = track(arena.world(), settings, above, {0, 0, 0}, ticks).back();
    SlopeReading reading;
    reading.landed = rests.footing == Footing::ground;
    reading.position = rests.position;
    const dvec3 foot = reading.position + dvec3(0, foot_of(shape), 0);
    reading.gap = arena.drop(foot, 100).value_or(0);
    // Straight against the slope, as far as it goes: that is how far they are apart.
    const dvec3 against(std::sin(angle), -std::cos(angle), 0);
    if (const auto hit = arena.sweep(shape, {reading.position, reading.position + against}))
        reading.clearance = hit->t * glm::length(against);
    reading.expected = stand_off(shape, angle) + reading.clearance / std::cos(angle);
    return reading;
}

std::vector<Triangle> stairs(const Stairs& stairs) {
    std::vector<Triangle> triangles;
    add_strip(triangles, {-6, 0, 0}, {0, 0, 0}, width);
    dvec3 at(0, 0, 0);
    for (int i = 0; i < stairs.count; ++i) {
        const dvec3 up = at + dvec3(0, stairs.rise, 0);
        const dvec3 next = up + dvec3(i + 1 == stairs.count ? 6 : stairs.run, 0, 0);
        add_strip(triangles, at, up, width);
        add_strip(triangles, up, next, width);
        at = next;
    }
    return triangles;
}

StairsReading read_stairs(const Shape& shape, const Stairs& which, double speed, int ticks) {
    const CharacterSettings settings = walker(shape);
    const Arena arena(stairs(which));
    StairsReading reading;
    reading.places = track(arena.world(), settings, upright_at(shape, -1.5, settings.skin), {speed, 0, 0}, ticks);
    for (const CharacterState& state : reading.places)
        reading.climbed = std::max(reading.climbed, state.position.y + foot_of(shape));
    reading.reached = reading.places.back().position.x;
    return reading;
}

std::vector<Triangle> ledge() {
    std::vector<Triangle> triangles;
    add_strip(triangles, {-6, 0, 0}, {0, 0, 0}, width);
    add_strip(triangles, {0, 0, 0}, {0, -3, 0}, width);
    add_strip(triangles, {0, -3, 0}, {8, -3, 0}, width);
    return triangles;
}

double overhang(const Shape& shape, double sink) {
    return std::visit(Overhang{sink}, shape);
}

LedgeReading read_ledge(const Shape& shape, double sink, double speed, int ticks) {
    const CharacterSettings settings = walker(shape);
    const Arena arena(ledge());
    LedgeReading reading;
    reading.places = track(arena.world(), settings, upright_at(shape, -1, settings.skin), {speed, 0, 0}, ticks);
    const auto sunk = [&](const CharacterState& state) { return state.position.y + foot_of(shape) <= -sink; };
    const auto first = std::find_if(reading.places.begin(), reading.places.end(), sunk);
    if (first != reading.places.end()) reading.overhang = first->position.x;
    return reading;
}

}  // namespace surefoot::debugger
